#include "editor/edit/meeting.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/edit/binding.h"
#include "editor/edit/style.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/view/stage.h"

#include <batten/measure.h>
#include <batten/trace.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double WITHIN =
    1e-4; /* of the smaller surface's size: how far the curves may be from the surfaces */

typedef struct meeting {
    int back, front; /* document indices */
    bat_tracks *tracks;
    double tolerance;
} meeting;

static bool find(const bat_context *c, meeting *m) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    int at[2];
    if (selection->count != 2) return false;
    for (int k = 0; k < 2; k++) {
        at[k] = bat_document_find(document, selection->ids[k]);
        if (!bat_object_surface(bat_document_at(document, at[k]))) return false;
    }
    *m = (meeting){.back = at[0] < at[1] ? at[0] : at[1], .front = at[0] < at[1] ? at[1] : at[0]};
    return true;
}

bool bat_meet_fits(const bat_context *c) {
    meeting m;
    return find(c, &m);
}

static bat_status trace(const bat_context *c, meeting *m) {
    const bat_document *document = c->session->document;
    const bat_surface *a = bat_object_surface(bat_document_at(document, m->back));
    const bat_surface *b = bat_object_surface(bat_document_at(document, m->front));
    m->tolerance = WITHIN * fmin(bat_surface_size(a), bat_surface_size(b));
    return bat_surface_intersect(a, b, NULL, &m->tracks);
}

static double length_of(const bat_tracks *tracks, size_t i) {
    const bat_track_point *p;
    const size_t count = bat_tracks_points(tracks, i, &p);
    double length = 0;
    for (size_t k = 1; k < count; k++)
        length += sqrt((p[k].point[0] - p[k - 1].point[0]) * (p[k].point[0] - p[k - 1].point[0]) +
                       (p[k].point[1] - p[k - 1].point[1]) * (p[k].point[1] - p[k - 1].point[1]) +
                       (p[k].point[2] - p[k - 1].point[2]) * (p[k].point[2] - p[k - 1].point[2]));
    return length;
}

/* In front of both surfaces, and in the group of the front one. */
static bat_status insert(bat_context *c, const meeting *m, size_t track, int at, bat_id *id) {
    bat_document *document = c->session->document;
    const bat_style style = bat_styling_new(c);
    bat_curve *curve = NULL;
    bat_object *made = NULL, *placed = NULL;
    bat_status status = bat_tracks_curve(m->tracks, track, m->tolerance, &curve);
    *id = bat_document_new_id(document);
    if (status == BAT_OK) status = bat_object_create_path(*id, "", &style, 1, &curve, &made);
    if (status == BAT_OK)
        status = bat_object_with_parent(made, bat_object_parent(bat_document_at(document, m->front)),
                                        &placed);
    if (status == BAT_OK) status = bat_transaction_insert(c, at, placed);
    bat_object_release(made), bat_object_release(placed);
    return status;
}

static bat_status insert_all(bat_context *c, const meeting *m, bool bind, bat_id *ids, int *made) {
    const size_t count = bat_tracks_count(m->tracks);
    size_t longest = 0;
    bat_status status = BAT_OK;
    for (size_t i = 1; i < count; i++)
        if (length_of(m->tracks, i) > length_of(m->tracks, longest)) longest = i;
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        if (bind && i != longest) continue;
        status = insert(c, m, i, m->front + 1 + *made, &ids[*made]);
        *made += status == BAT_OK;
    }
    if (status == BAT_OK && bind) status = bat_bind_to(c, m->back, ids[0]);
    return status;
}

static void tell(bat_context *c, bat_status status, int made, bool bind) {
    char text[16];
    snprintf(text, sizeof text, "%d", made);
    if (status != BAT_OK)
        bat_notice_failure(c, status);
    else if (bind)
        bat_notice(c, BAT_STRING_NOTICE_MET_BOUND);
    else
        bat_notice_value(c, BAT_STRING_NOTICE_MET, text);
    if (!bat_stage_tilted(c->stage)) c->notices->offer = BAT_COMMAND_ORBIT_UP;
}

bat_status bat_meet_make(bat_context *c, bool bind) {
    meeting m;
    int made = 0;
    if (!find(c, &m)) return BAT_STATE;
    bat_status status = trace(c, &m);
    const size_t count = status == BAT_OK ? bat_tracks_count(m.tracks) : 0;
    if (status == BAT_OK && count == 0) {
        bat_notice(c, bat_tracks_is_given_up(m.tracks) ? BAT_STRING_NOTICE_MEET_ALONG
                                                       : BAT_STRING_NOTICE_NO_MEETING);
        bat_tracks_free(m.tracks);
        return BAT_STATE;
    }
    bat_id *ids = calloc(count + 1, sizeof *ids);
    if (status == BAT_OK && !ids) status = BAT_MEMORY;
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK)
        status = bat_transaction_end(c, insert_all(c, &m, bind, ids, &made), BAT_STRING_STEP_MEETING);
    tell(c, status, made, bind);
    if (status == BAT_OK) bat_selection_clear(&c->choice->selection);
    for (int i = 0; i < made && status == BAT_OK; i++) bat_selection_add(&c->choice->selection, ids[i]);
    bat_tracks_free(m.tracks);
    free(ids);
    return status;
}
