/* The rules that every knot vector obeys (include/batten/curve.h, top). */
#include "curve/curve.h"
#include "base/lanes.h"

#include <math.h>

/* Counts how often the knot at `first` repeats from there on, looking no further than `last`. */
static int run_length(const double *knots, int first, int last) {
    int n = 1;
    while (first + n <= last && knots[first + n] == knots[first]) n++;
    return n;
}

BAT_CLONES static bat_status check_open(int degree, int count, const double *knots) {
    int last = count + degree;
    if (!(knots[degree] < knots[degree + 1]) || !(knots[count - 1] < knots[count])) return BAT_KNOTS;
    /* Knots ascend, so a value that repeats too often equals the one so many places on. */
    long long fault = 0;
    double start = knots[degree], end = knots[count];
    for (int i = 0; i + degree <= last; i++)
        fault |= (knots[i] == knots[i + degree]) & (knots[i] > start) & (knots[i] < end);
    for (int i = 0; i + degree < last; i++) fault |= knots[i] == knots[i + degree + 1];
    if (fault) return BAT_KNOTS;
    return BAT_OK;
}

static bat_status check_closed(int degree, int count, const double *knots) {
    if (!(knots[0] < knots[count])) return BAT_KNOTS;
    /* Copies a period away must not run into each other: a matter of the doubles' resolution. */
    for (int i = 1; i <= count; i++) {
        if (knots[i] == knots[i - 1]) continue;
        double a = knots[i - 1], b = knots[i], start = knots[0], end = knots[count];
        if (!(end + (a - start) < end + (b - start)) || !(start + (a - end) < start + (b - end)))
            return BAT_NUMBER;
    }
    int seam = run_length(knots, 0, count);
    for (int i = seam; i <= count;) {
        int n = run_length(knots, i, count);
        /* The last knot is the first one, a period later: counted once. */
        if (i + n > count) n += seam - 1;
        if (n > degree) return BAT_KNOTS;
        i += n;
    }
    return seam > degree ? BAT_KNOTS : BAT_OK;
}

/* Bounded, ascending, no step too small. */
BAT_CLONES static bat_status check_steps(int total, const double *knots) {
    long long large = 0, falls = 0, small = 0; /* as wide as the doubles: the loop then vectorises */
    for (int i = 0; i < total; i++) large |= !(fabs(knots[i]) <= BAT_KNOT_MAX);
    if (large) return BAT_NUMBER;
    for (int i = 1; i < total; i++) {
        double h = knots[i] - knots[i - 1];
        falls |= h < 0;
        small |= (h > 0) & (h < BAT_SPAN_MIN);
    }
    return falls ? BAT_KNOTS : small ? BAT_NUMBER : BAT_OK;
}

bat_status bat_knots_check(int degree, bool closed, int count, const double *knots) {
    int total = bat_knot_total(degree, closed, count);
    bat_status status = check_steps(total, knots);
    if (status != BAT_OK) return status;
    return closed ? check_closed(degree, count, knots) : check_open(degree, count, knots);
}

int bat_knot_multiplicity(const bat_curve *curve, double u) {
    int p = curve->degree, first = 0, last = curve->spread + p, n = 0;
    if (curve->closed) {
        /* One period, its end left out; the trailing copies of the end belong to the seam. */
        double start = curve->knots[p], end = curve->knots[curve->spread];
        if (u == end) u = start;
        first = p, last = curve->spread - 1;
        if (u == start)
            for (int i = last; i >= first && curve->knots[i] == end; i--) n++;
    }
    int low = first, high = last + 1; /* the first knot that is not below u */
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (curve->knots[middle] < u)
            low = middle + 1;
        else
            high = middle;
    }
    while (low <= last && curve->knots[low] == u) low++, n++;
    return n;
}
