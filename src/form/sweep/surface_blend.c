/* A surface between two edges. The rows of control points beside an edge follow from its derivatives across, which are curves on the
 * edge's own knots, so that the joint is exact (docs/math/blend.md 4). */
#include "form/surface/surface.h"
#include "form/sweep/border.h"
#include "form/sweep/sections.h"
#include "relate/end.h"

#include <batten/blend.h>
#include <batten/refine.h>
#include <batten/sweep.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ORDER = BAT_CONTINUITY_MAX, ROWS = 2 * ORDER + 2, MEASURED = 33 };

/* Of a curve there is nothing across. */
static bat_status read_curve(const bat_curve *curve, bat_surface_border *out) {
    bat_status status = bat_curve_to_dimension(curve, 3, &out->line);
    if (status != BAT_OK) return status;
    const size_t bytes = 3 * bat_curve_count(out->line) * sizeof(double);
    out->across = malloc(bytes);
    if (!out->across) return BAT_MEMORY;
    memcpy(out->across, bat_curve_points(out->line), bytes);
    return BAT_OK;
}

/* The order + 1 rows of control points beside a border, outwards; degree: across the blend. factor: of the parameter across. */
static bat_status make_rows(const bat_surface_border *b, int degree, double factor, bool turned,
                            bat_curve **rows) {
    const bat_curve *line = b->line;
    const size_t numbers = 3 * bat_curve_count(line);
    double *points = calloc(numbers, sizeof *points);
    bat_status status = points ? BAT_OK : BAT_MEMORY;
    for (int j = 0; j <= b->order && status == BAT_OK; j++) {
        double choose = 1,
               scale = 1; /* of the i-th difference: (j over i) factor^i (degree - i)! / degree! */
        memset(points, 0, numbers * sizeof *points);
        for (int i = 0; i <= j; i++) {
            for (size_t k = 0; k < numbers; k++)
                points[k] += choose * scale * b->across[(size_t)i * numbers + k];
            choose *= (double)(j - i) / (i + 1), scale *= factor / (degree - i);
        }
        bat_curve *row = NULL;
        status = bat_curve_create(3, line->degree, line->closed, numbers / 3, points,
                                  bat_curve_knot_count(line), bat_curve_knots(line), &row);
        if (status == BAT_OK && turned)
            status = bat_curve_reverse(row, &rows[j]);
        else
            rows[j] = row, row = NULL;
        bat_curve_free(row);
    }
    free(points);
    return status;
}

/* The rows as lines of a surface, Bézier across. */
static bat_status assemble(int count, bat_curve *const *rows, bat_surface **out) {
    const bat_curve *first = rows[0];
    const int degree[2] = {first->degree, count - 1}, size[2] = {first->count, count};
    double knots[2 * ROWS];
    bat_surface *made;
    bat_status status = bat_surface_allocate(degree, (const bool[2]){first->closed, false}, size, &made);
    if (status != BAT_OK) return status;
    for (int i = 0; i < count; i++) knots[i] = 0, knots[count + i] = 1;
    memcpy(bat_curve_own_knots(&made->axis[0]), bat_curve_knots(first),
           (size_t)bat_curve_knot_count(first) * sizeof(double));
    memcpy(bat_curve_own_knots(&made->axis[1]), knots, 2 * (size_t)count * sizeof *knots);
    for (int i = 0; i < first->count; i++)
        for (int k = 0; k < count; k++)
            memcpy(bat_surface_own_row(made, i) + 3 * k, bat_curve_points(rows[k]) + 3 * i,
                   3 * sizeof(double));
    return bat_surface_finish(made, out);
}

static bat_status blend(const bat_surface_border b[2], const double tension[2], bat_surface **out) {
    const int degree = b[0].order + b[1].order + 1, count = degree + 1;
    const double far[2] = {bat_sections_apart(b[0].line, b[1].line, MEASURED, false),
                           bat_sections_apart(b[0].line, b[1].line, MEASURED, true)};
    const bool turned = far[1] < far[0];
    bat_curve *rows[ROWS] = {NULL}, *matched[ROWS] = {NULL};
    bat_status status = far[turned] > 0 ? BAT_OK : BAT_SINGULAR;
    for (int e = 0; e < 2 && status == BAT_OK; e++) {
        const double own = b[e].order ? bat_surface_border_speed(&b[e]) : 1;
        if (!(own > 0)) status = BAT_SINGULAR;
        if (status == BAT_OK)
            status = make_rows(&b[e], degree, tension[e] * far[turned] / own, e && turned,
                               rows + (e ? b[0].order + 1 : 0));
    }
    for (int i = 0; i < (b[1].order + 1) / 2; i++) { /* those of the second come towards it */
        bat_curve **near = &rows[degree - i], **other = &rows[b[0].order + 1 + i], *kept = *near;
        *near = *other, *other = kept;
    }
    if (status == BAT_OK)
        status = bat_sections_match(count, (const bat_curve *const *)rows, (double[]){0, 1}, matched, NULL);
    if (status == BAT_OK) {
        status = assemble(count, matched, out);
        bat_sections_free(count, matched);
    }
    for (int i = 0; i < ROWS; i++) bat_curve_free(rows[i]);
    return status;
}

/* To an edge of b, or to a curve instead. */
static bat_status make(const bat_surface *a, bat_side a_side, const bat_surface *b, bat_side b_side,
                       const bat_curve *curve, const bat_blend_options *given, bat_surface **out) {
    bat_blend_options o;
    bat_surface_border both[2] = {{0}, {0}};
    bat_status status = bat_blend_options_read(given, &o);
    if (status == BAT_OK && (!bat_is_side(a_side) || !bat_is_side(b_side))) status = BAT_ARGUMENT;
    if (status == BAT_OK) status = bat_surface_border_read(a, a_side, o.continuity[0], &both[0]);
    if (status == BAT_OK)
        status = b ? bat_surface_border_read(b, b_side, o.continuity[1], &both[1])
                   : read_curve(curve, &both[1]);
    if (status == BAT_OK && both[0].line->closed != both[1].line->closed) status = BAT_ARGUMENT;
    if (status == BAT_OK) status = blend(both, o.tension, out);
    bat_surface_border_clear(&both[0]), bat_surface_border_clear(&both[1]);
    return status;
}

bat_status bat_surface_blend(const bat_surface *a, bat_side a_side, const bat_surface *b, bat_side b_side,
                             const bat_blend_options *options, bat_surface **out) {
    return a && b && out ? make(a, a_side, b, b_side, NULL, options, out) : BAT_ARGUMENT;
}

bat_status bat_surface_blend_curve(const bat_surface *a, bat_side a_side, const bat_curve *curve,
                                   const bat_blend_options *options, bat_surface **out) {
    return a && curve && out ? make(a, a_side, NULL, BAT_SIDE_V0, curve, options, out) : BAT_ARGUMENT;
}
