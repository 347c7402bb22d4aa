#include "editor/show/moves.h"
#include "document/kind.h"
#include "editor/choice/choice.h"
#include "editor/scene/scene.h"
#include "editor/session/session.h"

#include <limits.h>

static bool is_body(const bat_document *document, bat_id id) {
    return id && bat_object_motion(bat_document_at(document, bat_document_find(document, id)), NULL);
}

static bool moves(const bat_document *document, bat_id id) {
    const int at = id ? bat_document_find(document, id) : -1;
    return at >= 0 && bat_object_is(bat_document_at(document, at), BAT_MOVES);
}

/* The first in the drawing; counts them. */
static bat_id first_of(const bat_document *document, int *count) {
    bat_id first = 0;
    *count = 0;
    for (int i = bat_document_count(document) - 1; i >= 0; i--) {
        const bat_object *object = bat_document_at(document, i);
        if (!bat_object_is(object, BAT_MOVES)) continue;
        first = bat_object_id(object);
        ++*count;
    }
    return first;
}

void bat_moves_sync(bat_context *c) {
    bat_moves *m = c->moves;
    const bat_document *document = c->session->document;
    const bat_selection *selection = &c->choice->selection;
    const bool changed = m->revision != (uint64_t)c->session->revision;
    if (m->seen && !changed && m->selection == selection->version) return;
    const bat_id chosen = selection->count == 1 ? selection->ids[0] : 0,
                 first = first_of(document, &m->count);
    const bat_id now = moves(document, chosen) ? chosen : moves(document, m->camera) ? m->camera : first;
    if (now != m->camera) {
        m->at = 0;
        m->playing = m->through = false;
        m->level[0] = m->level[1] = 0;
        if (is_body(document, now)) m->level[1] = INT_MAX; /* the finest of whichever joint */
        m->joint = m->angle = 0;
        m->version++;
    }
    if (changed) {
        m->playing = false;
        m->version++;
    }
    m->camera = now;
    bat_scene_ghost(c->scene, is_body(document, now) ? now : 0); /* it is shown at the playhead */
    m->seen = true;
    m->revision = (uint64_t)c->session->revision;
    m->selection = selection->version;
}

void bat_moves_forget(bat_moves *moves) { *moves = (bat_moves){.version = moves->version + 1}; }

bool bat_moves_toggle(bat_context *c) {
    bat_moves *m = c->moves;
    bat_moves_sync(c);
    if (!m->camera) return false;
    m->playing = !m->playing;
    m->since = -1;
    m->version++;
    return true;
}

bool bat_moves_leave(bat_context *c) {
    const bool was = c->moves->through;
    c->moves->through = false;
    c->moves->version += was;
    return was;
}

uint32_t bat_moves_version(const bat_context *c) { return c->moves->camera ? c->moves->version + 1 : 0; }
