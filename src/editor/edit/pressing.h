/* The pen's pressure as the width along the line that it drew: from where it began, by arc length, whichever way it went. */
#ifndef BATTEN_EDITOR_EDIT_PRESSING_H
#define BATTEN_EDITOR_EDIT_PRESSING_H

#include "editor/input/samples.h"
#include <batten/width.h>

/* PARTS: of the line, by which the pressure is told; each end is feathered by one stop more. */
enum { BAT_PRESSED_PARTS = 16, BAT_PRESSED_STOPS = BAT_PRESSED_PARTS + 3, BAT_PRESSED_PLACES = 128 };

/* A line, and the pressure of the strokes that it was made of. */
typedef struct bat_pressing {
    bool closed, varies; /* varies: some stroke was not pressed evenly */
    double length;
    double place[BAT_PRESSED_PLACES + 1][2]; /* at even lengths; document units */
    double sum[BAT_PRESSED_PARTS + 1], strokes[BAT_PRESSED_PARTS + 1];
} bat_pressing;

/* An open line through so many points, or a planar curve. False: it has no length, or is not planar. */
bool bat_pressing_line(bat_pressing *pressing, size_t count, const double *points);
bool bat_pressing_curve(bat_pressing *pressing, const bat_curve *curve);
/* One of its strokes, in either direction, along all of it or a part. On the page, otherwise nothing is done. O(samples). */
void bat_pressing_add(bat_pressing *pressing, const bat_samples *samples);
/* Each place as wide as the mean of the strokes there: half the pressure is the whole width. Open ends run out to a point over
 * FEATHER widths of the line, document units; with no stop more than what is seen needs. 0: all were pressed evenly. */
size_t bat_pressing_stops(const bat_pressing *pressing, double width,
                          bat_width_stop stops[BAT_PRESSED_STOPS]);

#endif
