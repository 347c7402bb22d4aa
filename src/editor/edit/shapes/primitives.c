#include "editor/edit/shapes/primitives.h"

#include "base/real.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/edit/arrange.h"
#include "editor/edit/curves_of.h"
#include "editor/edit/style.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/view/stage.h"
#include "kinds/primitive.h"

static const double INSET = 15; /* px from the outline, out of the way of the box's handles */
static const double LEAST = 60; /* px of an axis that has handles */

/* NULL: the selected object is no such shape. */
static const bat_primitive *selected(const bat_context *c, int i, int *index) {
    *index = bat_document_find(c->session->document, c->choice->selection.ids[i]);
    const bat_object *object = bat_document_at(c->session->document, *index);
    return object ? bat_object_primitive(object) : NULL;
}

bat_status bat_primitive_commit(bat_context *c, const bat_primitive *primitive, bat_string label) {
    bat_curve *curve = NULL;
    bat_object *made = NULL;
    const bat_id id = bat_document_new_id(c->session->document);
    bat_status status = bat_primitive_curve(primitive, &curve);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    status = bat_put_new_curve(c, id, curve);
    const int index = bat_document_find(c->session->document, id);
    if (status == BAT_OK)
        status = bat_object_with_primitive(bat_document_at(c->session->document, index), primitive, &made);
    if (status == BAT_OK) status = bat_transaction_replace(c, index, made);
    bat_object_release(made);
    status = bat_transaction_end(c, status, label);
    if (status != BAT_OK) return status;
    bat_selection_clear(&c->choice->selection);
    return bat_selection_add(&c->choice->selection, id);
}

bool bat_primitives_get(const bat_context *c, bat_primitive_number number, double *value) {
    for (int i = 0, index; i < c->choice->selection.count; i++) {
        const bat_primitive *p = selected(c, i, &index);
        if (p && bat_primitive_get(p, number, value)) return true;
    }
    return false;
}

/* Those of all selected shapes that `change` changes, as one step. BAT_STATE: there are none. */
static bat_status change_all(bat_context *c, bool (*change)(bat_primitive *p, const void *how),
                             const void *how) {
    bool some = false;
    bat_status status = bat_transaction_begin(c);
    for (int i = 0, index; i < c->choice->selection.count && status == BAT_OK; i++) {
        const bat_primitive *p = selected(c, i, &index);
        bat_primitive other;
        bat_object *made = NULL;
        if (!p) continue;
        other = *p;
        if (!change(&other, how)) continue;
        some = true;
        status = bat_object_with_primitive(bat_document_at(c->session->document, index), &other, &made);
        if (status == BAT_OK) status = bat_transaction_replace(c, index, made);
        bat_object_release(made);
    }
    if (status == BAT_OK && !some) status = BAT_STATE;
    return bat_transaction_end(c, status, BAT_STRING_STEP_SHAPE);
}

typedef struct setting {
    bat_primitive_number number;
    double value;
} setting;

static bool set_number(bat_primitive *p, const void *how) {
    const setting *s = how;
    return bat_primitive_set(p, s->number, s->value);
}

bat_status bat_primitives_set(bat_context *c, bat_primitive_number number, double value) {
    return change_all(c, set_number, &(setting){number, value});
}

static bool set_ends(bat_primitive *p, const void *how) {
    const bat_arc_ends *ends = how;
    if (p->kind != BAT_ELLIPSE || p->sweep >= 360) return false;
    p->ends = *ends;
    return true;
}

bat_status bat_primitives_end(bat_context *c, bat_arc_ends ends) { return change_all(c, set_ends, &ends); }

bool bat_primitives_are_arcs(const bat_context *c, bat_arc_ends but) {
    for (int i = 0, index; i < c->choice->selection.count; i++) {
        const bat_primitive *p = selected(c, i, &index);
        if (p && p->kind == BAT_ELLIPSE && p->sweep < 360 && p->ends != but) return true;
    }
    return false;
}

const bat_primitive *bat_primitive_held(const bat_context *c) {
    int index;
    if (c->choice->selection.count != 1 || bat_stage_tilted(c->stage)) return NULL;
    const bat_primitive *p = selected(c, 0, &index);
    const double scale = bat_stage_scale(c->stage) * (p && p->kind == BAT_RECTANGLE ? 1 : 2);
    return p && scale * bat_hypot(p->place[0], p->place[1]) >= LEAST &&
                   scale * bat_hypot(p->place[2], p->place[3]) >= LEAST
               ? p
               : NULL;
}

bool bat_primitive_grip(const bat_context *c, const bat_primitive *p, bat_primitive_number number,
                        double pixel[2]) {
    double at[2];
    if (!bat_primitive_handle(p, number, INSET * bat_stage_pixel(c->stage), at)) return false;
    bat_stage_project(c->stage, at, pixel);
    return true;
}
