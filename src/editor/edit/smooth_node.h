/*
 * Smooth nodes: knots of multiplicity p, where the curve goes through a control point between two handles, and turns
 * by less than 3.4 degrees. Outlines from files have them: smooth to the eye, corners by their rounding.
 */
#ifndef BATTEN_EDITOR_EDIT_SMOOTH_NODE_H
#define BATTEN_EDITOR_EDIT_SMOOTH_NODE_H

#include <batten/curve.h>

typedef struct bat_smooth_node {
    int in, on, out; /* control points */
    double u;        /* its knot */
    double ratio;    /* length of the handle out over that of the handle in */
} bat_smooth_node;

/* Whether control point `on` of a planar curve is a smooth node; degree 2 and above. */
bool bat_smooth_node_at(const bat_curve *curve, int on, bat_smooth_node *node);
/* Whether it is a smooth node or, from degree 3 on, a handle of one: the node's points. */
bool bat_smooth_node_of(const bat_curve *curve, int point, bat_smooth_node *node);

#endif
