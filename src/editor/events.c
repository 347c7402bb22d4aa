/* Entry point of events: invalid numbers are rejected, and every contact is given its duty. */
#include "document/document.h"
#include "editor/commands/three.h"
#include "editor/tables/keys.h"
#include "editor/commands/dispatch.h"
#include "editor/editor.h"
#include "editor/fingers.h"
#include "editor/show/ruler.h"
#include "base/real.h"
#include "editor/input/arrivals.h"
#include "editor/input/samples.h"
#include "editor/pick/pivot.h"
#include "editor/tools/gazes/gazes.h"
#include "editor/tools/keyed/range.h"
#include "editor/tools/modes/guides.h"
#include "editor/tools/modes/reach.h"
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static const double PINCH_SOON = 250; /* ms within which a second finger turns a stroke into a pinch */
static const double PINCH_NEAR = 24;  /* px that the first finger may have moved meanwhile */
static const double HOVERS = 500;     /* ms since a hovering pen was last heard of */
static const double AT_REST = 6; /* px that a finger may move from where it lay before the view follows */

static double bounded(double value, double low, double high, double otherwise) {
    return isfinite(value) ? fmin(fmax(value, low), high) : otherwise;
}

/* Makes the numbers valid. False: the event has no usable position, drop it. */
static bool clean(const bat_context *c, bat_pointer *event, const bat_contact *contact) {
    bool placed = fabs(event->x) <= BAT_PIXELS_MAX && fabs(event->y) <= BAT_PIXELS_MAX;
    if (!placed) {
        bool ends = event->phase == BAT_POINTER_UP || event->phase == BAT_POINTER_CANCEL;
        if (event->phase == BAT_POINTER_LEAVE)
            event->x = event->y = 0;
        else if (ends && contact) { /* a pointer-up must not be lost, or the contact would stay for ever */
            event->x = contact->at[0];
            event->y = contact->at[1];
        } else
            return false;
    }
    event->x = bat_samples_round(event->x, 100);
    event->y = bat_samples_round(event->y, 100);
    event->pressure = bat_samples_round(bounded(event->pressure, 0, 1, 0), 1e4);
    event->tilt_x = bat_samples_round(bounded(event->tilt_x, -90, 90, 0), 100);
    event->tilt_y = bat_samples_round(bounded(event->tilt_y, -90, 90, 0), 100);
    event->twist = bounded(event->twist, 0, 360, 0);
    event->width = bounded(event->width, 0, BAT_PIXELS_MAX, 0);
    event->height = bounded(event->height, 0, BAT_PIXELS_MAX, 0);
    if (!bat_arrival_timed(event->time)) event->time = c->time;
    return true;
}

static void set_modifiers(bat_context *c, uint32_t modifiers) {
    if (c->modifiers == modifiers) return;
    c->modifiers = modifiers;
    const bat_slot *tool = bat_toolbox_tool(c);
    if (tool->is->modifiers) tool->is->modifiers(c, tool->state);
}

static void cancel_tool(bat_context *c) {
    const bat_slot *tool = bat_toolbox_tool(c);
    if (tool->is->cancel) tool->is->cancel(c, tool->state);
}

/* When the pen is turned round, drops what awaits confirmation; what is chosen stays. */
static void cancel_uncommitted(bat_context *c) {
    const bat_slot *tool = bat_toolbox_tool(c);
    if (tool->is->undo)
        tool->is->undo(c, tool->state);
    else
        cancel_tool(c);
}

/* The function of the barrel button, held as the pen comes down. */
enum { BARREL_SMOOTHS, BARREL_PANS, BARREL_IS_NOTHING, BARREL_ORBITS };
static bool barrel_is(const bat_context *c, const bat_pointer *event, int way) {
    return event->device == BAT_DEVICE_PEN && event->buttons & BAT_BUTTON_SECONDARY &&
           c->settings->values[BAT_PROPERTY_BARREL_BUTTON] == way;
}

/* Until it is lifted, the pen is another tool. */
static void turn(bat_context *c, unsigned trait) {
    bat_range_end(c);
    const bat_slot *tool = bat_toolbox_tool(c);
    cancel_uncommitted(c);
    if (tool->is->leave) tool->is->leave(c, tool->state);
    c->input->brush = trait;
}

/* Of a contact that comes down while no other is at work. */
static bat_duty assign_first(bat_context *c, const bat_pointer *event, bool only_pens) {
    const bool tilted = bat_stage_tilted(c->stage), pen = event->device == BAT_DEVICE_PEN;
    const bool middle = event->buttons & BAT_BUTTON_MIDDLE, alt = event->modifiers & BAT_ALT;
    const bool second = event->buttons & BAT_BUTTON_SECONDARY;
    if (c->moves->through) return BAT_DUTY_IGNORED; /* what is seen is not the view */
    if ((event->device == BAT_DEVICE_MOUSE && second) || (middle && alt) || (pen && second && tilted) ||
        barrel_is(c, event, BARREL_ORBITS))
        return BAT_DUTY_ORBIT;
    if (event->device == BAT_DEVICE_TOUCH && only_pens) return tilted ? BAT_DUTY_ORBIT : BAT_DUTY_NAVIGATE;
    if (c->session->read_only) return BAT_DUTY_NAVIGATE;
    if (event->buttons & BAT_BUTTON_PRIMARY && !c->input->holding_pan && !alt && c->input->three.on &&
        bat_three_pick(c, (double[]){event->x, event->y}))
        return BAT_DUTY_IGNORED;
    if (event->buttons & BAT_BUTTON_ERASER || barrel_is(c, event, BARREL_SMOOTHS)) {
        turn(c, event->buttons & BAT_BUTTON_ERASER ? BAT_ERASES : BAT_SMOOTHS);
        return BAT_DUTY_TOOL;
    }
    if (event->buttons & BAT_BUTTON_PRIMARY && !c->input->holding_pan && bat_guides_take(c, event))
        return BAT_DUTY_TOOL;
    if (c->moves->camera && event->buttons & BAT_BUTTON_PRIMARY && !c->input->holding_pan &&
        bat_gazes_take(c, event))
        return BAT_DUTY_TOOL;
    if (event->buttons & BAT_BUTTON_PRIMARY && !c->input->holding_pan &&
        bat_document_has_followers(c->session->document) && bat_reach_take(c, event))
        return BAT_DUTY_TOOL;
    if (c->input->holding_pan || middle || barrel_is(c, event, BARREL_PANS) ||
        bat_tool_at(c->choice->tool)->traits & BAT_NAVIGATES)
        return BAT_DUTY_NAVIGATE;
    if (!(event->buttons & BAT_BUTTON_PRIMARY)) return BAT_DUTY_IGNORED;
    if (bat_toolbox_faces(c)) return BAT_DUTY_TOOL;
    bat_notice_tilted(c);
    return BAT_DUTY_IGNORED;
}

/* Of a finger that joins others which move the view: two pinch, three turn. Whatever has begun goes on alone. */
static bat_duty assign_finger(bat_context *c) {
    bat_contacts *contacts = &c->input->contacts;
    int moving = 0;
    bool begun = c->input->orbit.on;
    for (int i = 0; i < contacts->count; i++) {
        const bat_contact *contact = &contacts->list[i];
        if (contact->duty != BAT_DUTY_NAVIGATE && contact->duty != BAT_DUTY_ORBIT) continue;
        if (contact->device != BAT_DEVICE_TOUCH) return BAT_DUTY_IGNORED;
        moving++;
        begun = begun || (contact->far > AT_REST && contact->duty == BAT_DUTY_NAVIGATE);
    }
    if (moving > 2 || (begun && (moving == 2 || c->input->orbit.on))) return BAT_DUTY_IGNORED;
    const bat_duty duty = moving == 2 ? BAT_DUTY_ORBIT : BAT_DUTY_NAVIGATE;
    for (int i = 0; i < contacts->count; i++)
        if (contacts->list[i].duty == BAT_DUTY_NAVIGATE || contacts->list[i].duty == BAT_DUTY_ORBIT)
            contacts->list[i].duty = duty;
    if (duty == BAT_DUTY_NAVIGATE) bat_contacts_pinch(c);
    return duty;
}

/* Whether a touch belongs to the hand whose pen hovers. A pen in a hand is never quite still: it sends events. */
static bool rests(const bat_context *c, const bat_pointer *event) {
    return event->device == BAT_DEVICE_TOUCH && c->input->pen_hovers &&
           event->time - c->input->pen_time <= HOVERS &&
           c->settings->values[BAT_PROPERTY_PALM_REJECTION] != 0;
}

/* Decides the duty of a contact that comes down; may end what the tool is doing. */
static bat_duty assign(bat_context *c, const bat_pointer *event) {
    bat_contacts *contacts = &c->input->contacts;
    int at_work = -1;
    bool working = bat_contacts_count(contacts, BAT_DUTY_TOOL, &at_work) > 0;
    bool moving = bat_contacts_count(contacts, BAT_DUTY_NAVIGATE, NULL) > 0 ||
                  bat_contacts_count(contacts, BAT_DUTY_ORBIT, NULL) > 0;
    bool only_pens = c->input->pen_seen && c->settings->values[BAT_PROPERTY_PALM_REJECTION] != 0;

    if (bat_contact_is_palm(event) || rests(c, event)) return BAT_DUTY_IGNORED;
    if (working) {
        bat_contact *first = &contacts->list[at_work];
        if (event->device != BAT_DEVICE_TOUCH || first->device != BAT_DEVICE_TOUCH) return BAT_DUTY_IGNORED;
        bool soon = event->time - first->start_time <= PINCH_SOON;
        bool near = bat_hypot(first->at[0] - first->start[0], first->at[1] - first->start[1]) <= PINCH_NEAR;
        if (!soon || !near) return BAT_DUTY_IGNORED;
        cancel_tool(c);
        bat_notice(c, BAT_STRING_COUNT); /* a pinch needs no notice */
        first->duty = BAT_DUTY_NAVIGATE;
        bat_contacts_pinch(c);
        return BAT_DUTY_NAVIGATE;
    }
    if (c->session->transaction.open) return BAT_DUTY_IGNORED;
    if (moving) return event->device == BAT_DEVICE_TOUCH ? assign_finger(c) : BAT_DUTY_IGNORED;
    return assign_first(c, event, only_pens);
}

/* Records where the pointer is, for parts that ask between events. */
static void point(bat_context *c, const bat_pointer *event) {
    c->input->pen_near = true;
    c->input->points = event->device;
    c->input->pen[0] = event->x;
    c->input->pen[1] = event->y;
}

static void down(bat_context *c, const bat_pointer *event) {
    c->input->pan_time = -1;
    bat_contacts *contacts = &c->input->contacts;
    bool finger = event->device == BAT_DEVICE_TOUCH;
    if (!finger) bat_fingers_yield(c);
    if (!bat_contacts_room(contacts, event->device)) return;
    bat_taps_down(c, event, bat_toolbox_readout(c).waits);
    bool first = !bat_contacts_count(contacts, BAT_DUTY_NAVIGATE, NULL) &&
                 !bat_contacts_count(contacts, BAT_DUTY_ORBIT, NULL);
    bat_duty duty = assign(c, event);
    if ((duty == BAT_DUTY_NAVIGATE || duty == BAT_DUTY_ORBIT) && first) bat_fingers_rest(c);
    if (duty == BAT_DUTY_TOOL) bat_range_end(c); /* the pointer takes over from the keys */
    if (duty == BAT_DUTY_TOOL || !finger) point(c, event);
    contacts->list[contacts->count++] = (bat_contact){.id = event->contact,
                                                      .device = event->device,
                                                      .duty = duty,
                                                      .at = {event->x, event->y},
                                                      .start = {event->x, event->y},
                                                      .start_time = event->time};
    if (duty == BAT_DUTY_ORBIT) bat_orbit_begin(c);
    const bat_slot *tool = bat_toolbox_tool(c);
    if (duty != BAT_DUTY_TOOL) return;
    c->input->trail.count = 0;
    bat_trail_add(&c->input->trail, c->input->pen, event->time);
    const ptrdiff_t at =
        tool - c->toolbox->slots; /* modes, which come after the tools, are left when they are cancelled */
    if (at < BAT_TOOL_COUNT)
        bat_taken_begin(&c->input->taken, c->stage, (int)c->choice->tool, c->input->brush, event);
    else
        bat_taken_forget(&c->input->taken);
    if (finger) c->input->fingers.before = c->input->fingers.after = c->session->history.state;
    if (tool->is->down) tool->is->down(c, tool->state, event);
}

/* The contact turns the view, about what lies under the contacts. */
static void orbit(bat_context *c, int index, const double to[2]) {
    const bool finger = c->input->contacts.list[index].device == BAT_DEVICE_TOUCH;
    const bool starts = bat_orbit_starts(c, index, to);
    if (finger && (starts || c->input->orbit.on)) bat_fingers_before(c);
    if (starts) {
        bat_pivot_set(c, c->input->orbit.middle);
        bat_orbit_start(c);
    }
    bat_orbit_move(c, index, to); /* also by the move that starts it, which may be the only one */
    if (finger && c->input->orbit.on) bat_fingers_after(c);
}

static void move(bat_context *c, const bat_pointer *event, int index) {
    bat_contact *contact = &c->input->contacts.list[index];
    const bat_slot *tool = bat_toolbox_tool(c);
    bool finger = contact->device == BAT_DEVICE_TOUCH;
    if (bat_contact_is_palm(event) || rests(c, event))
        bat_finger_stop(c, index); /* it came down edge first */
    contact->far = fmax(contact->far, bat_hypot(event->x - contact->start[0], event->y - contact->start[1]));
    bat_taps_move(c, event, contact);
    if (contact->duty == BAT_DUTY_TOOL || !finger) point(c, event);
    if (contact->duty == BAT_DUTY_TOOL) {
        bat_trail_add(&c->input->trail, c->input->pen, event->time);
        bat_taken_add(&c->input->taken, event);
        if (tool->is->move) tool->is->move(c, tool->state, event);
    } else if (contact->duty == BAT_DUTY_NAVIGATE) {
        if (finger && contact->far <= AT_REST) return;
        if (finger) bat_fingers_before(c);
        bat_contacts_navigate(c, index, (double[]){event->x, event->y});
        if (finger) bat_fingers_after(c);
    } else if (contact->duty == BAT_DUTY_ORBIT) {
        orbit(c, index, (double[]){event->x, event->y});
    }
    contact->at[0] = event->x;
    contact->at[1] = event->y;
}

/* Predicted positions of the pen: for the overlay only. */
static void predict(bat_context *c, const bat_pointer *event, int index) {
    const bat_slot *tool = bat_toolbox_tool(c);
    if (c->input->contacts.list[index].duty != BAT_DUTY_TOOL || !tool->is->move) return;
    double guess[2] = {event->x, event->y};
    bat_trail_bound(&c->input->trail, guess);
    bat_pointer bound = *event;
    bound.x = guess[0];
    bound.y = guess[1];
    tool->is->move(c, tool->state, &bound);
}

/* When the pen is lifted: back to the chosen tool. */
static void turn_back(bat_context *c) {
    if (!c->input->brush) return;
    const bat_slot *tool = bat_toolbox_tool(c);
    if (tool->is->leave) tool->is->leave(c, tool->state);
    c->input->brush = 0;
}

/* The system ends a gesture that the user has not ended: it can be brought back, unless it was hardly one. */
static void take_away(bat_context *c, const bat_contact *contact) {
    const bool busy = bat_toolbox_busy(c);
    cancel_tool(c);
    c->input->taken.offered = busy && c->input->taken.count && contact->far > AT_REST;
    if (c->input->taken.offered) bat_notice_taken_away(c);
}

static void end(bat_context *c, const bat_pointer *event, int index) {
    if (event->phase == BAT_POINTER_UP) move(c, event, index);
    const bat_contact contact = c->input->contacts.list[index];
    if (contact.duty == BAT_DUTY_ORBIT && event->phase == BAT_POINTER_CANCEL)
        bat_orbit_cancel(c);
    else if (contact.duty == BAT_DUTY_ORBIT)
        bat_orbit_end(c);
    bat_contacts_remove(&c->input->contacts, index);
    const bat_slot *tool = bat_toolbox_tool(c);
    if (contact.duty == BAT_DUTY_TOOL) {
        if (event->phase == BAT_POINTER_CANCEL)
            take_away(c, &contact);
        else if (tool->is->up)
            tool->is->up(c, tool->state, event);
        if (!c->input->taken.offered) bat_taken_forget(&c->input->taken);
        turn_back(c);
        if (event->device == BAT_DEVICE_TOUCH) bat_fingers_step(c, &contact);
    }
    bat_tapped tapped = bat_taps_end(c, event, bat_toolbox_readout(c).waits);
    if (tapped) bat_command_run(c, tapped == BAT_TAPPED_REDO ? BAT_COMMAND_REDO : BAT_COMMAND_UNDO, true);
}

static void see_pen(bat_context *c, const bat_pointer *event) {
    if (!c->input->pen_seen && c->settings->values[BAT_PROPERTY_PALM_REJECTION] != 0)
        bat_fingers_meet_pen(c, event->time);
    c->input->pen_seen = true;
    c->input->pen_time = event->time;
    c->input->pen_hovers = event->phase == BAT_POINTER_HOVER;
    c->input->taps.spoiled = true; /* rules out a tap */
}

/* A contact that came down without a usable position comes down with the first move that has one. */
static void await(bat_context *c, bat_pointer *event, bool dropped) {
    bat_awaited *awaited = &c->input->awaited;
    const bool that = awaited->device == event->device && awaited->contact == event->contact;
    if (dropped && event->phase == BAT_POINTER_DOWN) {
        *awaited = (bat_awaited){true, event->device, event->contact};
    } else if (awaited->on && that && !dropped && !event->predicted) {
        if (event->phase == BAT_POINTER_MOVE) event->phase = BAT_POINTER_DOWN;
        awaited->on = false;
    }
}

static void one(bat_context *c, bat_pointer event) {
    if ((unsigned)event.phase > BAT_POINTER_LEAVE || (unsigned)event.device > BAT_DEVICE_TOUCH) return;
    int index = bat_contacts_find(&c->input->contacts, event.device, event.contact);
    const bool usable = clean(c, &event, index < 0 ? NULL : &c->input->contacts.list[index]);
    if (index < 0) await(c, &event, !usable);
    if (!usable) return;
    if (event.predicted) {
        if (index >= 0 && event.phase == BAT_POINTER_MOVE) predict(c, &event, index);
        return;
    }
    c->time = event.time;
    c->session->freed = BAT_STRING_COUNT;
    c->session->refused = false;
    if (event.device == BAT_DEVICE_PEN) see_pen(c, &event);
    set_modifiers(c, event.modifiers);
    const bat_slot *tool = bat_toolbox_tool(c);
    switch (event.phase) {
    case BAT_POINTER_DOWN:
        bat_views_arrive(c->views, &c->stage->view);
        if (index >= 0)
            move(c, &event, index); /* another button of the same pointer */
        else
            down(c, &event);
        break;
    case BAT_POINTER_UP:
    case BAT_POINTER_CANCEL:
        if (index >= 0) end(c, &event, index);
        break;
    case BAT_POINTER_MOVE:
    case BAT_POINTER_HOVER:
        if (index >= 0)
            move(c, &event, index);
        else if (event.device == BAT_DEVICE_TOUCH) /* there are fingers, which hints then speak to */
            c->input->points = event.device;
        else {
            point(c, &event);
            if (!bat_contacts_clear(c)) break;
            if (bat_ruler_at(c, c->input->pen) < 0 && tool->is->hover && bat_toolbox_faces(c))
                tool->is->hover(c, tool->state, &event);
            else if (tool->is->leave)
                tool->is->leave(c, tool->state);
        }
        break;
    case BAT_POINTER_LEAVE:
        if (event.device == BAT_DEVICE_TOUCH && c->input->points != BAT_DEVICE_TOUCH) break;
        c->input->pen_near = false;
        if (index < 0 && tool->is->leave && !bat_toolbox_busy(c)) tool->is->leave(c, tool->state);
        break;
    }
}

void bat_editor_pointer(bat_editor *editor, size_t count, const bat_pointer *events) {
    bat_context *c = &editor->context;
    for (size_t i = 0, run; i < count; i += run) {
        run = bat_arrivals_run(events + i, count - i);
        bat_arrival *sorted = bat_arrivals_sort(events + i, run);
        for (size_t k = 0; k < run; k++) {
            one(c, sorted ? *sorted[k].event : events[i + k]);
            bat_toolbox_settle(c);
        }
        free(sorted);
    }
}

void bat_editor_wheel(bat_editor *editor, double x, double y, double dx, double dy, uint32_t modifiers,
                      double time) {
    bat_context *c = &editor->context;
    if (!isfinite(x) || !isfinite(y) || !isfinite(dx) || !isfinite(dy)) return;
    c->time = bounded(time, 0, 1e13, c->time);
    c->input->pan_time = -1;
    bat_views_arrive(c->views, &c->stage->view);
    /* A stroke's samples are in the pixels of one view. */
    if (bat_toolbox_busy(c) || c->moves->through) return;
    double at[2] = {bounded(x, -BAT_PIXELS_MAX, BAT_PIXELS_MAX, 0),
                    bounded(y, -BAT_PIXELS_MAX, BAT_PIXELS_MAX, 0)};
    if (modifiers & BAT_CTRL) {
        bat_stage_zoom(c->stage, at, bat_exp(-bounded(dy, -300, 300, 0) / 200));
    } else {
        if (modifiers & BAT_SHIFT && dx == 0) {
            dx = dy;
            dy = 0;
        }
        double to[2] = {-bounded(dx, -1e4, 1e4, 0), -bounded(dy, -1e4, 1e4, 0)};
        bat_stage_pan(c->stage, (double[]){0, 0}, to);
    }
}

bool bat_editor_key(bat_editor *editor, const char *key, bool pressed, uint32_t modifiers, double time) {
    bat_context *c = &editor->context;
    if (!key) return false;
    c->time = bounded(time, 0, 1e13, c->time);
    set_modifiers(c, modifiers);
    bool known = false, face_on = false;
    for (int i = 0; i < BAT_COMMAND_COUNT; i++) {
        bat_command_id id = (bat_command_id)i;
        bool hold = bat_command_at(id)->hold;
        /* A held key is released whatever other keys are down by then. */
        if (!pressed && !(hold && bat_keys_match(c->settings->keys[i], key, 0))) continue;
        if (pressed && !bat_keys_match(c->settings->keys[i], key, modifiers)) continue;
        if (bat_command_at(id)->when == BAT_WHEN_HOST && modifiers & (BAT_CTRL | BAT_META)) return false;
        bat_status status = bat_command_run(c, id, pressed);
        bat_toolbox_settle(c);
        if (status == BAT_OK) return true;
        face_on = face_on || !bat_command_faces(c, id);
        known = true; /* it found nothing to do: the next command with this key may */
    }
    if (face_on && strcmp(key, "Tab") != 0 && strcmp(key, "Enter") != 0) bat_notice_tilted(c);
    /* Enter, Escape and Tab go to the host when unused; shortcuts with Ctrl must not reach the browser. */
    return known && modifiers & (BAT_CTRL | BAT_META);
}

void bat_editor_resize(bat_editor *editor, double width, double height, double pixel_ratio) {
    bat_context *c = &editor->context;
    bat_view *view = &c->stage->view;
    double middle[2];
    bat_views_arrive(c->views, view);
    bool had_size = view->width > 0 && view->height > 0, busy = bat_toolbox_busy(c);
    bat_view_to_document(view, (double[]){view->width / 2, view->height / 2}, middle);
    view->width = bounded(width, 0, BAT_PIXELS_MAX, 0);
    view->height = bounded(height, 0, BAT_PIXELS_MAX, 0);
    view->ratio = bounded(pixel_ratio, 0.1, 16, 1);
    if (c->stage->view.fit_wanted && !busy) {
        if (bat_seen_fit(c)) c->stage->view.fit_wanted = false;
    } else if (had_size && view->width > 0 && view->height > 0 && !busy) {
        /* The middle of the window keeps its document point. */
        double screen[2];
        bat_view_to_screen(view, middle, screen);
        bat_view_pan(view, screen, (double[]){view->width / 2, view->height / 2});
    }
}

void bat_editor_glide(bat_editor *editor, double share) {
    bat_context *c = &editor->context;
    if (isfinite(share)) bat_views_glide(c->views, &c->stage->view, share);
}
