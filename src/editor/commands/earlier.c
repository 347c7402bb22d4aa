/*
 * One curve as it was before: every shape that it had in the steps that can be undone, from the first to what it is now, along a
 * slider; shown over the drawing, which stays as it is until one is kept. The objects of the history are whole values, so nothing
 * is replayed.
 */
#include "base/box.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/commands/tuning.h"
#include "editor/edit/arrange.h"
#include "editor/edit/outlining.h"
#include "editor/session/journal_line.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/commands.h"
#include "editor/tables/tables.h"
#include "editor/view/stage.h"
#include <batten/paint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* One shape, and what made it: a string, BAT_STRING_COUNT: it was there at first. */
typedef struct shape {
    const bat_object *object; /* of the history */
    int label;
} shape;

typedef struct shapes {
    shape *list;
    int count;
} shapes;

/* Copies of an object share their curves as long as these are the same. */
static bool same_curves(const bat_object *a, const bat_object *b) {
    bool same = bat_object_curve_count(a) == bat_object_curve_count(b);
    for (int i = 0; same && i < bat_object_curve_count(a); i++)
        same = bat_object_curve(a, i) == bat_object_curve(b, i) ||
               bat_curve_is_equal(bat_object_curve(a, i), bat_object_curve(b, i));
    return same;
}

static void add(shapes *all, const bat_object *object, int label) {
    if (!bat_outlining_is_flat(object)) return;
    if (all->count && same_curves(all->list[all->count - 1].object, object))
        all->list[all->count - 1].object = object;
    else
        all->list[all->count++] = (shape){object, label};
}

/* The shapes of an object, oldest first; the last is what it is now. all->list is to be freed. O(changes of the history). */
static bat_status find(const bat_context *c, bat_id id, shapes *all) {
    const bat_history *history = &c->session->history;
    size_t most = 1;
    for (int i = 0; i < history->done; i++) most += 2 * (size_t)history->steps[i].count;
    *all = (shapes){malloc(most * sizeof *all->list), 0};
    if (!all->list) return BAT_MEMORY;
    for (int i = 0; i < history->done; i++) {
        const bat_step *step = &history->steps[i];
        for (int k = 0; k < step->count; k++) {
            const bat_object *before = step->deltas[k].before, *after = step->deltas[k].after;
            if (before && !all->count && bat_object_id(before) == id) add(all, before, BAT_STRING_COUNT);
            if (after && bat_object_id(after) == id) add(all, after, step->label);
        }
    }
    return BAT_OK;
}

static bool differs(const bat_object *was, const bat_object *now) {
    return was && bat_object_id(was) == bat_object_id(now) && bat_outlining_is_flat(was) &&
           !same_curves(was, now);
}

/* Newest first, back to the step after which the same object was asked for last. */
static bool had_another(const bat_history *history, const bat_object *now, bat_tuning_past *past) {
    uint64_t found = 0;
    for (int i = history->done - 1; i >= 0 && !found; i--) {
        const bat_step *step = &history->steps[i];
        if (past->object == bat_object_id(now) && past->state == step->after) {
            found = past->step >= history->steps[0].after ? past->step : 0; /* else that step was dropped */
            break;
        }
        for (int k = 0; k < step->count && !found; k++)
            if (differs(step->deltas[k].before, now) || differs(step->deltas[k].after, now))
                found = step->after;
    }
    *past = (bat_tuning_past){bat_object_id(now), history->state, found};
    return found != 0;
}

static int place_of(double amount, const shapes *all) { return (int)floor(amount * (all->count - 1) + 0.5); }

static bat_status again(bat_context *c, double amount, bool done) {
    (void)done; /* a shape is taken by keeping it alone */
    bat_tuning *t = c->tuning;
    shapes all;
    if (!(amount >= 0 && amount <= 1)) return BAT_ARGUMENT;
    bat_status status = find(c, bat_object_id(t->before[0]), &all);
    const int place = status == BAT_OK ? place_of(amount, &all) : 0;
    bat_tuning_unshow(t);
    if (status == BAT_OK && place < all.count - 1) {
        const bat_object *was = all.list[place].object;
        for (int i = 0; i < bat_object_curve_count(was) && status == BAT_OK; i++) {
            bat_curve *curve = NULL;
            status = bat_curve_copy(bat_object_curve(was, i), &curve);
            if (status == BAT_OK) status = bat_tuning_add(t, curve);
        }
    }
    free(all.list);
    if (status == BAT_OK) {
        t->amount = amount;
        t->version++;
        return BAT_OK;
    }
    bat_tuning_unshow(t);
    bat_notice_failure(c, status);
    return status;
}

/* The object as it was, with the name, the place in the tree and the look that it has now. */
static bat_status as_now(const bat_object *was, const bat_object *now, bat_object **out) {
    static const bat_paint none;
    const bat_paint *paint = bat_object_paint(now);
    bat_object *made[5] = {NULL};
    bat_status status = bat_object_with_style(was, bat_object_style(now), &made[0]);
    if (status == BAT_OK) status = bat_object_with_paint(made[0], paint ? paint : &none, &made[1]);
    if (status == BAT_OK) status = bat_object_with_parent(made[1], bat_object_parent(now), &made[2]);
    if (status == BAT_OK) status = bat_object_with_name(made[2], bat_object_name(now), &made[3]);
    if (status == BAT_OK)
        status = bat_object_with_state(made[3], bat_object_is_hidden(now), bat_object_is_locked(now),
                                       &made[4]);
    for (int i = 0; i < 4; i++) bat_object_release(made[i]);
    if (status == BAT_OK) *out = made[4];
    return status;
}

static bat_status keep(bat_context *c) {
    const bat_id id = bat_object_id(c->tuning->before[0]);
    const int index = bat_document_find(c->session->document, id);
    shapes all;
    bat_object *made = NULL;
    bat_status status = find(c, id, &all);
    const int place = status == BAT_OK ? place_of(c->tuning->amount, &all) : 0;
    if (status == BAT_OK && place < all.count - 1) {
        status = as_now(all.list[place].object, bat_document_at(c->session->document, index), &made);
        if (status == BAT_OK) status = bat_transaction_begin(c);
        if (status == BAT_OK)
            status = bat_transaction_end(c, bat_transaction_replace(c, index, made),
                                         BAT_STRING_COMMAND_CURVE_EARLIER);
    }
    bat_object_release(made);
    free(all.list);
    bat_tuning_free(c->tuning);
    if (status != BAT_OK) bat_notice_failure(c, status);
    return status;
}

static bat_status choose(bat_context *c, int way) { return way > 0 ? BAT_ARGUMENT : keep(c); }

static void write(bat_context *c, bat_text *text) {
    shapes all;
    double seen[4];
    bat_tuning_look(c->stage, c->tuning->around, seen);
    bat_text_string(text, ",\"of\":\"earlier\",\"around\":");
    bat_line_numbers(text, seen, 4, 1);
    if (find(c, bat_object_id(c->tuning->before[0]), &all) == BAT_OK && all.count > 1) {
        const int label = all.list[place_of(c->tuning->amount, &all)].label;
        bat_text_string(text, ",\"step\":");
        bat_line_number(text, 1.0 / (all.count - 1));
        bat_text_string(text, ",\"said\":");
        bat_text_json_string(
            text, bat_word(c, label == BAT_STRING_COUNT ? BAT_STRING_HISTORY_BEGIN : (bat_string)label));
    }
    free(all.list);
    bat_text_string(text, ",\"words\":[");
    bat_text_json_string(text, bat_word(c, BAT_STRING_EARLIER_KEEP));
}

static const bat_tuning_kind earlier = {
    BAT_STRING_COMMAND_CURVE_EARLIER, again, NULL, choose, NULL, write, keep, NULL};

/* The one object that is selected, or in the group that is; BAT_STATE: there is no such one. */
static bat_status one_selected(bat_context *c, int *index) {
    int *members = NULL, count = 0, found = 0;
    bat_status status = bat_arrange_members(c, &members, &count);
    for (int i = 0; i < count && status == BAT_OK; i++)
        if (!bat_object_is_group(bat_document_at(c->session->document, members[i]))) {
            *index = members[i];
            found++;
        }
    free(members);
    return status == BAT_OK && found != 1 ? BAT_STATE : status;
}

bool bat_tuning_has_earlier(bat_context *c) {
    int index = 0;
    if (one_selected(c, &index) != BAT_OK) return false;
    const bat_object *now = bat_document_at(c->session->document, index);
    return bat_outlining_is_flat(now) && had_another(&c->session->history, now, &c->tuning->past);
}

bat_status bat_command_curve_earlier(bat_context *c, bat_command_id id) {
    (void)id;
    bat_tuning *t = c->tuning;
    int index = 0;
    shapes all = {0};
    bat_tuning_free(t);
    bat_status status = one_selected(c, &index);
    if (status != BAT_OK)
        return bat_notice_refuse(c, status,
                                 status == BAT_STATE ? BAT_STRING_NOTICE_NO_EARLIER : BAT_STRING_COUNT);
    const bat_object *now = bat_document_at(c->session->document, index);
    status = find(c, bat_object_id(now), &all);
    const bool some = status == BAT_OK && all.count > 1;
    double around[4];
    bat_box_nothing(around);
    for (int i = 0; i < all.count; i++) {
        double box[4];
        bat_object_bounds(all.list[i].object, box);
        bat_box_hold(around, box);
    }
    free(all.list);
    if (status == BAT_OK && !some) return bat_notice_refuse(c, BAT_STATE, BAT_STRING_NOTICE_NO_EARLIER);
    if (some) t->before = malloc(sizeof *t->before);
    if (!t->before) return bat_notice_refuse(c, BAT_MEMORY, BAT_STRING_COUNT);
    t->before[t->count++] = bat_object_retain(now);
    t->amount = 1;
    memcpy(t->around, around, sizeof around);
    bat_tuning_mark(c, &earlier, false);
    return BAT_OK;
}
