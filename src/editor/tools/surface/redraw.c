/* Redrawing the lit line: while the pen is down and when it is lifted, by the same calls. */
#include "editor/tools/surface/state.h"
#include "base/real.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double GAIN_TOLD = 1.25, GAIN_MOST = 4;

/* The length of a pixel at the line's grip, document units. */
static double pixel_at(const bat_viewpoint *view, const double point[3]) {
    double pixel[2], depth = 0;
    if (view->height > 0) return view->height / view->size[1];
    if (bat_viewpoint_project(view, point, pixel, &depth) != BAT_OK) return 0;
    return 2 * depth * bat_tan(view->fov * (BAT_PI / 360)) / view->size[1];
}

bool bat_surfacing_edit(bat_context *c, bat_surfacing *s, bat_line_edit *out) {
    const bat_surface *surface = bat_surfacing_surface(c, s);
    double point[3];
    if (!surface) return false;
    bat_surface_eval(surface, s->lit.at[0], s->lit.at[1], 0, point);
    *out = (bat_line_edit){.object = s->lit.object,
                           .direction = s->lit.direction,
                           .at = s->lit.at[s->lit.direction],
                           .seen = s->seen,
                           .count = s->count,
                           .pixels = s->pixels};
    out->tolerance = fmin(
        fmax(c->settings->values[BAT_PROPERTY_TOLERANCE] * pixel_at(&s->seen, point), 1e-12), 1e12);
    return true;
}

void bat_surfacing_drop(bat_surfacing *s) {
    bat_surface_free(s->preview);
    s->preview = NULL;
    s->due = false;
}

void bat_surfacing_follow(bat_context *c, bat_surfacing *s) {
    bat_line_edit edit;
    bat_surface *made = NULL;
    if (s->doing != BAT_LINING_DRAW || !s->due) return;
    bat_surfacing_drop(s);
    if (!bat_surfacing_edit(c, s, &edit)) return;
    s->status = bat_line_edit_compute(c->session->document, &edit, &made, &s->report);
    s->preview = made;
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
    if (s->preview && bat_surfacing_edit(c, s, &edit)) {
        status = bat_line_edit_commit(c, &edit, s->preview);
        if (status == BAT_OK) tell(c, &s->report.redraw);
    }
    if (status == BAT_MEMORY || (status != BAT_OK && refusal == BAT_STRING_COUNT))
        bat_notice_failure(c, status);
    else if (refusal != BAT_STRING_COUNT)
        bat_notice(c, refusal);
    bat_surfacing_drop(s);
}

bool bat_surfacing_reach(bat_context *c, bat_surfacing *s) {
    const bat_surface *surface = bat_surfacing_surface(c, s);
    bat_line_reach *reach = &s->reach;
    if (!surface) return false;
    if (reach->revision == c->session->revision && !memcmp(&reach->line, &s->lit, sizeof s->lit))
        return reach->known;
    bat_line_edit edit;
    bat_surface_redraw_report report = {.gain = 0};
    *reach = (bat_line_reach){.line = s->lit, .revision = c->session->revision};
    bat_status status = bat_surfacing_edit(c, s, &edit) ? bat_line_edit_probe(surface, &edit, &report)
                                                        : BAT_ARGUMENT;
    reach->known = status == BAT_OK;
    if (reach->known) memcpy(reach->moved, report.moved, sizeof reach->moved);
    return reach->known;
}
