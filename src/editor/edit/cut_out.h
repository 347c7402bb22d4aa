/* What an eraser takes away: stretches of curves, collected while it moves, cut out in the end. */
#ifndef BATTEN_EDITOR_EDIT_CUT_OUT_H
#define BATTEN_EDITOR_EDIT_CUT_OUT_H

#include <batten/document.h>
#include <batten/editor.h>

/* Stretches of one curve: ascending, apart, within the domain. */
typedef struct bat_spans {
    double (*list)[2];
    int count, room;
} bat_spans;

void bat_spans_free(bat_spans *spans);
/* Adds u0..u1, joined with what it meets. BAT_MEMORY: nothing added. */
bat_status bat_spans_add(bat_spans *spans, double u0, double u1);
/* Whether the box of the planar curve's control points is within reach of the segment a b. */
bool bat_spans_near(const bat_curve *curve, const double a[2], const double b[2], double radius);
/* Adds the stretches of the planar curve whose distance to the segment a b is below radius. The ends are exact to
 * rounding; a stretch shorter than about a tenth of the radius along the curve may be missed. */
bat_status bat_spans_erase(bat_spans *spans, const bat_curve *curve, const double a[2], const double b[2],
                           double radius);
/* What is left of the curve without the spans, pieces shorter than `least` left out: *pieces malloc'ed curves in an
 * array to be freed with them. A closed curve opens. */
bat_status bat_spans_rest(const bat_spans *spans, const bat_curve *curve, double least, bat_curve ***pieces,
                          int *count);

#endif
