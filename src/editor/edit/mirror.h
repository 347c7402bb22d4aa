/*
 * Symmetry: what a step changes on one side of the axis is changed on the other, within the same step. Nothing is stored of
 * what belongs together: a curve's twin is the curve that lies where its mirror image lies, within a pixel.
 */
#ifndef BATTEN_EDITOR_EDIT_MIRROR_H
#define BATTEN_EDITOR_EDIT_MIRROR_H

#include "curve/mirror.h"
#include "editor/session/context.h"

/* The axis in force: that of the session, else upright through the middle of the page; without a page through the middle
 * of the drawing, or of the window when it is empty, and kept for the session from then on. Off: symmetry is off, or the
 * pen draws on something else than the page. */
bat_mirror bat_symmetry(bat_context *c);
/* Chooses the axis, in the journal too. Off: that of the page again. */
bat_status bat_symmetry_set(bat_context *c, const bat_mirror *axis);

/*
 * Mirrors what the open transaction has changed so far. pixel: its length in document units.
 * - A new curve: it and its image become one when it crosses the axis or ends at it (bat_mirror_whole), else the image is
 *   added in front of it.
 * - A changed curve that had a twin: the twin becomes the image, or one with the curve.
 * - A changed curve that was its own image: the side that was changed more is taken for both.
 * - A curve that is gone: its twin goes, too.
 * A curve with no twin is all that changes, and what is hidden or locked stays as it is.
 */
bat_status bat_mirror_changes(bat_context *c, const bat_mirror *mirror, double pixel, double tolerance);

#endif
