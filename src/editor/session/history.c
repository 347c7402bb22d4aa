#include "editor/session/history.h"
#include "document/document.h"
#include "document/kind.h"
#include <stdlib.h>
#include <string.h>

bat_status bat_delta_apply(const bat_delta *delta, bat_document *document, bool forwards) {
    const bat_object *from = forwards ? delta->before : delta->after;
    const bat_object *to = forwards ? delta->after : delta->before;
    if (!from) return bat_document_insert(document, delta->index, to);
    if (!to) return bat_document_remove(document, delta->index);
    return bat_document_replace(document, delta->index, to);
}

bat_status bat_deltas_apply(const bat_delta *deltas, int count, bat_document *document, bool forwards) {
    for (int i = 0; i < count; i++) {
        const bat_delta *delta = &deltas[forwards ? i : count - 1 - i];
        bat_status status = bat_delta_apply(delta, document, forwards);
        if (status != BAT_OK) {
            while (i-- > 0) bat_delta_apply(&deltas[forwards ? i : count - 1 - i], document, !forwards);
            return status;
        }
    }
    return BAT_OK;
}

bat_status bat_step_apply(const bat_step *step, bat_document *document, bool forwards) {
    if (step->page) return bat_sheet_put(document, forwards ? &step->page->after : &step->page->before);
    return bat_deltas_apply(step->deltas, step->count, document, forwards);
}

/* The index, after all deltas, of what was at `place` after delta i. */
static int place_now(const bat_delta *deltas, int count, int i, int place) {
    for (i++; i < count; i++) {
        if (!deltas[i].before) place += deltas[i].index <= place;
        if (!deltas[i].after) place -= deltas[i].index < place;
    }
    return place;
}

/* No difference that matters to groups. */
static bool alike(const bat_object *a, const bat_object *b) {
    bool groups = bat_object_is_group(a) || bat_object_is_group(b);
    return bat_object_parent(a) == bat_object_parent(b) &&
           (!groups || bat_object_type(a) == bat_object_type(b));
}

bool bat_deltas_hold(const bat_delta *deltas, int count, const bat_document *document) {
    enum { LOOKED_AT = 4 };
    int moved = 0;
    bool whole = false;
    for (int i = 0; i < count && !whole; i++) {
        const bat_object *before = deltas[i].before, *after = deltas[i].after;
        if (before && after) {
            whole = !alike(before, after);
        } else {
            whole = bat_object_is_group(before ? before : after) || ++moved > LOOKED_AT;
        }
    }
    if (whole) return !bat_document_check_nesting(document);
    for (int i = 0; i < count && moved; i++) {
        if (deltas[i].before && deltas[i].after) continue;
        int place = place_now(deltas, count, i, deltas[i].index);
        if (!bat_document_fits(document, place) || !bat_document_fits(document, place + 1)) return false;
    }
    return true;
}

void bat_deltas_free(bat_delta *deltas, int count) {
    for (int i = 0; i < count; i++) {
        bat_object_release(deltas[i].before);
        bat_object_release(deltas[i].after);
    }
    free(deltas);
}

static void drop_steps(bat_history *history, int first, int count) {
    for (int i = first; i < first + count; i++) {
        bat_deltas_free(history->steps[i].deltas, history->steps[i].count);
        free(history->steps[i].page);
        history->bytes -= history->steps[i].bytes;
    }
    memmove(history->steps + first, history->steps + first + count,
            (size_t)(history->count - first - count) * sizeof *history->steps);
    history->count -= count;
}

void bat_history_clear(bat_history *history) {
    if (history->count) drop_steps(history, 0, history->count);
    free(history->steps);
    *history = (bat_history){.state = history->states + 1, .states = history->states + 1};
}

bat_status bat_history_reserve(bat_history *history) {
    if (history->done < history->room || history->room == BAT_HISTORY_ROOM) return BAT_OK;
    int room = history->room ? 2 * history->room : 32;
    if (room > BAT_HISTORY_ROOM) room = BAT_HISTORY_ROOM;
    bat_step *steps = realloc(history->steps, (size_t)room * sizeof *steps);
    if (!steps) return BAT_MEMORY;
    history->steps = steps;
    history->room = room;
    return BAT_OK;
}

/* How many of the oldest steps to drop before one of so many bytes is added: many at once, for every drop moves all that
 * stay. */
static int excess(const bat_history *history, size_t bytes) {
    int drop = history->count == BAT_HISTORY_ROOM ? BAT_HISTORY_ROOM - BAT_HISTORY_STEPS + 1 : 0;
    if (history->bytes + bytes <= BAT_HISTORY_BYTES) return drop;
    size_t left = history->bytes + bytes;
    for (int i = 0; i < drop; i++) left -= history->steps[i].bytes;
    while (left > BAT_HISTORY_BYTES / 4 * 3 && history->count - drop >= BAT_HISTORY_FEWEST)
        left -= history->steps[drop++].bytes;
    return drop;
}

static void push(bat_history *history, bat_step step) {
    if (history->count > history->done) drop_steps(history, history->done, history->count - history->done);
    drop_steps(history, 0, excess(history, step.bytes));
    step.before = history->state, step.after = ++history->states;
    history->steps[history->count++] = step;
    history->bytes += step.bytes;
    history->done = history->count;
    history->state = step.after;
}

void bat_history_push(bat_history *history, int label, int count, bat_delta *deltas, size_t bytes) {
    push(history, (bat_step){.label = label, .count = count, .deltas = deltas, .bytes = bytes});
}

void bat_history_push_page(bat_history *history, int label, bat_page_change *page, size_t bytes) {
    push(history, (bat_step){.label = label, .page = page, .bytes = bytes});
}

bool bat_history_can_undo(const bat_history *history) { return history->done > 0; }
bool bat_history_can_redo(const bat_history *history) { return history->done < history->count; }

bat_status bat_history_undo(bat_history *history, bat_document *document) {
    if (!bat_history_can_undo(history)) return BAT_STATE;
    const bat_step *step = &history->steps[history->done - 1];
    bat_status status = bat_step_apply(step, document, false);
    if (status != BAT_OK) return status;
    history->state = step->before;
    history->done--;
    return BAT_OK;
}

bat_status bat_history_before(const bat_history *history, const bat_document *document, bat_document **out) {
    bat_document *before = NULL;
    if (!bat_history_can_undo(history)) return BAT_STATE;
    const bat_step *step = &history->steps[history->done - 1];
    bat_status status = bat_document_copy(document, &before);
    if (status == BAT_OK) status = bat_step_apply(step, before, false);
    if (status == BAT_OK)
        *out = before;
    else
        bat_document_free(before);
    return status;
}

bat_status bat_history_redo(bat_history *history, bat_document *document) {
    if (!bat_history_can_redo(history)) return BAT_STATE;
    const bat_step *step = &history->steps[history->done];
    bat_status status = bat_step_apply(step, document, true);
    if (status != BAT_OK) return status;
    history->state = step->after;
    history->done++;
    return BAT_OK;
}
