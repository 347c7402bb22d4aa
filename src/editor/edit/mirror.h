/*
 * Symmetry: what a step changes on one side of the axis is changed on the other within the same step. No pairing is
 * stored: a curve's twin is the curve that lies within a pixel of its mirror image.
 */
#ifndef BATTEN_EDITOR_EDIT_MIRROR_H
#define BATTEN_EDITOR_EDIT_MIRROR_H

#include "curve/mirror.h"
#include "editor/session/context.h"

/* What is mirrored: bits. */
enum {
    BAT_MIRROR_TWINS = 1, /* a changed curve that had a twin: the twin becomes its image */
    BAT_MIRROR_OWN =
        2, /* a changed curve that was its own image: the side that changed more decides for both */
    BAT_MIRROR_FRESH = 4, /* a new object: its image is added in front of it, unless it is its own image */
    BAT_MIRROR_JOIN =
        8, /* with these: what crosses or ends at the axis is merged with its image (bat_mirror_whole) */
    BAT_MIRROR_GONE = 16,   /* a removed object: its twin is removed too */
    BAT_MIRROR_PIECES = 32, /* an object followed by new ones has been cut into them */
    BAT_MIRROR_STROKE = BAT_MIRROR_TWINS | BAT_MIRROR_OWN | BAT_MIRROR_FRESH | BAT_MIRROR_JOIN |
                        BAT_MIRROR_GONE
};

/* Mirrors what the open transaction has changed so far. pixel: the length of a view pixel in document units. A curve
 * without a twin changes alone; what is hidden or locked does not change. */
bat_status bat_mirror_changes(bat_context *c, const bat_mirror *mirror, unsigned ways, double pixel,
                              double tolerance);
/* The future curve on the other side of the axis once a stroke has turned `before` (NULL: nothing) into `after`: its
 * image, or the whole curve that both become. BAT_STATE: nothing changes there. */
bat_status bat_mirror_preview(bat_context *c, const bat_mirror *mirror, double pixel, double tolerance,
                              const bat_curve *before, const bat_curve *after, bat_curve **out);
/* The object and the number of the curve that is the image of the object's curve, which may be itself; 0: none. */
bat_id bat_mirror_twin(bat_context *c, const bat_mirror *mirror, double pixel, bat_id object, int curve,
                       int *out);

#endif
