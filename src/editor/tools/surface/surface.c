/*
 * The surface tool. A short stroke over a surface lights the parameter line that it means; a tap shows both lines
 * through the point and lights the nearer one. A tap on the other line lights that one; the grip slides the lit line; a
 * tap elsewhere lets go. A stroke that begins near the lit line redraws it, and the surface follows.
 *
 * NOT --down--> STROKE or, near the lit line, DRAW or, on the grip, SLIDE or, on the sheet's handle, TURN --up--> NOT. cancel: the line slides back, the
 * stroke is dropped; else the line is let go.
 */
#include "editor/tools/surface/state.h"
#include "base/real.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/input/samples.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tools/tool.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double TAP = 4, PADLOCK = 12; /* px */
enum { PIXELS_MAX = 1 << 16 };

/* ---- the stroke ---- */

static bat_status add_pixel(bat_surfacing *s, const bat_pointer *event) {
    if (s->count == PIXELS_MAX) return BAT_COUNT;
    if (s->count == s->room) {
        const size_t room = s->room ? 2 * s->room : 128;
        double *more = realloc(s->pixels, 2 * room * sizeof *more);
        if (!more) return BAT_MEMORY;
        s->pixels = more, s->room = room;
    }
    s->pixels[2 * s->count] = bat_samples_round(event->x, 100);
    s->pixels[2 * s->count + 1] = bat_samples_round(event->y, 100);
    s->count++;
    return BAT_OK;
}

static bool is_tap(const bat_surfacing *s) {
    for (size_t i = 1; i < s->count; i++)
        if (bat_hypot(s->pixels[2 * i] - s->pixels[0], s->pixels[2 * i + 1] - s->pixels[1]) > TAP)
            return false;
    return true;
}

/* ---- the pointer ---- */

static void hover(bat_context *c, void *state, const bat_pointer *event) {
    bat_surfacing *s = state;
    (void)c;
    s->hovering = true;
    s->device = event->device;
    s->hover[0] = event->x, s->hover[1] = event->y;
}

static void leave(bat_context *c, void *state) {
    (void)c;
    ((bat_surfacing *)state)->hovering = false;
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    bat_surfacing *s = state;
    hover(c, s, event);
    bat_seen_sync(c);
    bat_notice(c, BAT_STRING_COUNT);
    memcpy(s->start, s->hover, sizeof s->start);
    s->count = 0;
    s->before = s->lit;
    s->doing = bat_surfacing_on_grip(c, s, s->start)     ? BAT_LINING_SLIDE
               : bat_surfacing_on_handle(c, s, s->start) ? BAT_LINING_TURN
               : bat_surfacing_at_line(c, s, s->start)   ? BAT_LINING_DRAW
                                                         : BAT_LINING_STROKE;
    if (s->doing == BAT_LINING_TURN) bat_surfacing_turn_begin(c, s);
    bat_surfacing_drop(s);
    if (add_pixel(s, event) != BAT_OK) {
        s->doing = BAT_LINING_NOT;
        bat_notice_failure(c, BAT_MEMORY);
    }
}

/* Whether the pen draws. */
static bool strokes(const bat_surfacing *s) {
    return s->doing == BAT_LINING_STROKE || s->doing == BAT_LINING_DRAW;
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    bat_surfacing *s = state;
    if (s->doing == BAT_LINING_NOT || event->predicted) return;
    hover(c, s, event);
    if (strokes(s) && add_pixel(s, event) != BAT_OK) {
        s->doing = BAT_LINING_NOT;
        bat_surfacing_drop(s);
        bat_notice_failure(c, BAT_MEMORY);
    }
    s->due = s->doing == BAT_LINING_DRAW;
    if (s->doing == BAT_LINING_TURN) bat_surfacing_turn(c, s);
    const bat_surface *surface = bat_surfacing_surface(c, s);
    if (s->doing == BAT_LINING_SLIDE && surface)
        bat_surfacing_slide(c, surface, s->hover, (c->modifiers & BAT_SHIFT) != 0, &s->lit);
}

/* Lights what the marking or the tap means. */
static void choose(bat_context *c, bat_surfacing *s, bool tap) {
    const bat_stroke marking = {.dimension = 2, .count = s->count, .points = s->pixels};
    bat_line line;
    bat_status status = bat_surfacing_pick(c, &marking, tap, &line);
    if (status != BAT_OK) {
        bat_notice_failure(c, status);
        return;
    }
    s->lit = line;
    if (!line.object && !tap) bat_notice(c, BAT_STRING_NOTICE_NO_SURFACE);
}

/* A tap on a padlock locks one thing more there, and after the last of them nothing. */
static bool tap_padlock(bat_context *c, bat_surfacing *s) {
    for (int edge = 0; edge < BAT_LINE_EDGES; edge++) {
        double at[2], *lock = &c->settings->values[BAT_PROPERTY_LOCK_U_LOW + edge];
        if (!bat_surfacing_padlock(c, s, edge, at) ||
            bat_hypot(at[0] - s->start[0], at[1] - s->start[1]) > PADLOCK)
            continue;
        *lock = *lock < BAT_LOCK_MOST ? *lock + 1 : 0;
        bat_notice(c, (bat_string)(BAT_STRING_LOCK_NONE + (int)*lock));
        return true;
    }
    return false;
}

static void tap(bat_context *c, bat_surfacing *s) {
    if (!s->lit.object) {
        choose(c, s, true);
        return;
    }
    if (tap_padlock(c, s)) return;
    const int there = bat_surfacing_line_there(c, s, s->start);
    if (there == 2)
        s->lit.direction = s->lit.direction == BAT_U ? BAT_V : BAT_U;
    else if (there == 0)
        s->lit.object = 0;
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    bat_surfacing *s = state;
    (void)event;
    if (s->doing == BAT_LINING_DRAW && !is_tap(s)) bat_surfacing_finish(c, s);
    const bat_lining doing = s->doing;
    s->doing = BAT_LINING_NOT;
    bat_surfacing_drop(s);
    if (doing == BAT_LINING_TURN) bat_surfacing_turn_end(c, s);
    if (doing != BAT_LINING_STROKE && doing != BAT_LINING_DRAW) return;
    if (is_tap(s))
        tap(c, s);
    else if (doing == BAT_LINING_STROKE)
        choose(c, s, false);
}

/* First what the pen is doing, then the line. */
static bool cancel(bat_context *c, void *state) {
    bat_surfacing *s = state;
    if (s->doing == BAT_LINING_TURN) bat_surfacing_turn_back(c, s);
    if (s->doing != BAT_LINING_NOT) {
        s->lit = s->before;
        s->doing = BAT_LINING_NOT;
        bat_surfacing_drop(s);
        return true;
    }
    const bool any = s->lit.object != 0;
    s->lit.object = 0;
    return any;
}

/* Before undo: only what the pen is doing. */
static bool undo(bat_context *c, void *state) {
    return ((bat_surfacing *)state)->doing != BAT_LINING_NOT && cancel(c, state);
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    return ((const bat_surfacing *)state)->doing != BAT_LINING_NOT;
}

/* ---- the keyboard ---- */

/* Lights the middle line of the next surface, or the other line through the grip. */
static bat_status step(bat_context *c, bat_surfacing *s, int way) {
    const bat_document *document = c->session->document;
    const int count = bat_document_count(document);
    const bat_surface *surface = bat_surfacing_surface(c, s);
    if (surface && s->lit.direction == (way > 0 ? BAT_U : BAT_V)) {
        s->lit.direction = way > 0 ? BAT_V : BAT_U;
        return BAT_OK;
    }
    int i = surface ? bat_document_find(document, s->lit.object) : way > 0 ? -1 : count;
    for (i += way; i >= 0 && i < count; i += way) {
        surface = bat_object_surface(bat_document_at(document, i));
        if (!surface || bat_seen_out_of_reach(c, i)) continue;
        s->lit = (bat_line){bat_object_id(bat_document_at(document, i)), way > 0 ? BAT_U : BAT_V, {0}};
        for (int d = 0; d < 2; d++) {
            double domain[2];
            bat_surface_domain(surface, (bat_direction)d, domain);
            s->lit.at[d] = 0.5 * (domain[0] + domain[1]);
        }
        return BAT_OK;
    }
    s->lit.object = 0; /* the keyboard focus moves on to what follows the drawing */
    return BAT_STATE;
}

/* Moves the lit line by a hundredth of the width, with Shift a tenth; round where it is closed. */
static bat_status slide(bat_context *c, bat_surfacing *s, int way) {
    const bat_surface *surface = bat_surfacing_surface(c, s);
    double domain[2], *at = &s->lit.at[s->lit.direction];
    if (!surface) return BAT_STATE;
    bat_surface_domain(surface, s->lit.direction, domain);
    const double width = domain[1] - domain[0];
    *at += way * width * (c->modifiers & BAT_SHIFT ? 0.1 : 0.01);
    if (bat_surface_is_closed(surface, s->lit.direction))
        *at = domain[0] + (*at - domain[0]) - width * floor((*at - domain[0]) / width);
    else
        *at = fmin(fmax(*at, domain[0]), domain[1]);
    return BAT_OK;
}

/* To the next knot, or an edge. */
static bat_status to_knot(bat_context *c, bat_surfacing *s, int way) {
    const bat_surface *surface = bat_surfacing_surface(c, s);
    if (!surface) return BAT_STATE;
    const double *knots = bat_surface_knots(surface, s->lit.direction), at = s->lit.at[s->lit.direction];
    const int count = bat_surface_knot_count(surface, s->lit.direction);
    double domain[2], best = way > 0 ? INFINITY : -INFINITY;
    bat_surface_domain(surface, s->lit.direction, domain);
    for (int i = 0; i < count; i++) {
        if (knots[i] < domain[0] || knots[i] > domain[1]) continue;
        if (way > 0 ? knots[i] > at && knots[i] < best : knots[i] < at && knots[i] > best) best = knots[i];
    }
    if (isfinite(best)) s->lit.at[s->lit.direction] = best;
    return BAT_OK;
}

/* Half a span more or less. */
static bat_status change_reach(bat_context *c, int way) {
    const bat_property_row *row = bat_property_at(BAT_PROPERTY_LINE_REACH);
    double *reach = &c->settings->values[BAT_PROPERTY_LINE_REACH];
    *reach = fmin(fmax(*reach + way * row->step, row->low), row->high);
    return BAT_OK;
}

static bat_status command(bat_context *c, void *state, bat_command_id id) {
    bat_seen_sync(c);
    switch (id) {
    case BAT_COMMAND_POINT_NEXT: return step(c, state, 1);
    case BAT_COMMAND_POINT_PREVIOUS: return step(c, state, -1);
    case BAT_COMMAND_REACH_DOWN: return change_reach(c, -1);
    case BAT_COMMAND_REACH_UP: return change_reach(c, 1);
    case BAT_COMMAND_KNOT_NEXT: return to_knot(c, state, 1);
    case BAT_COMMAND_KNOT_PREVIOUS: return to_knot(c, state, -1);
    case BAT_COMMAND_NUDGE_LEFT:
    case BAT_COMMAND_NUDGE_DOWN: return slide(c, state, -1);
    case BAT_COMMAND_NUDGE_RIGHT:
    case BAT_COMMAND_NUDGE_UP: return slide(c, state, 1);
    default: return BAT_STATE;
    }
}

/* ---- what is shown ---- */

static void overlay(bat_context *c, void *state, bat_overlay *list) { bat_surfacing_show(c, state, list); }

static bat_string hint(const bat_context *c, const void *state) {
    const bat_surfacing *s = state;
    (void)c;
    if (s->doing == BAT_LINING_SLIDE) return BAT_STRING_HINT_LINE_SLIDE;
    if (s->doing == BAT_LINING_TURN) return BAT_STRING_HINT_LINE_TURN;
    if (s->doing == BAT_LINING_DRAW) {
        const bat_string refusal = s->count > 1 && !s->due ? bat_surfacing_refusal(s) : BAT_STRING_COUNT;
        return refusal != BAT_STRING_COUNT ? refusal
               : s->report.turned          ? BAT_STRING_HINT_LINE_TURNED
                                           : BAT_STRING_HINT_LINE_DRAW;
    }
    return s->lit.object ? BAT_STRING_HINT_LINE_LIT : BAT_STRING_HINT_SURFACE;
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    (void)c;
    const bat_lining doing = ((const bat_surfacing *)state)->doing;
    return doing == BAT_LINING_SLIDE || doing == BAT_LINING_TURN ? BAT_CURSOR_MOVE : BAT_CURSOR_PEN;
}

static void update(bat_context *c, void *state) {
    bat_surfacing *s = state;
    if (!is_tap(s)) bat_surfacing_follow(c, s);
}

static void readout(const bat_context *c, const void *state, bat_readout *out) {
    (void)c;
    const bat_surfacing *s = state;
    if (s->made.surface) out->report = &s->said;
}

static int guises(const bat_context *c, const void *state, bat_guise out[BAT_GUISES]) {
    (void)c;
    const bat_surfacing *s = state;
    const bat_line_made *made = &s->made;
    if (!made->surface) return 0;
    out[0] = (bat_guise){.object = s->lit.object, .surface = made->surface, .direction = s->lit.direction};
    memcpy(out[0].moved, s->report.redraw.moved, sizeof out[0].moved);
    if (!made->image) return 1;
    out[1] = (bat_guise){.object = made->twin, .surface = made->image, .direction = s->lit.direction};
    bat_surface_way_range(&made->way, made->image, &out[1].direction, out[0].moved, out[1].moved);
    return 2;
}

static void end(void *state) {
    bat_surfacing *s = state;
    bat_surfacing_drop(s);
    free(s->pixels);
}

static const char *check(const bat_context *c, const void *state) {
    const bat_surfacing *s = state;
    if (s->count > s->room) return "a marking is longer than its memory";
    if (s->doing != BAT_LINING_NOT && bat_contacts_count(&c->input->contacts, BAT_DUTY_TOOL, NULL) != 1)
        return "a line is marked or slides without a pointer";
    if (s->made.surface && s->doing != BAT_LINING_DRAW) return "a surface is shown that no stroke makes";
    return (s->doing == BAT_LINING_SLIDE || s->doing == BAT_LINING_TURN) && !s->before.object
               ? "a line slides that was not lit"
               : NULL;
}

const bat_tool *bat_tool_surface(void) {
    static const bat_tool tool = {.size = sizeof(bat_surfacing),
                                  .end = end,
                                  .hover = hover,
                                  .leave = leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .undo = undo,
                                  .command = command,
                                  .busy = busy,
                                  .update = update,
                                  .readout = readout,
                                  .guises = guises,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .cursor = cursor,
                                  .check = check};
    return &tool;
}
