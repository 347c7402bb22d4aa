#include "editor/edit/surface_line.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include <math.h>
#include <stdlib.h>

enum { HELD = 2 * (BAT_DEGREE_MAX + 1 + BAT_LOCK_MOST) };

static const bat_surface *surface_of(const bat_document *document, bat_id object) {
    const int at = bat_document_find(document, object);
    return at < 0 ? NULL : bat_object_surface(bat_document_at(document, at));
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

bat_status bat_line_edit_compute(const bat_document *document, const bat_line_edit *edit, bat_surface **out,
                                 bat_surface_sketch_report *report) {
    const bat_surface *surface = surface_of(document, edit->object);
    const bat_stroke stroke = {.dimension = 2, .count = edit->count, .points = edit->pixels};
    const bat_direction other = edit->direction == BAT_U ? BAT_V : BAT_U;
    bat_surface_sketch_options options = bat_surface_sketch_defaults();
    held_rows held;
    *report = (bat_surface_sketch_report){.landed = 0};
    if (!surface) return BAT_ARGUMENT;
    rows_of(surface, edit, &held);
    options.redraw = &held.options;
    options.tolerance = edit->tolerance;
    for (int k = 0; k < 3; k++) options.along[k] = edit->along[k];
    for (int end = 0; end < 2; end++)
        options.keep[end] = rows_at(surface, other, end, edit->lock[2 * (int)other + end]);
    return bat_surface_sketch(surface, edit->direction, edit->at, &edit->seen, &stroke, &options, out, NULL,
                              report);
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
static bat_status put(bat_context *c, bat_id object, const bat_surface *surface) {
    const int at = bat_document_find(c->session->document, object);
    bat_object *after = NULL;
    if (at < 0) return BAT_ARGUMENT;
    bat_status status = bat_object_with_surface(bat_document_at(c->session->document, at), surface, &after);
    if (status == BAT_OK) status = bat_transaction_replace(c, at, after);
    bat_object_release(after);
    return status;
}

bat_status bat_line_edit_commit(bat_context *c, const bat_line_edit *edit, const bat_surface *surface) {
    bat_text line = {0};
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    bat_line_edit_write(edit, &line);
    c->session->transaction.told = true;
    status = put(c, edit->object, surface);
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
    bat_surface *surface = NULL;
    double *pixels = NULL;
    bat_status status = bat_line_edit_read(json, &edit, &pixels, problem);
    if (status == BAT_OK) status = bat_line_edit_compute(c->session->document, &edit, &surface, &report);
    if (status == BAT_OK) status = bat_line_edit_commit(c, &edit, surface);
    bat_surface_free(surface);
    free(pixels);
    return status;
}
