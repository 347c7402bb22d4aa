/*
 * A small picture of a level, for its row in the level strip: SVG path data in a box of BAT_LEVEL_WIDE by BAT_LEVEL_HIGH. The sweep
 * is seen in its shape, a detail as a wave along the curve: how far it goes to the side, times its gain. With gain 1 a wave fills
 * half of the height, whatever its size, unless it is too small to be seen.
 */
#ifndef BATTEN_EDITOR_PANELS_LEVEL_PICTURE_H
#define BATTEN_EDITOR_PANELS_LEVEL_PICTURE_H

#include "editor/tools/levels/ladder.h"
#include "text/text.h"

enum { BAT_LEVEL_WIDE = 32, BAT_LEVEL_HIGH = 20 };

/* Of a level of a curve, or of a surface: there at each place along it the detail that is farthest from 0. O(points). Out of
 * memory: text->failed. */
void bat_level_picture(bat_text *text, bat_ladder ladder, int level);
/* Of values at even places; size: what they are measured against, to tell whether they can be seen. A gain of 0 is a flat line. */
void bat_level_wave(bat_text *text, size_t count, const double *values, double size, double gain);
/* The same on a floor of 0: what the values are, not how they differ. */
void bat_level_hill(bat_text *text, size_t count, const double *values);

#endif
