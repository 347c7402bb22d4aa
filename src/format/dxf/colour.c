/* AutoCAD's colours by number: nine that have names, 24 hues in five values and two saturations, six greys. */
#include "format/dxf/dxf.h"

#include <math.h>

enum { NAMED = 10, GREYS = 250, COLOURS = 256, HUES = 24 };

static uint32_t pack(double red, double green, double blue) {
    return (uint32_t)floor(red) << 24 | (uint32_t)floor(green) << 16 | (uint32_t)floor(blue) << 8 | 0xFF;
}

/* How much of a primary is in a hue of 24, 0 to 1: full for a third of the circle, and rising and falling by its sides. */
static double share(int hue, int primary) {
    const int away = ((hue - primary) % HUES + HUES) % HUES;
    const double steps = away <= HUES / 2 ? away : HUES - away;
    return fmin(fmax(2 - steps / 4, 0), 1);
}

uint32_t bat_dxf_colour(int index) {
    static const uint32_t named[NAMED] = {0x000000FF, 0xFF0000FF, 0xFFFF00FF, 0x00FF00FF, 0x00FFFFFF,
                                          0x0000FFFF, 0xFF00FFFF, 0x000000FF, 0x808080FF, 0xC0C0C0FF};
    static const double values[5] = {255, 204, 153, 127.5, 76.5};
    static const double greys[COLOURS - GREYS] = {51, 91, 132, 173, 214, 255};
    if (index < 0 || index >= COLOURS) return named[0];
    if (index < NAMED) return named[index];
    if (index >= GREYS) return pack(greys[index - GREYS], greys[index - GREYS], greys[index - GREYS]);
    const double value = values[index % 10 / 2], least = index % 2 ? 0.5 : 0;
    double primaries[3];
    for (int k = 0; k < 3; k++)
        primaries[k] = value * (least + (1 - least) * share(index / 10 - 1, k * HUES / 3));
    return pack(primaries[0], primaries[1], primaries[2]);
}

int bat_dxf_index_near(uint32_t colour) {
    int best = 7;
    double least = INFINITY;
    for (int i = 1; i < COLOURS; i++) {
        const uint32_t other = bat_dxf_colour(i);
        double away = 0;
        for (int k = 8; k < 32; k += 8) {
            const double apart = (double)(colour >> k & 0xFF) - (double)(other >> k & 0xFF);
            away += apart * apart;
        }
        if (away < least || (away == least && i == 7)) least = away, best = i;
    }
    return best;
}
