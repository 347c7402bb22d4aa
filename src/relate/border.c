#include "base/real.h"
#include "relate/widen.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CUBICS_MAX = 1 << 18, ARC_MAX = 64 };

void bat_border_move(bat_border *border, const double to[2]) {
    memcpy(border->at, to, sizeof border->at);
    border->begun = true;
}

void bat_border_cubic(bat_border *border, const double cubic[8]) {
    if (border->status != BAT_OK) return;
    if (border->count == border->room) {
        const size_t room = 2 * border->room + 32;
        double *more = border->room < CUBICS_MAX ? realloc(border->points, 8 * room * sizeof *more) : NULL;
        if (!more) {
            border->status = border->room < CUBICS_MAX ? BAT_MEMORY : BAT_COUNT;
            return;
        }
        border->points = more, border->room = room;
    }
    double *at = border->points + 8 * border->count++;
    memcpy(at, cubic, 8 * sizeof *at);
    if (border->begun) memcpy(at, border->at, sizeof border->at); /* no gap by rounding */
    bat_border_move(border, at + 6);
}

void bat_border_line(bat_border *border, const double to[2]) {
    double cubic[8];
    if (!border->begun) bat_border_move(border, to);
    if (border->at[0] == to[0] && border->at[1] == to[1]) return;
    for (int c = 0; c < 2; c++) {
        cubic[c] = border->at[c], cubic[6 + c] = to[c];
        cubic[2 + c] = cubic[c] + (to[c] - cubic[c]) / 3, cubic[4 + c] = to[c] - (to[c] - cubic[c]) / 3;
    }
    bat_border_cubic(border, cubic);
}

/* A cubic of an angle w is w^6 / 18,000 radii away from its circle at most. */
void bat_border_arc(bat_border *border, const double centre[2], double angle, double tolerance) {
    const double from[2] = {border->at[0] - centre[0], border->at[1] - centre[1]};
    const double radius = bat_hypot(from[0], from[1]);
    int n = 1;
    for (; n < ARC_MAX; n++) {
        const double square = angle / n * (angle / n);
        if (square <= 0.25 * BAT_PI * BAT_PI && radius * square * square * square <= 18000 * tolerance) break;
    }
    const double handle = 4.0 / 3 * bat_tan(0.25 * angle / n);
    for (int k = 0; k < n && radius > 0; k++) {
        double cubic[8], d[2][2];
        for (int e = 0; e < 2; e++) {
            const double turn = angle * (k + e) / n, x = bat_cos(turn), y = bat_sin(turn);
            d[e][0] = from[0] * x - from[1] * y, d[e][1] = from[0] * y + from[1] * x;
            for (int c = 0; c < 2; c++) cubic[6 * e + c] = centre[c] + d[e][c];
        }
        cubic[2] = cubic[0] - handle * d[0][1], cubic[3] = cubic[1] + handle * d[0][0];
        cubic[4] = cubic[6] + handle * d[1][1], cubic[5] = cubic[7] - handle * d[1][0];
        bat_border_cubic(border, cubic);
    }
}

void bat_border_append(bat_border *border, const bat_border *other, bool reversed) {
    if (border->status == BAT_OK) border->status = other->status;
    for (size_t i = 0; i < other->count && border->status == BAT_OK; i++) {
        const double *from = other->points + 8 * (reversed ? other->count - 1 - i : i);
        double cubic[8];
        if (i > 0) { /* a new chain */
            const double *joint = from + (reversed ? 6 : 0), *last = from + (reversed ? 8 : -2);
            if (joint[0] != last[0] || joint[1] != last[1]) border->begun = false;
        }
        for (int k = 0; k < 4; k++)
            memcpy(cubic + 2 * k, from + 2 * (reversed ? 3 - k : k), 2 * sizeof *from);
        bat_border_cubic(border, cubic);
    }
}

void bat_border_free(bat_border *border) {
    free(border->points);
    *border = (bat_border){0};
}
