/* What can be set of a wire: its radius, the curve that bounds its reach, and by what it turns. */
#include "document/bound.h"
#include "document/document.h"
#include "document/kind.h"
#include "editor/choice/choice.h"
#include "editor/edit/binding.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "form/wire/stops.h"
#include <batten/recipe.h>

#include <string.h>

/* Binds everything that is bound to the wire again, with another radius, another domain curve or another turn. */
typedef struct change {
    const bat_function *radius; /* NULL: as it is */
    bool bounds;                /* the domain curve changes, to: */
    const bat_object *domain;   /* the first curve of; NULL: none */
    const bat_wire_turn *turn;  /* NULL: as it is */
} change;

static bat_status rebind(bat_context *c, int index, int which, const change *to) {
    const bat_object *object = bat_document_at(c->session->document, index), *from[BAT_RECIPE_CURVES];
    const bat_object *domains[BAT_BOUND_WIRES];
    const bat_hold *hold = bat_object_hold(object);
    const bat_wire *had;
    const bat_wire_options *options;
    bat_wire wires[BAT_BOUND_WIRES];
    bat_object *made = NULL;
    const int count = bat_object_wires(object, &had, &options);
    if (!hold || !bat_document_sources(c->session->document, object, from)) return BAT_STATE;
    bat_bound_domains(hold->bound, from, domains);
    memcpy(wires, had, (size_t)count * sizeof *wires);
    if (to->radius) wires[which].radius = *to->radius;
    if (to->turn) wires[which].turn = *to->turn;
    if (to->bounds) wires[which].domain = NULL, domains[which] = to->domain;
    bat_status status = bat_object_bind(object, (size_t)count, wires, from, domains, options, &made);
    if (status == BAT_OK) status = bat_transaction_replace(c, index, made);
    bat_object_release(made);
    return status;
}

/* Which of the object's wires is the curve; -1: none. */
static int wire_of(const bat_object *object, bat_id curve) {
    const bat_id *ids;
    const int count = bat_object_wires(object, NULL, NULL);
    if (count > 0) bat_object_sources(object, &ids);
    for (int i = 0; i < count; i++)
        if (ids[i] == curve) return i;
    return -1;
}

static bat_status rebind_all(bat_context *c, bat_id curve, const change *to) {
    const bat_document *document = c->session->document;
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const int which = wire_of(bat_document_at(document, i), curve);
        if (which >= 0) status = rebind(c, i, which, to);
    }
    return status;
}

bat_status bat_bind_put_radius(bat_context *c, bat_id curve, const bat_function *radius) {
    return rebind_all(c, curve, &(change){.radius = radius});
}

/* The first wire that something is bound to by the curve; NULL: it is none. */
static const bat_wire *wire_named(const bat_document *document, bat_id curve) {
    const bat_wire *wires;
    for (int i = 0; i < bat_document_count(document) && bat_document_has_followers(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        const int which = wire_of(object, curve);
        if (which < 0) continue;
        bat_object_wires(object, &wires, NULL);
        return &wires[which];
    }
    return NULL;
}

/* ---- numbers ---- */

static const bat_wire *selected(const bat_context *c, bat_id *curve) {
    const bat_selection *selection = &c->choice->selection;
    if (selection->count != 1) return NULL;
    *curve = selection->ids[0];
    return wire_named(c->session->document, *curve);
}

static int stop_of(const bat_stops *stops, bool end) { return end ? stops->count - 1 : 0; }

bool bat_bind_radius(const bat_context *c, bool end, double *value) {
    bat_id curve;
    const bat_wire *wire = selected(c, &curve);
    if (!wire) return false;
    const bat_stops stops = bat_stops_of(&wire->radius, bat_curve_is_closed(wire->reference));
    *value = stops.radius[stop_of(&stops, end)];
    return true;
}

bat_status bat_bind_set_radius(bat_context *c, bool end, double value) {
    bat_id curve;
    bat_function radius;
    const bat_wire *wire = selected(c, &curve);
    if (!wire) return BAT_STATE;
    const bool closed = bat_curve_is_closed(wire->reference);
    bat_stops stops = bat_stops_of(&wire->radius, closed);
    stops.radius[stop_of(&stops, end)] = value;
    bat_status status = bat_stops_function(&stops, closed, &radius);
    if (status == BAT_PARAMETER) {
        bat_notice(c, BAT_STRING_NOTICE_NO_RADIUS);
        return BAT_NUMBER;
    }
    if (status != BAT_OK) return status;
    status = bat_transaction_begin(c);
    if (status == BAT_OK)
        status = bat_transaction_end(c, bat_bind_put_radius(c, curve, &radius), BAT_STRING_STEP_RADIUS);
    bat_function_clear(&radius);
    return status;
}

/* ---- the domain curve ---- */

/* A wire and another curve are selected, or a wire alone that has a domain curve. */
static bool find_domain(const bat_context *c, bat_id *curve, const bat_object **domain) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    *domain = NULL;
    if (selection->count == 1) {
        const bat_wire *wire = selected(c, curve);
        return wire && wire->domain;
    }
    if (selection->count != 2) return false;
    for (int k = 0; k < 2; k++) {
        const bat_object *other = bat_document_at(document,
                                                  bat_document_find(document, selection->ids[1 - k]));
        *curve = selection->ids[k];
        if (!wire_named(document, *curve) || wire_named(document, selection->ids[1 - k])) continue;
        if (!other || !bat_object_leads(other) || bat_object_curve_count(other) != 1) continue;
        *domain = other;
        return true;
    }
    return false;
}

bool bat_bind_has_domain(const bat_context *c) {
    bat_id curve;
    const bat_object *domain;
    return bat_document_has_followers(c->session->document) && find_domain(c, &curve, &domain);
}

bat_status bat_bind_domain(bat_context *c) {
    bat_id curve;
    const bat_object *domain;
    if (!bat_bind_has_domain(c)) return BAT_STATE;
    find_domain(c, &curve, &domain);
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    status = bat_transaction_end(c, rebind_all(c, curve, &(change){.bounds = true, .domain = domain}),
                                 BAT_STRING_STEP_DOMAIN);
    if (status == BAT_OK)
        bat_notice(c, domain ? BAT_STRING_NOTICE_DOMAIN : BAT_STRING_NOTICE_NO_DOMAIN);
    else
        bat_notice_failure(c, status);
    return status;
}

/* ---- the turn ---- */

bool bat_bind_turns(const bat_context *c, bool *by_frames) {
    bat_id curve;
    if (!bat_document_has_followers(c->session->document)) return false;
    const bat_wire *wire = selected(c, &curve);
    if (wire) *by_frames = wire->turn == BAT_TURN_FRAMES;
    return wire != NULL;
}

bat_status bat_bind_switch_turn(bat_context *c) {
    bool frames;
    if (!bat_bind_turns(c, &frames)) return BAT_STATE;
    const bat_wire_turn turn = frames ? BAT_TURN_TANGENT : BAT_TURN_FRAMES;
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    status = bat_transaction_end(c, rebind_all(c, c->choice->selection.ids[0], &(change){.turn = &turn}),
                                 BAT_STRING_STEP_TURN);
    if (status == BAT_OK)
        bat_notice(c, frames ? BAT_STRING_NOTICE_TURN_TANGENT : BAT_STRING_NOTICE_TURN_FRAMES);
    else
        bat_notice_failure(c, status);
    return status;
}
