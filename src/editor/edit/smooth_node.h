/*
 * Smooth nodes: knots of multiplicity p, where the curve passes through a control point between two handles and turns
 * by less than 3.4 degrees. Outlines from files have them: smooth to the eye, but corners by rounding.
 */
#ifndef BATTEN_EDITOR_EDIT_SMOOTH_NODE_H
#define BATTEN_EDITOR_EDIT_SMOOTH_NODE_H

#include <batten/curve.h>

typedef struct bat_smooth_node {
    int in, on, out; /* control points */
    double u;        /* knot at the node */
    double ratio;    /* length of the outgoing handle over that of the incoming one */
} bat_smooth_node;

/* Whether control point `on` of a planar curve is a smooth node; degree 2 and above. */
bool bat_smooth_node_at(const bat_curve *curve, int on, bat_smooth_node *node);
/* Whether the point is a smooth node or, from degree 3 on, a handle of one; gives the node. */
bool bat_smooth_node_of(const bat_curve *curve, int point, bat_smooth_node *node);

#endif
