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

void bat_line_made_clear(bat_line_made *made) {
    bat_surface_free(made->surface);
    bat_surface_free(made->image);
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
    for (int k = 0; k < BAT_EDGES; k++)
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

bat_status bat_line_edit_compute(const bat_document *document, const bat_line_edit *edit, bat_line_made *out,
                                 bat_surface_sketch_report *report) {
    const bat_surface *surface = surface_of(document, edit->object);
    bat_line_made made = {.surface = NULL};
    *report = (bat_surface_sketch_report){.landed = 0};
    if (!surface) return BAT_ARGUMENT;
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
static bat_status put(bat_context *c, bat_id object, const bat_surface *surface) {
    const int at = bat_document_find(c->session->document, object);
    bat_object *after = NULL;
    if (at < 0) return BAT_ARGUMENT;
    bat_status status = bat_object_with_surface(bat_document_at(c->session->document, at), surface, &after);
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
    status = put(c, edit->object, made->surface);
    if (status == BAT_OK && made->image) status = put(c, made->twin, made->image);
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
