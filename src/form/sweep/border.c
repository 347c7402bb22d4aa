/* The edges of surfaces. */
#include "form/sweep/border.h"
#include "base/vec.h"
#include "form/surface/surface.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ORDER = BAT_CONTINUITY_MAX, MEASURED = 33 };

bool bat_is_side(bat_side side) { return side >= BAT_SIDE_V0 && side <= BAT_SIDE_U1; }

void bat_surface_border_clear(bat_surface_border *b) {
    bat_curve_free(b->line);
    free(b->across);
}

/* The derivatives 0..order at the end of a row of control points, outwards. A row that is one point stands still. */
static bat_status derive(const bat_surface *s, int axis, int row, bool last, int order, double *out) {
    const bat_curve *model = &s->axis[axis];
    const int count = model->count;
    double *points = malloc(3 * (size_t)count * sizeof *points), jet[3 * (ORDER + 1)] = {0}, domain[2];
    bat_curve *line = NULL;
    if (!points) return BAT_MEMORY;
    for (int i = 0; i < count; i++)
        memcpy(points + 3 * i, axis == 0 ? bat_surface_row(s, i) + 3 * row : bat_surface_row(s, row) + 3 * i,
               3 * sizeof *points);
    bat_status status = bat_curve_create(3, model->degree, false, (size_t)count, points,
                                         bat_curve_knot_count(model), bat_curve_knots(model), &line);
    if (status == BAT_OK) {
        bat_curve_domain(line, domain);
        (last ? bat_curve_eval_left : bat_curve_eval)(line, domain[last], order, jet);
    } else if (status == BAT_SINGULAR) {
        memcpy(jet, points, 3 * sizeof *jet);
        status = BAT_OK;
    }
    for (int j = 0; j <= order; j++)
        for (int d = 0; d < 3; d++) out[3 * j + d] = (j % 2 && !last ? -1 : 1) * jet[3 * j + d];
    bat_curve_free(line), free(points);
    return status;
}

bat_status bat_surface_border_read(const bat_surface *s, bat_side side, int order, bat_surface_border *out) {
    const int along = side == BAT_SIDE_U0 || side == BAT_SIDE_U1, axis = 1 - along;
    const bool last = side == BAT_SIDE_U1 || side == BAT_SIDE_V1;
    if (s->axis[axis].closed) return BAT_ARGUMENT;
    const bat_curve *model = &s->axis[along];
    const size_t count = (size_t)model->count;
    double each[3 * (ORDER + 1)];
    bat_status status = BAT_OK;
    out->order = order;
    out->across = malloc(3 * count * (size_t)(order + 1) * sizeof *out->across);
    if (!out->across) return BAT_MEMORY;
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        status = derive(s, axis, (int)i, last, order, each);
        for (int j = 0; j <= order; j++)
            memcpy(out->across + 3 * ((size_t)j * count + i), each + 3 * j, 3 * sizeof *each);
    }
    bat_curve *line = NULL;
    if (status == BAT_OK)
        status = bat_curve_create(3, model->degree, model->closed, count, out->across,
                                  bat_curve_knot_count(model), bat_curve_knots(model), &line);
    out->line = line;
    return status;
}

double bat_surface_border_speed(const bat_surface_border *b) {
    const bat_curve *line = b->line;
    const double *d1 = b->across + 3 * (size_t)line->count;
    double domain[2], sum = 0;
    bat_curve_domain(line, domain);
    for (int i = 0; i < MEASURED; i++) {
        double values[BAT_DEGREE_MAX + 1];
        vec at = {0, 0, 0};
        int first;
        bat_curve_basis(line, domain[0] + (domain[1] - domain[0]) * i / (MEASURED - 1), &first, values);
        for (int k = 0; k <= line->degree; k++)
            at = vec_add(at, vec_scale(vec_load(d1 + 3 * ((first + k) % line->count), 3), values[k]));
        sum += vec_norm(at) / MEASURED;
    }
    return sum;
}
