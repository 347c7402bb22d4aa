/* Inside the sketch hand: hooks and corners of a stroke, measured by the size of what is drawn (docs/math sketch 5.2). */
#ifndef BATTEN_HANDS_SKETCH_CORNERS_H
#define BATTEN_HANDS_SKETCH_CORNERS_H

#include "hands/sketch/path.h"

/* How small the drawing is: the median length within which the stroke comes to run back; at most `most`.
 * sigma: noise. */
double bat_path_grain(const bat_stroke_path *path, double sigma, double most);
/* How much of an end is a hook of the pen that lands or lifts: the arc length after its last sharp turn. */
double bat_hook(const bat_stroke_path *path, double grain, bool at_end);
/* Sample indices of corners, `most` at most: the sharpest of each run of sharp turns. */
size_t bat_corners(const bat_stroke_path *path, double sigma, double grain, size_t most, size_t *corners);

#endif
