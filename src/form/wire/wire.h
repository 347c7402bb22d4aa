/* Internal to wires: what is bound. */
#ifndef BATTEN_FORM_WIRE_H
#define BATTEN_FORM_WIRE_H

#include "form/wire/turner.h"

#include <batten/nearest.h>
#include <batten/wires.h>

/* A point that feels a wire. */
typedef struct bat_influence {
    double at;         /* p: the parameter of the closest point of the reference */
    double strength;   /* F */
    double share;      /* of the wire's movement; with the magnitude blend not used */
    double stretch;    /* (s - 1) F */
    vec away, tangent; /* P - R(p), R'(p) */
    int slot;          /* which of the points within reach */
    int sum;           /* which of those that feel several wires; -1: it feels this one only */
    int span;          /* which of the reference's spans p is in */
    bool on;           /* it lies on the wire */
} bat_influence;

typedef struct bat_bound_wire {
    bat_curve *reference; /* in space */
    bat_finder *finder;   /* of the reference */
    double rounding;      /* of the reference's coordinates */
    size_t count;
    bat_wire_turn turn;
    bat_wire_frames frames;    /* of turns by frames: with one for each influence */
    bat_influence *influences; /* by span, then in the order of the points: memory is written in order */
} bat_bound_wire;

struct bat_binding {
    bat_wire_options options;
    size_t wire_count, point_count, slot_count, sum_count;
    bat_bound_wire *wires;
    int *points;  /* of each slot */
    double *rest; /* 3 numbers a slot: where the point was bound */
};

/* The next knot of a curve after u, or the end. at: where the search goes on, at first 0. */
double bat_wire_next_knot(const bat_curve *curve, double u, double end, int *at);
/* x to the power of k, for x from 0 to 1. */
double bat_wire_power(double x, double k);

#endif
