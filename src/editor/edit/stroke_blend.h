/* A stroke from an end of one curve to an end of another, or between the ends of one, taken as a blend of them. */
#ifndef BATTEN_EDITOR_EDIT_STROKE_BLEND_H
#define BATTEN_EDITOR_EDIT_STROKE_BLEND_H

#include <batten/sketch.h>

/* The blend (batten/blend.h), with G2, between the ends that the stroke leads from and to, with those tensions of a few that bring it nearest
 * to the stroke. a and b may be one curve. BAT_ARGUMENT: one is closed. */
bat_status bat_edit_blend(const bat_curve *a, const bat_curve *b, const bat_stroke *stroke, bat_curve **out);

#endif
