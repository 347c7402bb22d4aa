/* What an eraser takes away: spans of curves, collected while it moves and cut out at the end. */
#ifndef BATTEN_EDITOR_EDIT_CUT_OUT_H
#define BATTEN_EDITOR_EDIT_CUT_OUT_H

#include <batten/document.h>
#include <batten/editor.h>

/* Spans of one curve: ascending, disjoint, within the domain. */
typedef struct bat_spans {
    double (*list)[2];
    int count, room;
} bat_spans;

void bat_spans_free(bat_spans *spans);
/* Adds u0..u1, merged with the spans it meets. BAT_MEMORY: nothing added. */
bat_status bat_spans_add(bat_spans *spans, double u0, double u1);
/* Whether the box of the planar curve's control points is within reach of the segment ab. */
bool bat_spans_near(const bat_curve *curve, const double a[2], const double b[2], double radius);
/* Adds the spans of the planar curve that are closer to the segment ab than radius. Their ends are exact to rounding;
 * a span shorter than about a tenth of the radius along the curve may be missed. */
bat_status bat_spans_erase(bat_spans *spans, const bat_curve *curve, const double a[2], const double b[2],
                           double radius);
/* What is left of the curve without the spans, except pieces shorter than `least`: *pieces is an allocated array of
 * curves; the caller frees the array and the curves. A closed curve opens. */
bat_status bat_spans_rest(const bat_spans *spans, const bat_curve *curve, double least, bat_curve ***pieces,
                          int *count);

#endif
