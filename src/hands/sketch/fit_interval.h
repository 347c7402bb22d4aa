/* Inside the sketch hand: the constrained least-squares fit of one interval (docs/math sketch 5.7). Lengths
 * are pixels; the parameter w runs from 0 to `end`, a unit being about a pixel of arc length. */
#ifndef BATTEN_HANDS_SKETCH_FIT_INTERVAL_H
#define BATTEN_HANDS_SKETCH_FIT_INTERVAL_H

#include "curve/lsq.h"

/* How the fitted piece joins what lies beyond one end of the interval. */
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
    const double *w, *x, *weight, *allowed, *law; /* law: the speed wanted, ds/dw */
    size_t first, last;                           /* samples of the stroke proper: what max_error is about */
    bat_local_side side[2];
    int fixed_count;
    const double *fixed; /* corners: knots of multiplicity p that stay */
    double tolerance;    /* what is allowed on the stroke */
    double fairness;     /* share of what is allowed that is left for fairness and fewer knots */
    double span;         /* length of the first spans */
    double wavelength;   /* shorter waves are not followed */
    bool remove;         /* knots that are not needed go */
} bat_local_problem;

typedef struct bat_local_result {
    int interior;   /* knots strictly inside, multiplicity counted (closed: w = 0 is a knot besides) */
    double *knots;  /* owned */
    double *points; /* control points of the interval: interior + p + 1 (closed: interior + 1); owned */
    double max_error;
    int solves;
    bool met;
} bat_local_result;

bat_status bat_local_fit(const bat_local_problem *problem, bat_local_result *out);
void bat_local_result_free(bat_local_result *result);
/* Pinned control points at the knots found: called again with exact knots when the result is put in place. */
void bat_local_pins(const bat_local_problem *problem, int side, int interior, const double *knots,
                    double *pins);

/* ------------------------------------------------------------- the machine, shared with the removal of knots
 */

typedef struct bat_knot_set {
    int count;
    double *w;
    unsigned char *fixed; /* corner copies: never moved nor removed */
} bat_knot_set;

/* What stands out in a curve's curvature by at least so much, and how much it changes. */
enum { BAT_LOCAL_DENSITIES = 3 };

typedef struct bat_local_bumps {
    double least;
    int extrema, inflections;
    double change; /* integral of the squared change of curvature */
} bat_local_bumps;

typedef struct bat_local_machine {
    const bat_local_problem *problem;
    int room; /* interior knots that fit in the arrays */
    struct bat_curve space;
    double *a, *b, *local, *factor, *border, *rank;
    bat_lsq_memo memo[2]; /* of the last solve, and of the one before */
    double *remembered;   /* their block */
    size_t *first;
    const double *x;      /* what distances are measured to: the problem's samples, later the shape */
    const double *data;   /* what is fitted: the samples, later the aim */
    double *shape;        /* the dense fit at the samples' parameters */
    double *aim;          /* the fairest curve near it */
    double *bend;         /* its squared curvature */
    double *curvature;    /* of the last solve at the samples, in the plane with its sign */
    bat_local_bumps fair; /* of the fair curve */
    double *need;         /* how its knots should be spread: |C''''| at the samples, mean 1 */
    double *spread;       /* integrals over the samples of the densities made of it, one after the other */
    int spread_count;     /* those that are known */
    double *pull;         /* C''' + bend C' of what is fitted, at its samples */
    bool pulled;          /* the penalty is on the difference to that */
    bool bent;            /* bend is known: the penalty is on the change of curvature, else on C''' */
    double *limit;        /* squared allowed error of each sample */
    double *distance;     /* squared error of each sample, of the last solve */
    double *soft;         /* a sample's factor on the penalty */
    unsigned char *wild;  /* a sample where even the dense fit leaves the speed law */
    bat_knot_set best, trial, spare;
    double *points; /* of the last solve */
    int solves;
    double work;     /* of all solves, units of some 20 ns: samples and eight times the knots */
    double sought;   /* samples whose nearest points were sought in them */
    bool missed;     /* no knots were found that meet the tolerance */
    double hope;     /* squared: a solve so many times beyond a limit need not be measured to the end */
    bool given_up;   /* the last one was not */
    bool exact;      /* measure true distances everywhere, not only where the plain ones are too great */
    bool holds_best; /* the last solve is of best, under the penalty that is in force */
    double *slow;    /* w where the last solve left the speed law */
    int slow_count;
    double stiffness; /* factor on the penalty */
    double ridge;     /* relative; 0 unless the equations were singular */
} bat_local_machine;

/* The speed along the fit, as a share of the law's: beyond these the speed law is broken. */
#define BAT_LOCAL_SLOWEST 0.6
#define BAT_LOCAL_FASTEST 1.7

/* Solves for the knots given and measures; true when every sample is within its limit and the speed within
 * the law's. *status tells a numerical failure apart. */
bool bat_local_try(bat_local_machine *machine, const bat_knot_set *knots, bat_status *status);
/* Measures how far the samples are from the last solve; true when each is within its limit. */
bool bat_local_measure(bat_local_machine *machine, bat_status *status);
/* Fewest interior knots that the pins permit. */
int bat_local_fewest(const bat_local_problem *problem);
/* Removes and merges knots of machine->best while every sample stays within its limit. */
bat_status bat_local_reduce(bat_local_machine *machine);
/* The stiffest curve with machine->best that stays within the limits; steps: of the search. */
bat_status bat_local_stiffen(bat_local_machine *machine, int steps);
/* Of what is allowed, what is left for fairness and fewer knots once the dense fit is done. */
double bat_local_spare(const bat_local_problem *problem, size_t i);
/* The dense fit, the last solve, takes the place of the samples: what follows stays near it. */
void bat_local_take_shape(bat_local_machine *machine);
/* The fairest curve near it, with its knots, becomes what is fitted. */
bat_status bat_local_fair(bat_local_machine *machine);
/* Notes how fair the last solve is, and how its knots should be spread. */
void bat_local_note(bat_local_machine *machine);
/* About as many knots as machine->best has, placed afresh where that is fairer. */
bat_status bat_local_few(bat_local_machine *machine);
void bat_knots_copy(bat_knot_set *to, const bat_knot_set *from);
/* The points of the last solve at the samples' parameters; its curvature is remembered for the penalty. */
void bat_local_read(bat_local_machine *machine, double *points);
/* machine->curvature of the last solve. */
void bat_local_curvature(bat_local_machine *machine);
/* Adds the penalty on the change of curvature to the normal equations. */
void bat_local_energy(bat_local_machine *machine, double mu);
/* The work of a solve for so many unknowns. */
static inline double bat_local_cost(const bat_local_machine *m, int unknowns) {
    return (double)m->problem->count + (m->bent ? 20.0 : 8.0) * unknowns;
}
/* Whether more than `most` work was spent, nearest points that were sought included. */
static inline bool bat_local_enough(const bat_local_machine *m, double most) {
    return m->work + 4 * m->sought > most;
}
/* Whether sample i violates its error limit. */
static inline bool bat_local_fails(const bat_local_machine *m, size_t i) {
    return !(m->distance[i] <= m->limit[i]);
}

#endif
