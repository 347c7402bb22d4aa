#include "editor/edit/binding.h"
#include "kinds/primitive.h"
#include "document/bound.h"
#include "document/document.h"
#include "document/kind.h"
#include "editor/choice/choice.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "form/wire/refine.h"
#include <batten/recipe.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double RADIUS = 0.25; /* of the wire's size */

typedef struct chosen {
    int wire_count, target_count;
    const bat_object *wires[BAT_BOUND_WIRES];
    int *targets; /* document indices, ascending */
} chosen;

static bool is_solid(const bat_object *object) {
    return bat_object_surface(object) || bat_object_mesh(object);
}

/* A curve that something follows can't follow a wire (one level, no graph). */
static bool leads_others(const bat_document *document, bat_id id) {
    for (int i = 0; i < bat_document_count(document) && bat_document_has_followers(document); i++) {
        const bat_id *ids;
        const bat_object *object = bat_document_at(document, i);
        const int count = bat_object_sources(object, &ids);
        if (bat_object_followed(object) == id) return true;
        for (int k = 0; k < count; k++)
            if (ids[k] == id) return true;
    }
    return false;
}

/* Of curves alone, the one drawn last is the wire, the others are bound. */
static void split_curves(const bat_document *document, chosen *of) {
    const bat_object *last = of->wires[of->wire_count - 1];
    for (int i = 0; i + 1 < of->wire_count; i++)
        of->targets[of->target_count++] = bat_document_find(document, bat_object_id(of->wires[i]));
    of->wires[0] = last;
    of->wire_count = 1;
}

static bool take(const bat_document *document, int index, chosen *of) {
    const bat_object *object = bat_document_at(document, index);
    if (bat_object_is_group(object)) {
        const int end = bat_document_end(document, index);
        for (int i = index + 1; i < end; i++)
            if (bat_object_curve_count(bat_document_at(document, i)) > 0 &&
                !bat_object_is(bat_document_at(document, i), BAT_AID))
                of->targets[of->target_count++] = i;
        return true;
    }
    if (is_solid(object)) {
        of->targets[of->target_count++] = index;
        return true;
    }
    if (!bat_object_leads(object) || bat_object_curve_count(object) != 1 || of->wire_count == BAT_BOUND_WIRES)
        return false;
    of->wires[of->wire_count++] = object;
    return true;
}

/* False: something else is selected, too, or it is not enough. The caller frees of->targets. */
static bool find(const bat_context *c, chosen *of) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    *of = (chosen){.targets = NULL};
    if (selection->count < 1) return false;
    of->targets = calloc((size_t)bat_document_count(document) + 1, sizeof *of->targets);
    bool fits = of->targets != NULL;
    for (int i = 0; i < selection->count && fits; i++)
        fits = take(document, bat_document_find(document, selection->ids[i]), of);
    if (fits && of->target_count == 0 && of->wire_count > 1) split_curves(document, of);
    fits = fits && of->wire_count > 0 && of->target_count > 0;
    for (int i = 0; i < of->target_count && fits; i++) {
        const bat_object *target = bat_document_at(document, of->targets[i]);
        fits = is_solid(target) || !leads_others(document, bat_object_id(target));
    }
    return fits;
}

bool bat_bind_fits(const bat_context *c) {
    chosen of;
    const bool fits = find(c, &of);
    free(of.targets);
    return fits;
}

/* ---- binding ---- */

typedef struct bundle {
    int count;
    bat_wire wires[BAT_BOUND_WIRES];
    const bat_object *curves[BAT_BOUND_WIRES], *domains[BAT_BOUND_WIRES];
} bundle;

/* The wires that the object has, and the new ones; BAT_COUNT: too many. */
static bat_status gather(const bat_document *document, const bat_object *target, const chosen *of,
                         bundle *b) {
    const bat_hold *hold = bat_object_hold(target);
    const bat_object *from[BAT_RECIPE_CURVES];
    b->count = hold ? hold->bound->count : 0;
    if (hold && !bat_document_sources(document, target, from)) return BAT_STATE;
    if (hold) bat_bound_domains(hold->bound, from, b->domains);
    for (int i = 0; i < b->count; i++) b->wires[i] = hold->bound->wires[i], b->curves[i] = from[i];
    for (int k = 0; k < of->wire_count; k++) {
        bool there = false;
        for (int i = 0; i < b->count; i++) there = there || b->curves[i] == of->wires[k];
        if (there) continue;
        if (b->count == BAT_BOUND_WIRES) return BAT_COUNT;
        const bat_curve *curve = bat_object_curve(of->wires[k], 0);
        b->curves[b->count] = of->wires[k], b->domains[b->count] = NULL;
        b->wires[b->count++] = (bat_wire){.reference = curve,
                                          .radius = bat_function_of(RADIUS * bat_curve_size(curve)),
                                          .scale = bat_function_of(1)};
    }
    return BAT_OK;
}

static size_t felt(const bat_object *object) {
    const bat_hold *hold = bat_object_hold(object);
    return hold ? bat_binding_count(hold->bound->binding) : 0;
}

/* The surface with knots where the wires need them; *out NULL with BAT_OK: as it is. */
static bat_status refine(const bat_object *target, const bundle *b, bat_object **out) {
    bat_surface *fine = NULL;
    bat_status status = BAT_OK;
    *out = NULL;
    for (int i = 0; i < b->count && status == BAT_OK; i++) {
        bat_surface *finer = NULL;
        status = bat_wire_refine(fine ? fine : bat_object_surface(target), &b->wires[i], &finer);
        if (!finer) continue;
        bat_surface_free(fine);
        fine = finer;
    }
    if (status == BAT_OK && fine) status = bat_object_with_surface(target, fine, out);
    bat_surface_free(fine);
    return status;
}

/* What is bound in its place: of a spline the curve, of a surface that is too coarse a finer one. One that is bound already
 * keeps its points. */
static bat_status stand_in(const bat_object *target, const bundle *b, bat_object **out) {
    *out = NULL;
    if (bat_object_spline(target) || bat_object_primitive(target)) return bat_object_to_path(target, out);
    return bat_object_surface(target) && !bat_object_hold(target) ? refine(target, b, out) : BAT_OK;
}

static bat_status bind_object(const bat_object *target, const bundle *b, bat_object **out) {
    const bat_wire_options *options;
    bat_object *path = NULL;
    const bat_status stood = stand_in(target, b, &path);
    if (stood != BAT_OK) return stood;
    bat_object_wires(target, NULL, &options);
    const bat_status status = bat_object_bind(path ? path : target, (size_t)b->count, b->wires, b->curves,
                                              b->domains, options, out);
    bat_object_release(path);
    return status;
}

static size_t points_in(const bat_object *object) {
    const bat_surface *surface = bat_object_surface(object);
    return surface ? bat_surface_count(surface, BAT_U) * bat_surface_count(surface, BAT_V) : 0;
}

/* What is told: how many points follow, and how many control points refined surfaces have now. */
typedef struct tally {
    size_t reached, refined;
} tally;

static bat_status bind_one(bat_context *c, int index, const chosen *of, tally *told) {
    const bat_object *target = bat_document_at(c->session->document, index);
    bundle b;
    bat_object *made = NULL;
    bat_status status = gather(c->session->document, target, of, &b);
    if (status == BAT_OK) status = bind_object(target, &b, &made);
    if (status == BAT_OK) {
        told->reached += felt(made);
        if (points_in(made) != points_in(target)) told->refined += points_in(made);
    }
    if (status == BAT_OK) status = bat_transaction_replace(c, index, made);
    bat_object_release(made);
    return status;
}

bat_status bat_bind_to(bat_context *c, int index, bat_id curve) {
    const bat_document *document = c->session->document;
    chosen of = {.wire_count = 1, .wires = {bat_document_at(document, bat_document_find(document, curve))}};
    tally told = {0};
    return of.wires[0] ? bind_one(c, index, &of, &told) : BAT_ARGUMENT;
}

static void select_wires(bat_context *c, const chosen *of) {
    bat_selection_clear(&c->choice->selection);
    for (int i = 0; i < of->wire_count; i++) /* out of memory: not selected */
        bat_selection_add(&c->choice->selection, bat_object_id(of->wires[i]));
}

bat_status bat_bind_selection(bat_context *c) {
    chosen of;
    tally told = {0};
    bat_status status = find(c, &of) ? bat_transaction_begin(c) : BAT_STATE;
    if (status == BAT_OK) {
        for (int i = 0; i < of.target_count && status == BAT_OK; i++)
            status = bind_one(c, of.targets[i], &of, &told);
        status = bat_transaction_end(c, status, BAT_STRING_STEP_BIND);
        c->session->freed = BAT_STRING_COUNT;
        if (status == BAT_OK) {
            char text[48];
            if (told.refined > 0)
                snprintf(text, sizeof text, "%zu / %zu", told.reached, told.refined);
            else
                snprintf(text, sizeof text, "%zu", told.reached);
            bat_notice_value(c, told.refined > 0 ? BAT_STRING_NOTICE_BOUND_FINER : BAT_STRING_NOTICE_BOUND,
                             text);
            select_wires(c, &of);
        } else {
            bat_notice_failure(c, status);
        }
    }
    free(of.targets);
    return status;
}

/* ---- free ---- */

/* Whether the object is bound, and it or one of its wires is selected. */
static bool is_meant(const bat_context *c, const bat_object *object) {
    const bat_selection *selection = &c->choice->selection;
    const bat_id *ids;
    if (bat_object_wires(object, NULL, NULL) == 0) return false;
    const int count = bat_object_sources(object, &ids);
    bool meant = bat_selection_has(selection, bat_object_id(object));
    for (int i = 0; i < count && !meant; i++) meant = bat_selection_has(selection, ids[i]);
    return meant;
}

bool bat_bind_can_free(const bat_context *c) {
    const bat_document *document = c->session->document;
    if (!bat_document_has_followers(document) || c->choice->selection.count == 0) return false;
    for (int i = 0; i < bat_document_count(document); i++)
        if (is_meant(c, bat_document_at(document, i))) return true;
    return false;
}

bat_status bat_bind_free(bat_context *c, bool revert) {
    const bat_document *document = c->session->document;
    if (!bat_bind_can_free(c)) return BAT_STATE;
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_object *made = NULL;
        if (!is_meant(c, object)) continue;
        status = bat_object_unbind(object, revert, &made);
        if (status == BAT_OK) status = bat_transaction_replace(c, i, made);
        bat_object_release(made);
    }
    status = bat_transaction_end(c, status, revert ? BAT_STRING_STEP_REVERT : BAT_STRING_STEP_BAKE);
    c->session->freed = BAT_STRING_COUNT; /* told here, more exactly */
    if (status == BAT_OK)
        bat_notice(c, revert ? BAT_STRING_NOTICE_REVERTED : BAT_STRING_NOTICE_BAKED);
    else
        bat_notice_failure(c, status);
    return status;
}
