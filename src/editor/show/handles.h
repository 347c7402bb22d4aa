/*
 * Handles: the parts of a curve that can be grabbed (control points, knots, any point on it), where they are and how
 * they look. Each distinct knot of a closed curve counts once; the ends of an open one are not handles.
 */
#ifndef BATTEN_EDITOR_SHOW_HANDLES_H
#define BATTEN_EDITOR_SHOW_HANDLES_H

#include "editor/show/overlay.h"
#include "editor/view/stage.h"

typedef enum bat_handle_kind {
    BAT_HANDLE_NONE,
    BAT_HANDLE_POINT, /* a control point */
    BAT_HANDLE_KNOT,
    BAT_HANDLE_CURVE /* a point on the curve */
} bat_handle_kind;

typedef struct bat_handle {
    bat_handle_kind kind;
    bat_id object;
    int curve;
    int index; /* POINT */
    double u;  /* KNOT, CURVE; POINT: its Greville abscissa */
} bat_handle;

/* The next distinct knot above `after` (-INFINITY: the first) that can be a handle; false: there is none. Closed:
 * within the domain, without its end. *multiplicity may be NULL. */
bool bat_knot_next(const bat_curve *curve, double after, double *u, int *multiplicity);
/* How many times u can be removed: its multiplicity if it is a handle, otherwise 0. */
int bat_knot_held(const bat_curve *curve, double u);
/* The knot nearest to u; false when the curve has none. */
bool bat_knot_near(const bat_curve *curve, double u, double *knot);

/* The control point or knot of the curve that is seen nearest to the point (drawing coordinates) and within `reach`; among
 * equals the control point. Sets kind, index and u of *out. */
bool bat_handle_find(const bat_curve *curve, const bat_stage *stage, const double point[2], double reach,
                     bat_handle *out);
/* The Greville abscissa of a control point: the mean of its p inner knots. */
double bat_handle_greville(const bat_curve *curve, int index);
/* The stretch that changes when the curve is pulled at u: the support of the basis functions there. */
void bat_knots_reached(const bat_curve *curve, double u, double range[2]);
/* Where it is, of the curve's dimension; where it is seen, in drawing coordinates. */
void bat_handle_place(const bat_curve *curve, const bat_handle *handle, double *out);
void bat_handle_seen(const bat_curve *curve, const bat_stage *stage, const bat_handle *handle, double at[2]);

/* Knots as diamonds, with one ring for each further multiplicity; the ends of open curves as bars across. */
void bat_handles_show_knots(bat_overlay *overlay, const bat_curve *curve, const bat_stage *stage);
/* Control polygon and control points. */
void bat_handles_show_points(bat_overlay *overlay, const bat_curve *curve, const bat_stage *stage);
/* One handle, enlarged. */
void bat_handles_show_one(bat_overlay *overlay, const bat_curve *curve, const bat_handle *handle,
                          bat_role role, const bat_stage *stage);

#endif
