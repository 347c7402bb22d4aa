/*
 * Symmetry: what a step changes on one side of the axis is changed on the other, within the same step. Nothing is stored of
 * what belongs together: a curve's twin is the curve that lies where its mirror image lies, within a pixel.
 */
#ifndef BATTEN_EDITOR_EDIT_MIRROR_H
#define BATTEN_EDITOR_EDIT_MIRROR_H

#include "curve/mirror.h"
#include "editor/session/context.h"

/* What is mirrored; bits. */
enum {
    BAT_MIRROR_TWINS = 1, /* a changed curve that had a twin: the twin becomes its image */
    BAT_MIRROR_OWN =
        2, /* a changed curve that was its own image: the side that changed more is taken for both */
    BAT_MIRROR_FRESH = 4, /* a new object: its image is added in front of it, unless it is its own */
    BAT_MIRROR_JOIN =
        8, /* with these: what crosses the axis or ends at it is one with its image (bat_mirror_whole) */
    BAT_MIRROR_GONE = 16,   /* an object that is gone: its twin goes, too */
    BAT_MIRROR_PIECES = 32, /* an object followed by new ones has been cut into these */
    BAT_MIRROR_STROKE = BAT_MIRROR_TWINS | BAT_MIRROR_OWN | BAT_MIRROR_FRESH | BAT_MIRROR_JOIN |
                        BAT_MIRROR_GONE
};

/* Mirrors what the open transaction has changed so far. pixel: its length in document units. A curve with no twin is all
 * that changes, and what is hidden or locked stays as it is. */
bat_status bat_mirror_changes(bat_context *c, const bat_mirror *mirror, unsigned ways, double pixel,
                              double tolerance);
/* What a curve on the other side of the axis would be, once a stroke has made `after` of `before` (NULL: of nothing):
 * its image, or the whole that it becomes. BAT_STATE: nothing changes there. */
bat_status bat_mirror_preview(bat_context *c, const bat_mirror *mirror, double pixel, double tolerance,
                              const bat_curve *before, const bat_curve *after, bat_curve **out);

#endif
