/* The points tool: several control points of one curve, chosen with Shift or by a box, and moved together. */
#include "base/real.h"
#include "curve/curve.h"
#include "editor/edit/curves_of.h"
#include "editor/edit/line_up.h"
#include "editor/edit/pull.h"
#include "editor/session/session.h"
#include "editor/tools/points/state.h"
#include "editor/view/stage.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Room for the marks of a curve's points; what was marked of another curve, or of other points, is not any more. */
static bat_status make_room(bat_pointing *p, const bat_curve *curve) {
    const int count = bat_point_count(curve);
    if (p->marked > 0 && p->marks_size == count) return BAT_OK;
    unsigned char *marks = realloc(p->marks, (size_t)count);
    if (!marks) return BAT_MEMORY;
    memset(marks, 0, (size_t)count);
    p->marks = marks;
    p->marks_size = count;
    p->marked = 0;
    return BAT_OK;
}

static void mark(bat_pointing *p, int index, bool on) {
    p->marked += on - p->marks[index];
    p->marks[index] = on;
}

static void choose(bat_pointing *p, const bat_curve *curve, int index) {
    p->chosen = (bat_handle){BAT_HANDLE_POINT, p->object, p->curve, index, bat_handle_greville(curve, index)};
    p->measured = false;
}

/* The one that is chosen stays so while it is marked. */
static void choose_marked(bat_pointing *p, const bat_curve *curve) {
    if (p->marked == 0) {
        bat_pointing_choose_nothing(p);
        return;
    }
    if (p->chosen.kind == BAT_HANDLE_POINT && bat_pointing_is_marked(p, p->chosen.index)) return;
    int index = 0;
    while (!p->marks[index]) index++;
    choose(p, curve, index);
}

/* A point that is chosen alone is one of them. */
static void mark_chosen(bat_pointing *p) {
    if (p->marked == 0 && p->chosen.kind == BAT_HANDLE_POINT) mark(p, p->chosen.index, true);
}

bat_status bat_pointing_toggle(bat_pointing *p, const bat_curve *curve, int index) {
    const bat_status status = make_room(p, curve);
    if (status != BAT_OK) return status;
    mark_chosen(p);
    const bool on = !p->marks[index];
    mark(p, index, on);
    if (on)
        choose(p, curve, index);
    else
        choose_marked(p, curve);
    return BAT_OK;
}

bat_status bat_pointing_mark_box(const bat_context *c, bat_pointing *p, const bat_curve *curve, bool adds) {
    if (!adds) bat_pointing_unmark(p);
    const bat_status status = make_room(p, curve);
    if (status != BAT_OK) return status;
    if (adds) mark_chosen(p);
    for (int i = 0; i < p->marks_size; i++) {
        const bat_handle handle = {.kind = BAT_HANDLE_POINT, .index = i};
        double at[2], pixel[2];
        bat_handle_seen(curve, c->stage, &handle, at);
        bat_stage_project(c->stage, at, pixel);
        bool inside = true;
        for (int k = 0; k < 2; k++)
            inside = inside && pixel[k] >= fmin(p->start[k], p->at[k]) &&
                     pixel[k] <= fmax(p->start[k], p->at[k]);
        if (inside) mark(p, i, true);
    }
    choose_marked(p, curve);
    return BAT_OK;
}

/* By how much each point of the curve moves. */
static bat_status find_moves(const bat_pointing *p, const bat_curve *curve, const bat_line_up *how,
                             double *by) {
    const int count = p->marks_size, size = bat_curve_dimension(curve);
    int n = 0;
    bat_in_line *things = malloc((size_t)count * sizeof *things);
    if (!things) return BAT_MEMORY;
    for (int i = 0; i < count; i++) {
        const double at = bat_curve_points(curve)[(ptrdiff_t)size * i + how->axis];
        if (p->marks[i]) things[n++] = (bat_in_line){.low = at, .high = at};
    }
    const bat_status status = bat_line_up_find(how, n, things, NULL);
    for (int i = 0, k = 0; i < count && status == BAT_OK; i++) by[i] = p->marks[i] ? things[k++].by : 0;
    free(things);
    return status;
}

bat_status bat_pointing_line_up(bat_context *c, bat_pointing *p, bat_command_id id) {
    const bat_line_up how = bat_line_up_of(id);
    const bat_curve *curve = bat_pointing_curve(c, p);
    bat_curve *after = NULL;
    if (!curve || p->marked < 2) return BAT_STATE;
    double *by = calloc((size_t)p->marks_size, sizeof *by);
    bat_status status = by ? find_moves(p, curve, &how, by) : BAT_MEMORY;
    if (status == BAT_OK) status = bat_pull_along(curve, how.axis, by, &after);
    free(by);
    if (status == BAT_OK) status = bat_commit_curve(c, p->object, p->curve, after, how.step);
    return status == BAT_STATE ? status : bat_pointing_told(c, status);
}
