#include "editor/edit/surface_line.h"
#include "base/vec.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include <batten/levels.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { HELD = 2 * (BAT_DEGREE_MAX + 1 + BAT_LOCK_MOST) };

static const bat_surface *surface_of(const bat_document *document, bat_id object) {
    const int at = bat_document_find(document, object);
    return at < 0 ? NULL : bat_object_surface(bat_document_at(document, at));
}

static const bat_relief *relief_of(const bat_document *document, bat_id object) {
    const int at = bat_document_find(document, object);
    return at < 0 ? NULL : bat_object_relief(bat_document_at(document, at));
}

/* How many rows at an end determine what a lock keeps there: one at a clamped end, and one for each derivative. There may
 * be fewer rows: a line of degree 1 has more once its degree is raised. */
static int rows_at(const bat_surface *surface, bat_direction direction, int end, int lock) {
    const double *knots = bat_surface_knots(surface, direction);
    const int degree = bat_surface_degree(surface, direction),
              count = bat_surface_knot_count(surface, direction);
    double domain[2];
    int same = 0;
    if (lock == 0 || bat_surface_is_closed(surface, direction)) return 0;
    bat_surface_domain(surface, direction, domain);
    for (int i = 0; i < count; i++) same += knots[i] == domain[end];
    const int most = degree + 1 - same > 1 ? degree + 1 - same : 1;
    return most + lock - 1;
}

typedef struct held_rows {
    int index[HELD];
    bat_surface_redraw_options options;
} held_rows;

/* The edit's options for the surface; they borrow *held. */
static void rows_of(const bat_surface *surface, const bat_line_edit *edit, held_rows *held) {
    const int rows = (int)bat_surface_count(surface, edit->direction);
    held->options = bat_surface_redraw_defaults();
    held->options.reach = edit->reach;
    held->options.hold = held->index;
    for (int end = 0; end < 2; end++) {
        const int count = rows_at(surface, edit->direction, end, edit->lock[2 * (int)edit->direction + end]);
        for (int i = 0; i < count && i < rows; i++)
            held->index[held->options.hold_count++] = end ? rows - 1 - i : i;
    }
}

void bat_line_made_clear(bat_line_made *made) {
    bat_surface_free(made->surface);
    bat_surface_free(made->image);
    bat_relief_free(made->relief);
    *made = (bat_line_made){.surface = NULL};
}

/* The surface that the stroke alone makes. */
static bat_status stroked(const bat_surface *surface, const bat_line_edit *edit, bat_surface **out,
                          bat_surface_sketch_report *report) {
    const bat_stroke stroke = {.dimension = 2, .count = edit->count, .points = edit->pixels};
    const bat_direction other = edit->direction == BAT_U ? BAT_V : BAT_U;
    bat_surface_sketch_options options = bat_surface_sketch_defaults();
    held_rows held;
    rows_of(surface, edit, &held);
    options.redraw = &held.options;
    options.tolerance = edit->tolerance;
    for (int k = 0; k < 3; k++) options.along[k] = edit->along[k];
    for (int end = 0; end < 2; end++)
        options.keep[end] = rows_at(surface, other, end, edit->lock[2 * (int)other + end]);
    return bat_surface_sketch(surface, edit->direction, edit->at, &edit->seen, &stroke, &options, out, NULL,
                              report);
}

bat_line_edit bat_line_edit_paired(const bat_line_edit *edit, const bat_surface_pair *pair) {
    bat_line_edit both = *edit;
    for (int k = 0; k < BAT_LINE_EDGES; k++)
        if (pair->image == edit->object && pair->way.back[k / 2] && edit->lock[k ^ 1] > both.lock[k])
            both.lock[k] = edit->lock[k ^ 1];
    return both;
}

/* From where to where both lines and what comes along are; closed: everywhere. */
static void reach_both(const bat_surface *surface, bat_direction direction, const bat_surface_way *way,
                       double moved[2]) {
    double there[2], domain[2];
    bat_direction same = direction;
    bat_surface_way_range(way, surface, &same, moved, there);
    bat_surface_domain(surface, direction, domain);
    const bool closed = bat_surface_is_closed(surface, direction);
    moved[0] = closed ? domain[0] : fmin(moved[0], there[0]);
    moved[1] = closed ? domain[1] : fmax(moved[1], there[1]);
}

/* The surface is its own image: the line's image is redrawn on it, too. */
static bat_status mirrored(const bat_surface *surface, const bat_line_edit *edit, const bat_surface_way *way,
                           bat_surface **made, bat_surface_sketch_report *report) {
    bat_surface_redraw_report *redraw = &report->redraw;
    bat_surface *both = NULL;
    double gain = 1;
    bat_status status = bat_surface_redraw_image(surface, *made, &edit->mirror, way, edit->direction,
                                                 edit->at, &gain, &both);
    redraw->gain = fmax(redraw->gain, gain);
    if (status != BAT_OK) return status;
    bat_surface_free(*made);
    *made = both;
    reach_both(surface, edit->direction, way, redraw->moved);
    for (int d = 0; d < 2; d++) redraw->knots_after[d] = bat_surface_knot_count(both, d ? BAT_V : BAT_U);
    return BAT_OK;
}

/* ---- a surface with levels ---- */

enum { A_SPAN = 8 }; /* targets in each span, where the line is put on the level's knots */

/* The ends of a line: those of `wanted`, and of `old` as many control points as are to stay at each end. */
static bat_status with_ends(const bat_curve *line, const bat_curve *old, const bat_curve *wanted,
                            const int keep[2], bat_curve **out) {
    const size_t count = bat_curve_count(line);
    double *points = malloc(3 * count * sizeof *points), domain[2];
    if (!points) return BAT_MEMORY;
    memcpy(points, bat_curve_points(line), 3 * count * sizeof *points);
    bat_curve_domain(line, domain);
    for (int end = 0; end < 2 && !bat_curve_is_closed(line); end++) {
        const int degree = bat_curve_degree(line), last = (int)count - 1;
        const double *knots = bat_curve_knots(line) + (end ? count : 0);
        if (knots[0] == knots[degree]) bat_curve_eval(wanted, domain[end], 0, points + (end ? 3 * last : 0));
        for (int k = 0; k < keep[end] && k <= last; k++) {
            const int at = 3 * (end ? last - k : k);
            memcpy(points + at, bat_curve_points(old) + at, 3 * sizeof *points);
        }
    }
    bat_status status = bat_curve_create(3, bat_curve_degree(line), bat_curve_is_closed(line), count, points,
                                         bat_curve_knot_count(line), bat_curve_knots(line), out);
    free(points);
    return status;
}

/* The line of a surface, as close as one on the knots of `old` comes: by least squares, as a stroke at a level of a curve.
 * keep: at each end, the control points that stay. *miss: raised to the greatest distance. */
static bat_status on_knots(const bat_curve *old, const bat_curve *wanted, const int keep[2], bat_curve **out,
                           double *miss) {
    const size_t count = A_SPAN * (bat_curve_count(old) + 1);
    double *u = malloc(4 * count * sizeof *u), domain[2];
    bat_shape *shape = NULL;
    bat_status status = u ? bat_shape_create(old, NULL, &shape) : BAT_MEMORY;
    bat_curve_domain(old, domain);
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        u[i] = domain[0] + (domain[1] - domain[0]) * (double)i / (double)(count - 1);
        bat_curve_eval(wanted, u[i], 0, u + count + 3 * i);
    }
    if (status == BAT_OK) status = bat_shape_sketch(shape, 0, count, u, u + count);
    if (status == BAT_OK) status = with_ends(bat_shape_curve(shape, 0), old, wanted, keep, out);
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        double at[3];
        bat_curve_eval(*out, u[i], 0, at);
        *miss = fmax(*miss, vec_norm(vec_sub(vec_load(at, 3), vec_load(u + count + 3 * i, 3))));
    }
    bat_shape_free(shape);
    free(u);
    return status;
}

static bat_status redraw_level(const bat_relief *relief, const bat_line_edit *edit, bat_line_made *made,
                               bat_surface_sketch_report *report) {
    const int level = edit->level < bat_relief_levels(relief) ? edit->level : bat_relief_levels(relief);
    const bat_surface *old = bat_relief_surface(relief, level);
    bat_surface *drawn = NULL;
    bat_curve *before = NULL, *wanted = NULL, *line = NULL;
    const bat_direction other = edit->direction == BAT_U ? BAT_V : BAT_U;
    int keep[2];
    held_rows held;
    rows_of(old, edit, &held);
    for (int end = 0; end < 2; end++) keep[end] = rows_at(old, other, end, edit->lock[2 * (int)other + end]);
    bat_status status = stroked(old, edit, &drawn, report);
    if (status == BAT_OK) status = bat_surface_isocurve(old, edit->direction, edit->at, &before);
    if (status == BAT_OK) status = bat_surface_isocurve(drawn, edit->direction, edit->at, &wanted);
    if (status == BAT_OK) status = on_knots(before, wanted, keep, &line, &report->max_error);
    if (status == BAT_OK) status = bat_relief_copy(relief, &made->relief);
    if (status == BAT_OK)
        status = bat_relief_redraw(made->relief, level, edit->direction, edit->at, line, &held.options, NULL,
                                   &report->redraw);
    if (level < bat_relief_levels(relief)) /* frames beyond what moves turn, too */
        bat_surface_domain(old, edit->direction, report->redraw.moved);
    if (status == BAT_OK)
        status = bat_surface_copy(bat_relief_surface(made->relief, bat_relief_levels(relief)),
                                  &made->surface);
    bat_curve_free(before), bat_curve_free(wanted), bat_curve_free(line);
    bat_surface_free(drawn);
    return status;
}

bat_status bat_line_edit_compute(const bat_document *document, const bat_line_edit *edit, bat_line_made *out,
                                 bat_surface_sketch_report *report) {
    const bat_surface *surface = surface_of(document, edit->object);
    bat_line_made made = {.surface = NULL};
    *report = (bat_surface_sketch_report){.landed = 0};
    if (!surface) return BAT_ARGUMENT;
    const bat_relief *relief = relief_of(document, edit->object);
    if (relief) {
        const bat_status redrawn = redraw_level(relief, edit, &made, report);
        if (redrawn == BAT_OK)
            *out = made;
        else
            bat_line_made_clear(&made);
        return redrawn;
    }
    const bat_surface_pair pair = bat_surface_pair_of(document, edit->object, &edit->mirror);
    const bat_line_edit both = bat_line_edit_paired(edit, &pair);
    bat_status status = stroked(surface, &both, &made.surface, report);
    if (status == BAT_OK && pair.image == edit->object)
        status = mirrored(surface, &both, &pair.way, &made.surface, report);
    else if (status == BAT_OK && pair.image) {
        made.twin = pair.image, made.way = pair.way;
        status = bat_surface_follow_image(surface, made.surface, surface_of(document, pair.image),
                                          &edit->mirror, &pair.way, &made.image);
    }
    if (status == BAT_OK)
        *out = made;
    else
        bat_line_made_clear(&made);
    return status;
}

bat_status bat_line_edit_probe(const bat_surface *surface, const bat_line_edit *edit,
                               bat_surface_redraw_report *report) {
    bat_curve *line = NULL;
    bat_surface *same = NULL;
    held_rows held;
    rows_of(surface, edit, &held);
    bat_status status = bat_surface_isocurve(surface, edit->direction, edit->at, &line);
    if (status == BAT_OK)
        status = bat_surface_redraw(surface, edit->direction, edit->at, line, &held.options, &same, NULL,
                                    report);
    bat_surface_free(same);
    bat_curve_free(line);
    return status;
}

/* Within a transaction. */
static bat_status put(bat_context *c, bat_id object, const bat_surface *surface, const bat_relief *relief) {
    const int at = bat_document_find(c->session->document, object);
    bat_object *after = NULL;
    if (at < 0) return BAT_ARGUMENT;
    const bat_object *before = bat_document_at(c->session->document, at);
    bat_status status = relief ? bat_object_with_relief(before, relief, &after)
                               : bat_object_with_surface(before, surface, &after);
    if (status == BAT_OK) status = bat_transaction_replace(c, at, after);
    bat_object_release(after);
    return status;
}

bat_status bat_line_edit_commit(bat_context *c, const bat_line_edit *edit, const bat_line_made *made) {
    bat_text line = {0};
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    bat_line_edit_write(edit, &line);
    c->session->transaction.told = true;
    status = put(c, edit->object, made->surface, made->relief);
    if (status == BAT_OK && made->image) status = put(c, made->twin, made->image, NULL);
    if (status == BAT_OK)
        status = bat_transaction_commit(c, BAT_STRING_STEP_SURFACE_LINE, &line);
    else
        bat_transaction_cancel(c);
    bat_text_free(&line);
    return status;
}

bat_status bat_line_edit_perform(bat_context *c, const bat_json *json, bat_problem *problem) {
    bat_line_edit edit;
    bat_surface_sketch_report report;
    bat_line_made made = {.surface = NULL};
    double *pixels = NULL;
    bat_status status = bat_line_edit_read(json, &edit, &pixels, problem);
    if (status == BAT_OK) status = bat_line_edit_compute(c->session->document, &edit, &made, &report);
    if (status == BAT_OK) status = bat_line_edit_commit(c, &edit, &made);
    bat_line_made_clear(&made);
    free(pixels);
    return status;
}
