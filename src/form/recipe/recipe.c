#include "form/recipe/recipe.h"
#include "base/vec.h"
#include "curve/curve.h"
#include "form/recipe/corners.h"
#include "text/json.h"

#include <batten/refine.h>
#include <math.h>
#include <string.h>

static const double fineness = 1e-4; /* of the curves' size: how far a revolution is off at most */
static const double far_fineness =
    1e-7; /* and of how far they are from each other, so that distance alone makes no knots */

bat_status bat_recipe_check(const bat_recipe *recipe, size_t count, bat_problem *problem) {
    if (!recipe) return bat_problem_set(problem, BAT_ARGUMENT, "recipe", "expected a recipe, found none");
    const bat_recipe_kind kind = recipe->kind;
    if (bat_problem_outside(problem, "kind", 0, BAT_RECIPE_SWEEP, BAT_RECIPE_LOFT, kind) ||
        bat_problem_outside(problem, "stand", 0, 0, BAT_STAND_COUNT - 1, recipe->stand))
        return BAT_ARGUMENT;
    const int least = kind == BAT_RECIPE_COONS ? 4 : 2;
    if (bat_problem_outside(problem, "count", 0, least, kind == BAT_RECIPE_LOFT ? BAT_RECIPE_CURVES : least,
                            (double)count))
        return BAT_COUNT;
    if (bat_problem_outside(problem, "twist", 0, -BAT_RECIPE_TWIST, BAT_RECIPE_TWIST, recipe->twist) ||
        bat_problem_outside(problem, "scale", 0, 0, BAT_RECIPE_SCALE, recipe->scale) ||
        bat_problem_outside(problem, "angle", 0, -360, 360, recipe->angle))
        return BAT_NUMBER;
    return recipe->angle != 0
               ? BAT_OK
               : bat_problem_found(problem, BAT_NUMBER, "angle", 0, "an angle other than 0", recipe->angle);
}

static void start_of(const bat_curve *curve, double out[3]) {
    double domain[2];
    bat_curve_domain(curve, domain);
    out[2] = 0;
    bat_curve_eval(curve, domain[0], 0, out);
}

static bat_status revolve(const bat_recipe *recipe, const bat_curve *const *curves, bat_surface **out) {
    double domain[2], from[3] = {0}, to[3] = {0}, way[3];
    if (bat_curve_is_closed(curves[1])) return BAT_ARGUMENT;
    bat_curve_domain(curves[1], domain);
    start_of(curves[1], from);
    bat_curve_eval(curves[1], domain[1], 0, to);
    for (int k = 0; k < 3; k++) way[k] = to[k] - from[k];
    if (way[0] == 0 && way[1] == 0 && way[2] == 0) return BAT_SINGULAR;
    double near[3];
    const double size = bat_curve_size(curves[0]) + bat_curve_size(curves[1]);
    start_of(curves[0], near);
    const double away = bat_hypot(bat_hypot(near[0] - from[0], near[1] - from[1]), near[2] - from[2]);
    const double angle = fabs(recipe->angle) == 360 ? copysign(2 * BAT_PI, recipe->angle)
                                                    : recipe->angle * (BAT_PI / 180);
    return bat_surface_revolve(curves[0], from, way, angle, fineness * size + far_fineness * away, out, NULL);
}

/* Each section is aligned to the one before. */
static bat_status loft(size_t count, const bat_curve *const *curves, bat_surface **out) {
    bat_curve *aligned[BAT_RECIPE_CURVES];
    size_t made = 0;
    bat_status status = bat_curve_copy(curves[0], &aligned[0]);
    if (status == BAT_OK) made = 1;
    for (; made < count && status == BAT_OK; made += status == BAT_OK)
        status = bat_recipe_align(aligned[made - 1], curves[made], &aligned[made]);
    if (status == BAT_OK) status = bat_surface_loft(count, (const bat_curve *const *)aligned, out, NULL);
    while (made > 0) bat_curve_free(aligned[--made]);
    return status;
}

static bat_status coons(const bat_curve *const *curves, bat_surface **out, bat_recipe_report *report) {
    bat_curve *turned[4] = {NULL, NULL, NULL, NULL};
    bat_recipe_corners corners;
    bat_status status = bat_recipe_meet(curves, &corners);
    for (int i = 0; i < 4 && status == BAT_OK; i++) {
        const bat_curve *curve = curves[corners.side[i]];
        status = corners.turned[i] ? bat_curve_reverse(curve, &turned[i]) : bat_curve_copy(curve, &turned[i]);
    }
    if (status == BAT_OK)
        status = bat_surface_coons((const bat_curve *const *)turned, BAT_COORDINATE_MAX, out, NULL);
    for (int i = 0; i < 4; i++) bat_curve_free(turned[i]);
    if (status == BAT_OK && report) report->apart = corners.apart;
    return status;
}

/* A bound of the number of points, before memory is taken for them. */
static bool is_small(bat_recipe_kind kind, size_t count, const bat_curve *const *curves) {
    double sum = 0, product = 1, most = 0;
    for (size_t i = 0; i < count; i++) {
        const double points = (double)bat_curve_count(curves[i]);
        sum += points, product *= points, most = fmax(most, points);
    }
    const double bound = kind == BAT_RECIPE_SWEEP   ? product
                         : kind == BAT_RECIPE_COONS ? sum * sum / 4
                                                    : most * (double)count;
    return bound <= BAT_RECIPE_POINTS;
}

bat_status bat_recipe_surface(const bat_recipe *recipe, size_t count, const bat_curve *const *curves,
                              bat_surface **out, bat_recipe_report *report) {
    bat_recipe_report told = {.folds = 0};
    bat_surface *made = NULL;
    bat_status status = bat_recipe_check(recipe, count, NULL);
    if (status != BAT_OK) return status;
    if (!curves || !out) return BAT_ARGUMENT;
    for (size_t i = 0; i < count; i++) {
        if (!curves[i]) return BAT_ARGUMENT;
        if (bat_curve_dimension(curves[i]) != 2 && bat_curve_dimension(curves[i]) != 3) return BAT_DIMENSION;
    }
    if (!is_small(recipe->kind, count, curves)) return BAT_COUNT;
    switch (recipe->kind) {
    case BAT_RECIPE_SWEEP: status = bat_recipe_sweep(recipe, curves[0], curves[1], &made, &told); break;
    case BAT_RECIPE_REVOLVE: status = revolve(recipe, curves, &made); break;
    case BAT_RECIPE_COONS: status = coons(curves, &made, &told); break;
    case BAT_RECIPE_RULED:
    case BAT_RECIPE_LOFT: status = loft(count, curves, &made); break;
    }
    if (status == BAT_OK &&
        bat_surface_count(made, BAT_U) * bat_surface_count(made, BAT_V) > BAT_RECIPE_POINTS) {
        bat_surface_free(made);
        status = BAT_COUNT;
    }
    if (status != BAT_OK) return status;
    *out = made;
    if (report) *report = told;
    return BAT_OK;
}
