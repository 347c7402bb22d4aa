/* Internal: a curve gets its height above the page from a stroke in a second view. */
#ifndef BATTEN_FORM_LIFT_H
#define BATTEN_FORM_LIFT_H

#include <batten/view.h>

/*
 * The stroke, in pixels of the view, is cast on the ruled surface that stands on the curve along z (bat_cast); the curve
 * follows it in z where the stroke runs, and keeps its x y everywhere: knots are inserted where the tolerance needs them,
 * which does not change it. out: of dimension 3. *dropped: samples that met no surface. BAT_DOT: fewer than two samples
 * landed; BAT_FAR: over a third did not; BAT_COUNT: too many knots; else as bat_cast.
 * tolerance: what heights may differ by in the mean of squares.
 */
bat_status bat_lift(const bat_viewpoint *view, const bat_stroke *stroke, const bat_curve *curve,
                    double tolerance, bat_curve **out, size_t *dropped);

#endif
