/* Internal: a curve gets its height above the page from a stroke in a second view. */
#ifndef BATTEN_FORM_LIFT_H
#define BATTEN_FORM_LIFT_H

#include <batten/view.h>

/*
 * The stroke, in pixels of the view, is cast on the ruled surface that stands on the curve along z (bat_lift_path); the curve
 * follows it in z where the stroke runs, and keeps its x y everywhere: knots are inserted where the tolerance needs them,
 * which does not change it. Where the surface turns away from the eye, as at the sides of a ring, the stroke goes on round
 * the bend; of the two closed curves that look so the more level one is meant. out: of dimension 3. *dropped: samples that
 * met no surface. BAT_DOT: fewer than two samples landed; BAT_FAR: over a third did not; else
 * as bat_cast. tolerance: what heights may differ by in the mean of squares, in each span. O(count), beside bat_lift_path.
 */
bat_status bat_lift(const bat_viewpoint *view, const bat_stroke *stroke, const bat_curve *curve,
                    double tolerance, bat_curve **out, size_t *dropped);
/* Whether two thirds of the ruled surface are seen at 5 degrees at least: a stroke can land on it. */
bool bat_lift_shows(const bat_viewpoint *view, const bat_curve *curve);

#endif
