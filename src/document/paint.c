#include "document/paint.h"

#include "base/matrix.h"
#include "base/users.h"
#include "curve/curve.h"
#include "document/digest.h"
#include "text/json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct bat_painted {
    bat_users users;
    uint64_t digest;
    bat_paint paint; /* what it points to follows in the same block */
};

bat_gradient bat_paint_pattern(const bat_picture *tile, const double matrix[6], uint32_t alpha,
                               bat_stop stops[2]) {
    bat_gradient made = {.spread = BAT_SPREAD_REPEAT, .count = 2, .stops = stops, .tile = tile};
    double sides[2];
    bat_picture_sides(tile, sides);
    made.to[0] = sides[0];
    memcpy(made.matrix, matrix, sizeof made.matrix);
    for (int k = 0; k < 2; k++) stops[k] = (bat_stop){k, 0x80808000 | alpha};
    return made;
}

static bool is_pattern(const bat_gradient *g) {
    bat_stop stops[2];
    const bat_gradient p = bat_paint_pattern(g->tile, g->matrix, g->stops[0].colour & 0xff, stops);
    bool same = !g->radial && g->spread == p.spread && g->count == p.count &&
                memcmp(g->from, p.from, sizeof p.from) == 0 && memcmp(g->to, p.to, sizeof p.to) == 0;
    for (int k = 0; k < 2 && same; k++)
        same = g->stops[k].at == stops[k].at && g->stops[k].colour == stops[k].colour;
    return same;
}

/* The circles of a radial gradient, or the ends of a linear one. */
static bat_status check_ends(const bat_gradient *g, bat_problem *problem) {
    if (g->radial && g->from[2] < 0)
        return bat_problem_found(problem, BAT_NUMBER, "from[2]", 0, "a radius of 0 or more", g->from[2]);
    if (g->radial && !(g->to[2] > 0))
        return bat_problem_found(problem, BAT_NUMBER, "to[2]", 0, "a radius above 0", g->to[2]);
    if (g->radial) return BAT_OK;
    if (bat_problem_outside(problem, "from[2]", 0, 0, 0, g->from[2]) ||
        bat_problem_outside(problem, "to[2]", 0, 0, 0, g->to[2]))
        return BAT_NUMBER;
    return g->from[0] != g->to[0] || g->from[1] != g->to[1]
               ? BAT_OK
               : bat_problem_set(problem, BAT_NUMBER, "to",
                                 "expected another place than from, found the same");
}

static bat_status check_gradient(const bat_gradient *g, bat_problem *problem) {
    if (g->count == 0) return BAT_OK;
    if (bat_problem_outside(problem, "count", 0, 2, BAT_STOPS_MAX, (double)g->count)) return BAT_COUNT;
    if (!g->stops) return bat_problem_set(problem, BAT_ARGUMENT, "stops", "expected stops, found none");
    if (bat_problem_outside(problem, "spread", 0, 0, BAT_SPREAD_REPEAT, (double)g->spread))
        return BAT_ARGUMENT;
    bat_status status = bat_coordinates_check(problem, "from[%zu]", 3, g->from);
    if (status == BAT_OK) status = bat_coordinates_check(problem, "to[%zu]", 3, g->to);
    if (status == BAT_OK) status = bat_coordinates_check(problem, "matrix[%zu]", 6, g->matrix);
    if (status == BAT_OK && !bat_matrix_is_regular(g->matrix))
        status = bat_problem_set(problem, BAT_NUMBER, "matrix",
                                 "expected a map of the plane, found one of rank below 2");
    if (status == BAT_OK) status = check_ends(g, problem);
    if (status == BAT_OK && g->tile && !is_pattern(g))
        status = bat_problem_set(problem, BAT_NUMBER, "tile", "expected the members of a pattern beside it");
    for (size_t i = 0; i < g->count && status == BAT_OK; i++)
        if (bat_problem_outside(problem, "stops[%zu].at", i, i > 0 ? g->stops[i - 1].at : 0, 1,
                                g->stops[i].at))
            status = BAT_NUMBER;
    return status;
}

/* Whether the matrix maps circles to circles, within 1 percent, or is none. */
static bool is_round(const double m[4]) {
    const double x = m[0] * m[0] + m[1] * m[1], y = m[2] * m[2] + m[3] * m[3], xy = m[0] * m[2] + m[1] * m[3];
    return fabs(x - y) <= 0.01 * (x + y) && fabs(xy) <= 0.01 * (x + y);
}

static bat_status check_dashes(const bat_paint *paint, bat_problem *problem) {
    if (paint->dash_count == 0) return BAT_OK;
    if (bat_problem_outside(problem, "dash_count", 0, 0, BAT_DASHES_MAX, (double)paint->dash_count))
        return BAT_COUNT;
    if (!paint->dashes)
        return bat_problem_set(problem, BAT_ARGUMENT, "dashes", "expected dashes, found none");
    double sum = 0;
    for (size_t i = 0; i < paint->dash_count; i++) {
        if (bat_problem_outside(problem, "dashes[%zu]", i, 0, BAT_COORDINATE_MAX, paint->dashes[i]))
            return BAT_NUMBER;
        sum += paint->dashes[i];
    }
    if (!(sum > 0)) return bat_problem_found(problem, BAT_NUMBER, "dashes", 0, "one above 0", sum);
    return bat_coordinates_check(problem, "dash_offset", 1, &paint->dash_offset);
}

bat_status bat_paint_check(const bat_paint *paint, bat_problem *problem) {
    if (!paint) return bat_problem_set(problem, BAT_ARGUMENT, "paint", "expected a paint, found none");
    bat_status status = bat_problem_inside(problem, check_gradient(&paint->fill, problem), "fill");
    if (status != BAT_OK) return status;
    status = bat_problem_inside(problem, check_gradient(&paint->stroke, problem), "stroke");
    if (status == BAT_OK && paint->width_count) {
        const bat_width_profile profile = {paint->width_count, paint->widths};
        status = bat_problem_inside(problem, bat_width_check(&profile, problem), "widths");
    }
    if (status == BAT_OK) status = bat_coordinates_check(problem, "pen[%zu]", 4, paint->pen);
    if (status == BAT_OK && !is_round(paint->pen) && !bat_matrix_is_regular(paint->pen))
        status = bat_problem_set(problem, BAT_NUMBER, "pen",
                                 "expected a map of the plane, found one of rank below 2");
    return status == BAT_OK ? check_dashes(paint, problem) : status;
}

/* -0 is 0. */
static uint64_t digest_number(uint64_t digest, double number) {
    return bat_digest_double(digest, number + 0.0);
}

static uint64_t digest_gradient(const bat_gradient *g) {
    uint64_t digest = bat_digest_number(bat_digest_begin(), (uint64_t)g->radial << 8 | (uint64_t)g->spread);
    for (int i = 0; i < 3; i++) digest = digest_number(digest_number(digest, g->from[i]), g->to[i]);
    for (int i = 0; i < 6; i++) digest = digest_number(digest, g->matrix[i]);
    for (size_t i = 0; i < g->count; i++)
        digest = bat_digest_number(digest_number(digest, g->stops[i].at), g->stops[i].colour);
    if (g->tile) digest = bat_digest_number(digest, bat_picture_digest(g->tile));
    return digest;
}

uint64_t bat_paint_digest(const bat_paint *paint, bat_paint_part part) {
    if (!paint) return 0;
    if (part == BAT_PAINT_FILL) return paint->fill.count ? digest_gradient(&paint->fill) : 0;
    if (part == BAT_PAINT_STROKE) return paint->stroke.count ? digest_gradient(&paint->stroke) : 0;
    if (paint->dash_count + paint->width_count == 0 && is_round(paint->pen) && !paint->stroke_first) return 0;
    uint64_t digest = bat_digest_number(bat_digest_begin(), paint->dash_count);
    for (size_t i = 0; i < paint->dash_count && paint->dashes; i++)
        digest = digest_number(digest, paint->dashes[i]);
    if (paint->dash_count) digest = digest_number(digest, paint->dash_offset);
    for (int i = 0; i < 4 && !is_round(paint->pen); i++) digest = digest_number(digest, paint->pen[i]);
    if (paint->stroke_first) digest = bat_digest_number(digest, paint->stroke_first);
    for (size_t i = 0; i < paint->width_count && paint->widths; i++)
        digest = digest_number(digest_number(digest, paint->widths[i].at), paint->widths[i].share);
    return digest;
}

bool bat_paint_is_plain(const bat_paint *paint) {
    return paint->fill.count + paint->stroke.count + paint->dash_count + paint->width_count == 0 &&
           is_round(paint->pen) && !paint->stroke_first;
}

/* As wide as without a profile. */
static bool is_flat(const bat_paint *paint) {
    return paint->width_count && paint->widths[0].share == 1 &&
           bat_width_is_even(&(bat_width_profile){paint->width_count, paint->widths});
}

bat_status bat_painted_create(const bat_paint *given, bat_painted **out) {
    const bat_status status = bat_paint_check(given, NULL);
    if (status != BAT_OK) return status;
    bat_paint own = *given;
    const bat_paint *paint = &own;
    if (is_flat(paint)) own.width_count = 0;
    *out = NULL;
    if (bat_paint_is_plain(paint)) return BAT_OK;
    const size_t stops = (paint->fill.count + paint->stroke.count) * sizeof(bat_stop);
    const size_t widths = paint->width_count * sizeof(bat_width_stop);
    bat_painted *made = malloc(sizeof *made + stops + paint->dash_count * sizeof(double) + widths);
    if (!made) return BAT_MEMORY;
    *made = (bat_painted){.users = BAT_USERS_ONE, .paint = *paint};
    bat_stop *at = (bat_stop *)(void *)(made + 1);
    bat_gradient *const parts[2] = {&made->paint.fill, &made->paint.stroke};
    for (int k = 0; k < 2; k++) {
        if (parts[k]->count == 0) {
            *parts[k] = (bat_gradient){0};
            continue;
        }
        for (size_t i = 0; i < parts[k]->count; i++) at[i] = parts[k]->stops[i];
        parts[k]->stops = at;
        at += parts[k]->count;
        (void)bat_picture_retain(parts[k]->tile);
    }
    double *dashes = (double *)(void *)at;
    if (paint->dash_count) memcpy(dashes, paint->dashes, paint->dash_count * sizeof *dashes);
    made->paint.dashes = paint->dash_count ? dashes : NULL;
    if (!paint->dash_count) made->paint.dash_offset = 0;
    bat_width_stop *profile = (bat_width_stop *)(void *)(dashes + paint->dash_count);
    if (widths) memcpy(profile, paint->widths, widths);
    made->paint.widths = widths ? profile : NULL;
    if (is_round(paint->pen)) memset(made->paint.pen, 0, sizeof made->paint.pen);
    made->digest = bat_digest_begin();
    for (int k = 0; k < BAT_PAINT_PARTS; k++)
        made->digest = bat_digest_number(made->digest, bat_paint_digest(&made->paint, (bat_paint_part)k));
    *out = made;
    return BAT_OK;
}

bat_painted *bat_painted_retain(const bat_painted *painted) {
    bat_painted *shared = (bat_painted *)painted; /* only the count changes */
    if (shared) bat_users_add(&shared->users);
    return shared;
}

void bat_painted_release(bat_painted *painted) {
    if (!painted || !bat_users_drop(&painted->users)) return;
    bat_picture_release((bat_picture *)painted->paint.fill.tile); /* only the counts change */
    bat_picture_release((bat_picture *)painted->paint.stroke.tile);
    free(painted);
}

const bat_paint *bat_painted_paint(const bat_painted *painted) { return painted ? &painted->paint : NULL; }
uint64_t bat_painted_digest(const bat_painted *painted) { return painted ? painted->digest : 0; }

void bat_paint_pen(const bat_paint *paint, double pen[4]) {
    static const double circle[4] = {1, 0, 0, 1};
    memcpy(pen, !paint || is_round(paint->pen) ? circle : paint->pen, sizeof circle);
}

bat_paint bat_paint_mapped(const bat_paint *paint, const double matrix[6], double longer,
                           double dashes[BAT_DASHES_MAX]) {
    bat_paint made = *paint;
    bat_gradient *const parts[2] = {&made.fill, &made.stroke};
    for (int k = 0; k < 2; k++) {
        double m[6];
        bat_matrix_compose(matrix, parts[k]->matrix, m);
        memcpy(parts[k]->matrix, m, sizeof m);
        if (check_gradient(parts[k], NULL) != BAT_OK) *parts[k] = (bat_gradient){0};
    }
    for (size_t i = 0; i < made.dash_count; i++)
        dashes[i] = fmin(made.dashes[i] * longer, BAT_COORDINATE_MAX);
    made.dashes = dashes;
    made.dash_offset = fmax(fmin(made.dash_offset * longer, BAT_COORDINATE_MAX), -BAT_COORDINATE_MAX);
    if (bat_paint_check(&made, NULL) != BAT_OK) made.dash_count = 0;
    return made;
}
