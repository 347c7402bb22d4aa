/* Internal to formats: a plane outline as triangles. */
#ifndef BATTEN_FORMAT_FILL_H
#define BATTEN_FORMAT_FILL_H

#include <batten/base.h>

enum { BAT_FILL_MOST = 4096 }; /* corners of an outline that no one place sees all of */

/*
 * Divides an outline of count corners (3 or more), anticlockwise, 2 numbers each, into triangles that have area and use
 * every corner, also where corners lie on a line. next: room for count; triangles: for 3 * count; vertex `count` is
 * *middle. False: the
 * outline crosses or touches itself, or has over BAT_FILL_MOST corners and no place that sees all. O(count) where the middle
 * sees all, else O(count squared) as a rule.
 */
bool bat_fill(size_t count, const double *corners, int *next, int *triangles, size_t *triangle_count,
              double middle[2]);

#endif
