/* Inside the sketch hand: one solve of the constrained least squares of an interval (docs/math sketch 5.7), and the
 * record that fits, fairing and the search of knots share. Lengths are pixels; the parameter w runs from 0 to `end`,
 * about a pixel of arc length a unit. */
#ifndef BATTEN_HANDS_SKETCH_MACHINE_H
#define BATTEN_HANDS_SKETCH_MACHINE_H

#include "curve/lsq.h"

/* How the fitted piece hangs on what lies beyond one end of the interval. */
typedef struct bat_local_side {
    int pins;                         /* control points given at this end: 0, 1 (a point) or p - 1, p */
    double outer[BAT_DEGREE_MAX + 1]; /* p knots, ascending, the end of the interval itself included */
    const bat_curve *curve;           /* kept piece: its blossom gives the pins; NULL when pins <= 1 */
    int span;                         /* its stored span next to the cut */
    double base, rate;                /* curve parameter at w: base + (w - at) / rate */
    double at;
    double point[BAT_DIMENSION_MAX]; /* pins == 1 */
} bat_local_side;

typedef struct bat_local_problem {
    int degree, dimension;
    bool closed; /* periodic, no sides */
    double end;
    size_t count;
    const double *w, *weight, *allowed, *law; /* law: the speed wanted, ds/dw */
    double *x; /* where a sample has no weight the close fit decides, and writes here where it went */
    size_t first, last; /* samples of the stroke proper: what max_error is about */
    bat_local_side side[2];
    int fixed_count;
    const double *fixed; /* corners: knots of multiplicity p that stay */
    double span;         /* length of the first spans */
    double wavelength;   /* shorter waves are not followed */
    bool spend;  /* the fairest curve with few knots within the tolerance; else a close fit with many */
    double tube; /* share of the allowed errors that may be spent */
} bat_local_problem;

/* Of the wanted speed, a fit may keep to. */
#define BAT_SLOWEST 0.6
#define BAT_FASTEST 1.7

typedef struct bat_knot_set {
    int count;
    double *w;
    unsigned char *fixed; /* corner copies: never moved nor removed */
} bat_knot_set;

/* The tolerance spent on fairness (fair.h): a number a sample, `dimension` of them for aim and change. */
enum { BAT_KNOT_LAWS = 3 };
typedef struct bat_fairing {
    double lambda;  /* weight of the change of curvature; 0: plain penalty, plain samples */
    double *weight; /* of samples; owns all arrays */
    double *bend;   /* squared curvature times squared speed */
    bool aimed;     /* solves aim at the fair curve */
    bool fresh;     /* weights or aim are not those of the last solve */
    double *aim;    /* where the fair curve lies */
    double *change; /* and how its curvature changes */
    double *jump;   /* and its fourth derivative, 1 in the mean */
    double *sums;   /* densities of knots, summed up: a number a sample and law */
    double *curvature, *spare;
    double least, peak; /* what an extremum must stand out by; the fair curve's greatest curvature */
    int extrema;        /* how many the fair curve has */
    int inflections;
    double calmest;   /* its sum of absolute changes of curvature */
    double variation; /* the last solve's */
} bat_fairing;

typedef struct bat_local_machine {
    const bat_local_problem *problem;
    int room; /* interior knots that fit in the arrays */
    struct bat_curve space;
    double *a, *b, *local, *factor, *border, *rank;
    bat_lsq_memo memo[2]; /* of the last solve, and of the one before */
    double *remembered;   /* their block */
    size_t *first;
    double *limit;       /* squared allowed error a sample */
    double *distance;    /* squared error a sample, of the last solve */
    double *soft;        /* a sample's factor on the penalty */
    unsigned char *wild; /* a sample where even the dense fit leaves the speed law */
    bat_knot_set best, trial, spare;
    double *points; /* of the last solve */
    int solves;
    double work;     /* of all solves, units of some 20 ns: samples and eight times the knots */
    bool exact;      /* measure true distances everywhere, not only where the plain ones are too great */
    bool holds_best; /* the local polynomials are those of best */
    double *slow;    /* w where the last solve left the speed law */
    int slow_count;
    double ridge; /* relative; 0 unless the equations were singular */
    bat_fairing fairing;
} bat_local_machine;

/* False: no memory; free it all the same. */
bool bat_local_machine_make(bat_local_machine *machine, const bat_local_problem *problem);
void bat_local_machine_free(bat_local_machine *machine);
/* Solves for the knots given and measures; true when every sample is within its limit and the speed within
 * the law's. *status tells a numerical failure apart. */
bool bat_local_try(bat_local_machine *machine, const bat_knot_set *knots, bat_status *status);
/* Fewest interior knots that the pins permit. */
int bat_local_fewest(const bat_local_problem *problem);
/* The greatest squared distance, in squared limits. */
double bat_local_worst(const bat_local_machine *machine);
void bat_knot_set_copy(bat_knot_set *to, const bat_knot_set *from);
/* ---- energy.c: the change of curvature as a penalty, and what fewer knots must keep of the fair curve ---- */

/* Adds the change of curvature of the curve, or of its difference to the fair one, to the normal equations. */
void bat_energy_add(bat_local_machine *machine);
/* Takes from the last solve at the samples: where it lies, how it bends, how that changes. */
void bat_energy_look(bat_local_machine *machine);
/* The last solve is the fair curve: its curvature, extrema, inflections and peak are what others are held to. */
void bat_energy_keep(bat_local_machine *machine);
/* Whether the last solve has no more extrema and inflections and no higher peak. Where it has, it says where in
 * machine->slow. fairing.variation: its sum of absolute changes of curvature. */
bool bat_energy_guard(bat_local_machine *machine);

/* Whether sample i violates its error limit. */
static inline bool bat_local_fails(const bat_local_machine *m, size_t i) {
    return !(m->distance[i] <= m->limit[i]);
}

#endif
