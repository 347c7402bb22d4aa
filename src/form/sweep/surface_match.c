/* The edge of a surface moved to meet another's. What is done to the end of a curve is done to every line across, in control points
 * along the edge that both share, so that the joint is exact (docs/math/blend.md 5). */
#include "form/surface/surface.h"
#include "form/sweep/border.h"
#include "form/sweep/sections.h"
#include "relate/end.h"

#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ORDER = BAT_CONTINUITY_MAX, MEASURED = 33 };

static bat_status room_at_start(const bat_curve *row, int continuity, const double *unused, bat_curve **out) {
    (void)unused;
    return bat_curve_end_room(row, continuity, false, out);
}

static bat_status room_at_end(const bat_curve *row, int continuity, const double *unused, bat_curve **out) {
    (void)unused;
    return bat_curve_end_room(row, continuity, true, out);
}

/* The lines that the edge is to have: itself, and itself moved by each derivative, times factor to its order. */
static bat_status wanted_lines(const bat_surface_border *b, double factor, bool turned, bat_curve **lines) {
    const bat_curve *line = b->line;
    const size_t numbers = 3 * (size_t)line->count;
    double *points = malloc(numbers * sizeof *points), scale = 1;
    bat_status status = points ? BAT_OK : BAT_MEMORY;
    for (int j = 0; j <= b->order && status == BAT_OK; j++, scale *= factor) {
        for (size_t k = 0; k < numbers; k++)
            points[k] = b->across[k] + (j ? scale * b->across[(size_t)j * numbers + k] : 0);
        bat_curve *made = NULL;
        status = bat_curve_create(3, line->degree, line->closed, numbers / 3, points,
                                  bat_curve_knot_count(line), bat_curve_knots(line), &made);
        if (status == BAT_OK && turned)
            status = bat_curve_reverse(made, &lines[j]);
        else
            lines[j] = made, made = NULL;
        bat_curve_free(made);
    }
    free(points);
    return status;
}

/* The surface whose lines along u are the first `count`, with the other axis as it is. */
static bat_status assemble(const bat_surface *like, int count, bat_curve *const *lines, bat_surface **out) {
    const bat_curve *first = lines[0], *other = &like->axis[1];
    bat_surface *made = NULL;
    bat_status status = bat_surface_allocate((const int[2]){first->degree, other->degree},
                                             (const bool[2]){first->closed, false},
                                             (const int[2]){first->count, count}, &made);
    if (status != BAT_OK) return status;
    const bat_curve *axis[2] = {first, other};
    for (int d = 0; d < 2; d++)
        memcpy(bat_curve_own_knots(&made->axis[d]), bat_curve_knots(axis[d]),
               (size_t)bat_curve_knot_count(axis[d]) * sizeof(double));
    for (int i = 0; i < first->count; i++)
        for (int k = 0; k < count; k++)
            memcpy(bat_surface_own_row(made, i) + 3 * k, bat_curve_points(lines[k]) + 3 * i,
                   3 * sizeof(double));
    *out = made;
    return BAT_OK;
}

/* Each line across gets the derivatives that the wanted lines have there. How far control points moved at most. */
static double bend(bat_surface *s, bool last, int continuity, bat_curve *const *wanted) {
    double moved = 0;
    for (int i = 0; i < s->axis[0].count; i++) {
        bat_curve line = s->axis[1];
        vec d[ORDER + 1];
        line.dimension = 3, line.points = bat_surface_own_row(s, i);
        for (int j = 0; j <= continuity; j++) {
            const vec at = vec_load(bat_curve_points(wanted[j]) + 3 * i, 3);
            d[j] = j ? vec_scale(vec_sub(at, d[0]), j % 2 && last ? -1 : 1) : at;
        }
        moved = fmax(moved, bat_curve_end_put(&line, last, continuity, d));
    }
    return moved;
}

/* The surface with its edge at v = 0 (or its end) as the lines want it. */
static bat_status meet(const bat_surface *s, bool last, int continuity, bat_curve *const *wanted,
                       bat_surface **out, double *moved) {
    const int count = s->axis[1].count, all = count + continuity + 1;
    bat_surface *turned = NULL, *made = NULL;
    bat_curve *rows = malloc((size_t)count * sizeof *rows);
    const bat_curve **given = malloc((size_t)all * sizeof *given);
    bat_curve **matched = calloc((size_t)all, sizeof *matched);
    double domain[2];
    bat_status status = rows && given && matched ? bat_surface_transpose(s, &turned) : BAT_MEMORY;
    for (int i = 0; i < all && status == BAT_OK; i++) {
        if (i < count) rows[i] = bat_surface_stored_row(turned, i);
        given[i] = i < count ? &rows[i] : wanted[i - count];
    }
    if (status == BAT_OK) {
        bat_surface_domain(s, BAT_U, domain);
        status = bat_sections_match(all, given, domain, matched, NULL);
    }
    if (status == BAT_OK) status = assemble(s, count, matched, &made);
    if (status == BAT_OK) {
        const double far = bend(made, last, continuity, matched + count);
        status = bat_surface_finish(made, out);
        if (status == BAT_OK && moved) *moved = far;
    }
    if (matched) bat_sections_free(all, matched);
    free(rows), free(given), free(matched);
    bat_surface_free(turned);
    return status;
}

/* The edge runs along u. */
static bat_status match(const bat_surface *s, bool last, const bat_surface_border *to, double tension,
                        bat_surface **out, double *moved) {
    bat_surface_border own = {0};
    bat_surface *room = NULL;
    bat_curve *wanted[ORDER + 1] = {NULL};
    double factor = 1;
    bool turned = false;
    bat_status status = bat_surface_border_read(s, last ? BAT_SIDE_V1 : BAT_SIDE_V0, to->order > 0, &own);
    if (status == BAT_OK && own.line->closed != to->line->closed) status = BAT_ARGUMENT;
    if (status == BAT_OK && to->order > 0) {
        const double speed[2] = {bat_surface_border_speed(&own), bat_surface_border_speed(to)};
        factor = tension * speed[0] / speed[1];
        if (!(speed[0] > 0 && speed[1] > 0)) status = BAT_SINGULAR;
    }
    if (status == BAT_OK) {
        turned = bat_sections_apart(own.line, to->line, MEASURED, true) <
                 bat_sections_apart(own.line, to->line, MEASURED, false);
        status = wanted_lines(to, factor, turned, wanted);
    }
    if (status == BAT_OK)
        status = bat_surface_change(s, BAT_V, last ? room_at_end : room_at_start, to->order, NULL, &room);
    if (status == BAT_OK) status = meet(room, last, to->order, wanted, out, moved);
    for (int j = 0; j <= ORDER; j++) bat_curve_free(wanted[j]);
    bat_surface_free(room);
    bat_surface_border_clear(&own);
    return status;
}

bat_status bat_surface_match(const bat_surface *a, bat_side a_side, const bat_surface *b, bat_side b_side,
                             int continuity, double tension, bat_surface **out, double *moved) {
    if (!a || !b || !out || !bat_is_side(a_side) || !bat_is_side(b_side) || continuity < 0 ||
        continuity > ORDER || !bat_curve_end_is_tension(tension))
        return BAT_ARGUMENT;
    const bool last = a_side == BAT_SIDE_U1 || a_side == BAT_SIDE_V1,
               swap = a_side == BAT_SIDE_U0 || a_side == BAT_SIDE_U1;
    bat_surface_border to = {0};
    bat_surface *turned = NULL, *made = NULL;
    bat_status status = a->axis[swap ? 0 : 1].closed ? BAT_ARGUMENT : BAT_OK;
    if (status == BAT_OK) status = bat_surface_border_read(b, b_side, continuity, &to);
    if (status == BAT_OK && swap) status = bat_surface_transpose(a, &turned);
    if (status == BAT_OK) status = match(swap ? turned : a, last, &to, tension, swap ? &made : out, moved);
    if (status == BAT_OK && swap) status = bat_surface_transpose(made, out);
    bat_surface_free(turned), bat_surface_free(made);
    bat_surface_border_clear(&to);
    return status;
}
