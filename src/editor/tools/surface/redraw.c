/* Redrawing the lit line: while the pen is down and when it is lifted, by the same calls. */
#include "editor/tools/surface/state.h"
#include "editor/edit/symmetry.h"
#include "editor/session/notice.h"
#include "editor/tools/toolbox.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double GAIN_TOLD = 1.25, GAIN_MOST = 4;

/* Reach and locks, as the properties say. */
static void settings_of(const bat_context *c, const bat_surface *surface, bat_line_edit *out) {
    const double *values = c->settings->values, *knots = bat_surface_knots(surface, out->direction);
    const double spans = values[BAT_PROPERTY_LINE_REACH];
    const int count = bat_surface_knot_count(surface, out->direction);
    double domain[2];
    int pieces = 0;
    bat_surface_domain(surface, out->direction, domain);
    for (int i = 1; i < count; i++)
        pieces += knots[i] > knots[i - 1] && knots[i - 1] >= domain[0] && knots[i] <= domain[1];
    const bool usual = spans == bat_property_at(BAT_PROPERTY_LINE_REACH)->standard;
    out->reach = usual ? 0 : spans * (domain[1] - domain[0]) / pieces;
    for (int k = 0; k < BAT_LINE_EDGES; k++) out->lock[k] = (int)values[BAT_PROPERTY_LOCK_U_LOW + k];
}

/* The level that is chosen in the level strip; of another surface the base. */
static int active_level(const bat_context *c, bat_id object) {
    const bat_slot *levels = bat_toolbox_that(c, BAT_EDITS_LEVELS);
    bat_focus focus = {0};
    return levels->is->focus(c, levels->state, &focus) && focus.object == object ? focus.level : 0;
}

/* The surface whose rows move: of one with levels that of the level. */
static const bat_surface *surface_at(const bat_context *c, const bat_line_edit *edit,
                                     const bat_surface *surface) {
    const bat_document *document = c->session->document;
    const bat_relief *relief = bat_object_relief(
        bat_document_at(document, bat_document_find(document, edit->object)));
    if (!relief) return surface;
    const int top = bat_relief_levels(relief);
    return bat_relief_surface(relief, edit->level < top ? edit->level : top);
}

bool bat_surfacing_edit(bat_context *c, bat_surfacing *s, bat_line_edit *out) {
    const bat_surface *surface = bat_surfacing_surface(c, s);
    if (!surface) return false;
    *out = (bat_line_edit){.object = s->lit.object,
                           .direction = s->lit.direction,
                           .at = s->lit.at[s->lit.direction],
                           .seen = s->seen,
                           .count = s->count,
                           .pixels = s->pixels,
                           .mirror = bat_symmetry_plane(c)};
    out->level = active_level(c, s->lit.object);
    settings_of(c, surface_at(c, out, surface), out);
    bat_surfacing_along(c, s, out->along);
    const double pixel = s->seen.height > 0 ? s->seen.height / s->seen.size[1] : bat_stage_pixel(c->stage);
    out->tolerance = fmin(fmax(c->settings->values[BAT_PROPERTY_TOLERANCE] * pixel, 1e-12), 1e12);
    return true;
}

void bat_surfacing_drop(bat_surfacing *s) {
    bat_line_made_clear(&s->made);
    s->due = false;
}

void bat_surfacing_follow(bat_context *c, bat_surfacing *s) {
    bat_line_edit edit;
    if (s->doing != BAT_LINING_DRAW || !s->due) return;
    bat_surfacing_drop(s);
    if (!bat_surfacing_edit(c, s, &edit)) return;
    s->status = bat_line_edit_compute(c->session->document, &edit, &s->made, &s->report);
    const int along = edit.direction == BAT_U ? 1 : 0; /* where knots come and go */
    s->said = (bat_sketch_report){.max_error = s->report.max_error,
                                  .knots_before = s->report.redraw.knots_before[along],
                                  .knots_after = s->report.redraw.knots_after[along]};
}

bat_string bat_surfacing_refusal(const bat_surfacing *s) {
    const bat_surface_sketch_report *r = &s->report;
    switch (s->status) {
    case BAT_OK: return BAT_STRING_COUNT;
    case BAT_DOT:
    case BAT_SINGULAR: return BAT_STRING_NOTICE_LINE_POLE;
    case BAT_STATE: return BAT_STRING_NOTICE_LINE_HELD;
    case BAT_TOLERANCE: return BAT_STRING_NOTICE_LINE_TOLERANCE;
    case BAT_FAR:
        if (r->landed == 0 || 2 * r->dropped > r->landed) return BAT_STRING_NOTICE_LINE_MISSED;
        return r->redraw.gain > GAIN_MOST ? BAT_STRING_NOTICE_LINE_STIFF : BAT_STRING_NOTICE_LINE_FAR;
    default: return BAT_STRING_NOTICE_LINE_FAR;
    }
}

/* What became of the knots, or that the rows beside the line moved further than it did. */
static void tell(bat_context *c, const bat_surface_redraw_report *report) {
    char text[64];
    if (report->gain > GAIN_TOLD) {
        snprintf(text, sizeof text, "%.2f", report->gain);
        bat_notice_value(c, BAT_STRING_NOTICE_LINE_GAIN, text);
        return;
    }
    snprintf(text, sizeof text, "%d \xc3\x97 %d \xe2\x86\x92 %d \xc3\x97 %d", report->knots_before[0],
             report->knots_before[1], report->knots_after[0], report->knots_after[1]);
    bat_notice_value(c, BAT_STRING_NOTICE_LINE_KNOTS, text);
}

void bat_surfacing_finish(bat_context *c, bat_surfacing *s) {
    bat_line_edit edit;
    bat_surfacing_follow(c, s);
    bat_status status = s->status;
    const bat_string refusal = bat_surfacing_refusal(s);
    if (s->made.surface && bat_surfacing_edit(c, s, &edit)) {
        status = bat_line_edit_commit(c, &edit, &s->made);
        if (status == BAT_OK) tell(c, &s->report.redraw);
    }
    if (status == BAT_MEMORY || (status != BAT_OK && refusal == BAT_STRING_COUNT))
        bat_notice_failure(c, status);
    else if (refusal != BAT_STRING_COUNT)
        bat_notice(c, refusal);
    bat_surfacing_drop(s);
}

const bat_surface_pair *bat_surfacing_pair(bat_context *c, bat_surfacing *s) {
    const bat_mirror plane = bat_symmetry_plane(c), *in = &s->paired_in;
    const bool same = s->paired == s->lit.object && s->paired_revision == c->session->revision &&
                      plane.on == in->on && plane.at[0] == in->at[0] && plane.at[1] == in->at[1] &&
                      plane.along[0] == in->along[0] && plane.along[1] == in->along[1];
    if (!same) s->pair = bat_surface_pair_of(c->session->document, s->lit.object, &plane);
    s->paired = s->lit.object, s->paired_revision = c->session->revision, s->paired_in = plane;
    return &s->pair;
}

static bool same_line(const bat_line *a, const bat_line *b) {
    return a->object == b->object && a->direction == b->direction && a->at[0] == b->at[0] &&
           a->at[1] == b->at[1];
}

bool bat_surfacing_reach(bat_context *c, bat_surfacing *s) {
    const bat_surface *surface = bat_surfacing_surface(c, s);
    bat_line_reach *reach = &s->reach, asked = {.revision = c->session->revision};
    bat_surface_redraw_report report = {.gain = 0};
    bat_line_edit edit;
    if (!surface || !bat_surfacing_edit(c, s, &edit)) return false;
    edit = bat_line_edit_paired(&edit, bat_surfacing_pair(c, s));
    asked.line = s->lit;
    memcpy(asked.lock, edit.lock, sizeof asked.lock);
    asked.radius = edit.reach;
    const bool same = reach->revision == asked.revision && same_line(&reach->line, &asked.line) &&
                      !memcmp(reach->lock, asked.lock, sizeof asked.lock) && reach->radius == asked.radius;
    if (same) return reach->known;
    asked.known = bat_line_edit_probe(surface_at(c, &edit, surface), &edit, &report) == BAT_OK;
    memcpy(asked.moved, report.moved, sizeof asked.moved);
    *reach = asked;
    return reach->known;
}
