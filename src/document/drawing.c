/* SVG files that stand alone as pictures: their start tag, and where they lie. */
#include "document/picture.h"
#include "text/number.h"
#include "text/text.h"

#include <math.h>

enum { SIDE = 512 };

static const char HEAD[] = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", HEIGHT[] = "\" height=\"",
                  VIEW[] = "\" viewBox=\"";

void bat_drawing_head(const double sides[2], const double view[4], bat_text *out) {
    bat_text_string(out, HEAD);
    bat_text_integer(out, (uint64_t)sides[0]);
    bat_text_string(out, HEIGHT);
    bat_text_integer(out, (uint64_t)sides[1]);
    bat_text_string(out, VIEW);
    for (int i = 0; i < 4; i++) {
        if (i > 0) bat_text_string(out, " ");
        bat_text_number(out, view[i]);
    }
    bat_text_string(out, "\">");
}

bool bat_drawing_open(const double box[4], bat_text *out) {
    const double width = box[2] - box[0], height = box[3] - box[1];
    int power;
    if (!(width > 0 && height > 0 && width < 1e30 && height < 1e30)) return false;
    frexp(SIDE / fmax(width, height), &power);
    const double scale = ldexp(1, power - 1),
                 sides[2] = {fmax(1, ceil(width * scale)), fmax(1, ceil(height * scale))};
    bat_drawing_head(sides, (double[4]){box[0], box[1], sides[0] / scale, sides[1] / scale}, out);
    return true;
}

void bat_drawing_sides(double width, double height, uint32_t sides[2]) {
    int power;
    frexp(SIDE / fmax(width, height), &power);
    sides[0] = (uint32_t)fmax(1, floor(ldexp(width, power - 1) + 0.5));
    sides[1] = (uint32_t)fmax(1, floor(ldexp(height, power - 1) + 0.5));
}

bool bat_drawing_matrix(const bat_picture *picture, double m[6]) {
    size_t size;
    const char *text = bat_picture_bytes(picture, &size), *end = text + size;
    double sides[2], view[4];
    bat_picture_sides(picture, sides);
    if (!bat_picture_is_drawing(picture)) return false;
    const char *at = text + sizeof HEAD - 1;
    for (int quotes = 0; at < end && quotes < 4; at++) quotes += *at == '"';
    for (int i = 0; i < 4; i++) {
        while (at < end && *at == ' ') at++;
        at = at < end ? bat_number_scan(at, end, &view[i]) : NULL;
        if (!at) return false;
    }
    const double made[6] = {view[2] / sides[0], 0, 0, view[3] / sides[1], view[0], view[1]};
    for (int i = 0; i < 6; i++) m[i] = made[i];
    return view[2] > 0 && view[3] > 0;
}
