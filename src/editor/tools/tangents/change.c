/* The tangents tool: its changes to the document, each an undo step. */
#include "editor/choice/choice.h"
#include "editor/edit/arrange.h"
#include "editor/edit/curves_of.h"
#include "editor/edit/style.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/tables.h"
#include "editor/tools/tangents/draft.h"
#include "editor/tools/tangents/state.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "kinds/spline.h"
#include <batten/bezier.h>
#include <math.h>
#include <stdio.h>

static const double MIDDLE = 0.05; /* of a segment across the axis: a point so near its middle is put there */
static const double TENSION_MIN = 0.02, TENSION_MAX = 50;

void bat_splining_tell(bat_context *c, bat_status status, bat_string done) {
    if (status == BAT_COUNT)
        bat_notice(c, BAT_STRING_NOTICE_NO_SPLINE);
    else if (status != BAT_OK)
        bat_notice_failure(c, status);
    else
        bat_notice(c, done);
}

/* Replaces the present object by this one, or removes it (NULL), as one step. */
static bat_status put(bat_context *c, bat_string step, bat_id id, bat_object *object) {
    int at = bat_document_find(c->session->document, id);
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    status = object ? bat_transaction_replace(c, at, object) : bat_transaction_remove(c, at);
    return bat_transaction_end(c, status, step);
}

/* Writes the draft to the chosen spline, in one step. */
bat_status bat_splining_commit(bat_context *c, bat_string step) {
    bat_splining *s = bat_splining_of(c);
    bat_spline spline = bat_draft_spline(&s->draft);
    bat_object *after = NULL;
    bat_status status = bat_object_with_spline(bat_splining_object(c), &spline, &after);
    if (status == BAT_OK) status = put(c, step, s->object, after);
    bat_object_release(after);
    return status;
}

bat_status bat_splining_make(bat_context *c, const bat_spline *spline) {
    bat_style style = bat_styling_new(c);
    const bat_tangents_options options = bat_splining_next_options(c);
    bat_object *object = NULL;
    /* Check first that it is valid: an id once taken is not returned. */
    bat_status status = bat_object_create_spline(1, NULL, &style, spline, &options, &object);
    bat_object_release(object);
    if (status != BAT_OK) return status;
    object = NULL;
    bat_id id = bat_document_new_id(c->session->document);
    status = bat_object_create_spline(id, NULL, &style, spline, &options, &object);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        status = bat_keep_view_plane(c, &c->stage->ground, id);
        if (status == BAT_OK) status = bat_arrange_insert(c, object);
        if (status == BAT_OK) status = bat_dash_new(c, id, bat_styling_dashes(c));
        status = bat_transaction_end(c, status, BAT_STRING_STEP_SPLINE);
    }
    bat_object_release(object);
    if (status != BAT_OK) return status;
    bat_splining_of(c)->object = id;
    bat_splining_of(c)->point = 0;
    bat_splining_of(c)->placing = bat_splining_of(c)->on_direction = false;
    return BAT_OK;
}

bat_status bat_splining_load(bat_context *c) {
    const bat_spline *spline = bat_splining_spline(c);
    bat_status status = spline ? bat_draft_load(&bat_splining_of(c)->draft, spline) : BAT_STATE;
    if (status == BAT_OK) bat_splining_pair(c);
    return status;
}

static bat_status remove_object(bat_context *c) {
    bat_splining *s = bat_splining_of(c);
    bat_status status = put(c, BAT_STRING_STEP_REMOVE, s->object, NULL);
    if (status == BAT_OK) s->object = 0;
    return status;
}

/* Removes a point; a spline left with a single point is removed. */
bat_status bat_splining_remove_point(bat_context *c, int point) {
    bat_splining *s = bat_splining_of(c);
    bat_status status = bat_splining_load(c);
    if (status != BAT_OK) return status;
    const int other = bat_splining_partner(s, point);
    bat_draft_remove(&s->draft, point);
    if (other >= 0 && other != point) bat_draft_remove(&s->draft, other > point ? other - 1 : other);
    status = s->draft.count < 2 ? BAT_COUNT : bat_splining_commit(c, BAT_STRING_STEP_DELETE_POINT);
    if (status != BAT_COUNT) {
        bat_splining_tell(c, status, BAT_STRING_NOTICE_DELETED);
        return status;
    }
    status = remove_object(c);
    bat_splining_tell(c, status, BAT_STRING_NOTICE_SPLINE_DELETED);
    return status;
}

bat_status bat_splining_default(bat_context *c, int point) {
    bat_splining *s = bat_splining_of(c);
    bat_status status = bat_splining_is_even(c) ? BAT_STATE : bat_splining_load(c);
    if (status != BAT_OK) return status;
    for (int k = 0; k < s->draft.dimension; k++) s->draft.tangents[s->draft.dimension * point + k] = 0;
    for (int k = 0; k < 2; k++) s->draft.tension[2 * point + k] = 1;
    bat_splining_follow(s, point);
    status = bat_splining_commit(c, BAT_STRING_STEP_DIRECTION);
    bat_splining_tell(c, status, BAT_STRING_NOTICE_DEFAULT);
    return status;
}

/* Adds a point on the curve to the draft, and the one that mirrors it where the spline is its own image; *index: its
 * index. */
bat_status bat_splining_draft_insert(bat_context *c, int segment, double t, int *index, double *deviation) {
    bat_status status = bat_splining_load(c);
    if (status != BAT_OK) return status;
    const bat_tangents_options options = bat_splining_options(c);
    const bat_spline *spline = bat_splining_spline(c);
    const bool across = bat_splining_twin_segment(c, segment) == segment;
    if (across && fabs(t - 0.5) < MIDDLE) t = 0.5;
    bat_spline longer;
    void *block = NULL;
    status = bat_tangents_insert(spline, segment, t, &options, &longer, &block, index, deviation);
    if (status == BAT_OK) {
        status = bat_splining_insert_twin(c, &longer, segment, t, &options, index);
        bat_free(block);
    }
    return status;
}

bat_status bat_splining_insert(bat_context *c, int segment, double t) {
    bat_splining *s = bat_splining_of(c);
    int index = 0;
    double deviation = 0;
    bat_status status = bat_splining_draft_insert(c, segment, t, &index, &deviation);
    if (status == BAT_OK) status = bat_splining_commit(c, BAT_STRING_STEP_INSERT_POINT);
    if (status != BAT_OK) {
        bat_notice_failure(c, status);
        return status;
    }
    s->point = index;
    s->on_direction = false;
    char value[32];
    snprintf(value, sizeof value, "%.3f", deviation * bat_stage_scale(c->stage));
    bat_notice_value(c, BAT_STRING_NOTICE_INSERTED, value);
    return BAT_OK;
}

bat_status bat_splining_close(bat_context *c) {
    bat_splining *s = bat_splining_of(c);
    bat_status status = bat_splining_load(c);
    s->draft.closed = true;
    if (status == BAT_OK) status = bat_splining_commit(c, BAT_STRING_STEP_CLOSE);
    bat_splining_tell(c, status, BAT_STRING_NOTICE_CLOSED);
    if (status == BAT_OK) s->placing = false, s->point = 0;
    return status;
}

bat_status bat_splining_set_mode(bat_context *c, double mode) {
    bat_splining *s = bat_splining_of(c);
    const bool chosen = bat_tool_at(c->choice->tool)->traits & BAT_EDITS_SPLINES;
    if (!chosen || c->session->busy || c->session->transaction.open || !bat_splining_spline(c) ||
        bat_splining_mode(c) == (bat_tangents_mode)mode)
        return BAT_OK;
    bat_object *after = NULL;
    bat_status status = bat_object_with_spline_mode(bat_splining_object(c), (bat_tangents_mode)mode, &after);
    if (status == BAT_OK) status = put(c, BAT_STRING_STEP_SPLINE_MODE, s->object, after);
    bat_object_release(after);
    s->hover_changed = true;
    if (status == BAT_OK) s->on_direction = false;
    return status;
}

bat_status bat_splining_give_free(bat_context *c) {
    bat_splining *s = bat_splining_of(c);
    if (!bat_splining_spline(c)) return BAT_STATE;
    bat_object *after = NULL;
    bat_status status = bat_object_to_path(bat_splining_object(c), &after);
    if (status == BAT_OK) status = put(c, BAT_STRING_STEP_FREE, s->object, after);
    bat_object_release(after);
    bat_splining_tell(c, status, BAT_STRING_NOTICE_FREED);
    if (status == BAT_OK) s->placing = false, s->object = 0, s->point = -1;
    return status;
}

double bat_splining_tension(double value) { return fmin(fmax(value, TENSION_MIN), TENSION_MAX); }
