/* Neighbouring sections: which way round, and where closed ones begin, by the least total length of the joins. */
#include "base/vec.h"
#include "curve/curve.h"
#include "form/recipe/recipe.h"

#include <batten/refine.h>

enum { PLACES = 64 };
static const double better = 1e-9; /* of the length: less is a matter of rounding, and changes nothing */

static vec point_at(const bat_curve *curve, double x) {
    double domain[2], point[BAT_DIMENSION_MAX] = {0};
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * x, 0, point);
    return vec_load(point, bat_curve_dimension(curve));
}

static void sample(const bat_curve *curve, vec out[PLACES]) {
    for (int i = 0; i < PLACES; i++) out[i] = point_at(curve, (double)i / PLACES);
}

/* Total length of the joins when the second begins at `first` and runs in direction `way`, 1 or -1. */
static double total_length(const vec a[PLACES], const vec b[PLACES], int first, int way) {
    double sum = 0;
    for (int i = 0; i < PLACES; i++) sum += vec_norm(vec_sub(a[i], b[(first + way * i + PLACES) % PLACES]));
    return sum;
}

/* The closed curve begun at this fraction of its domain. */
static bat_status begin_at(const bat_curve *curve, int place, bat_curve **out) {
    double domain[2];
    bat_curve *cut = NULL;
    bat_curve_domain(curve, domain);
    const double u = domain[0] + (domain[1] - domain[0]) * ((double)place / PLACES);
    const double *knots = bat_curve_knots(curve);
    int at = 0;
    while (at < curve->count && knots[at] < u) at++;
    const bool there = knots[at] == u;
    bat_status status = there ? bat_curve_copy(curve, &cut) : bat_curve_insert_knot(curve, u, 1, &cut);
    if (status != BAT_OK) return status;
    for (at = 0; at < cut->count && bat_curve_knots(cut)[at] < u;) at++;
    status = bat_curve_rotate(cut, at, out);
    bat_curve_free(cut);
    return status;
}

static bat_status align_closed(const bat_curve *before, const bat_curve *curve, bat_curve **out) {
    vec a[PLACES], b[PLACES];
    int best = 0, way = 1;
    sample(before, a), sample(curve, b);
    double least = total_length(a, b, 0, 1);
    for (int turned = 0; turned < 2; turned++)
        for (int i = 0; i < PLACES; i++) {
            const double sum = total_length(a, b, i, turned ? -1 : 1);
            if (sum < least * (1 - better)) least = sum, best = i, way = turned ? -1 : 1;
        }
    bat_curve *begun = NULL;
    bat_status status = best ? begin_at(curve, best, &begun) : bat_curve_copy(curve, &begun);
    if (status == BAT_OK) status = way < 0 ? bat_curve_reverse(begun, out) : bat_curve_copy(begun, out);
    bat_curve_free(begun);
    return status;
}

bat_status bat_recipe_align(const bat_curve *before, const bat_curve *curve, bat_curve **out) {
    if (bat_curve_is_closed(before) != bat_curve_is_closed(curve)) return BAT_ARGUMENT;
    if (bat_curve_is_closed(curve)) return align_closed(before, curve, out);
    const vec a0 = point_at(before, 0), a1 = point_at(before, 1), b0 = point_at(curve, 0),
              b1 = point_at(curve, 1);
    const double straight = vec_norm(vec_sub(a0, b0)) + vec_norm(vec_sub(a1, b1));
    const double turned = vec_norm(vec_sub(a0, b1)) + vec_norm(vec_sub(a1, b0));
    return turned < straight * (1 - better) ? bat_curve_reverse(curve, out) : bat_curve_copy(curve, out);
}
