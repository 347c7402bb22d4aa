#include "editor/edit/making.h"
#include "editor/edit/each.h"
#include "form/recipe/flat.h"
#include "document/document.h"
#include "document/kind.h"
#include "document/nesting.h"
#include "editor/choice/choice.h"
#include "editor/edit/style.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/view/stage.h"
#include "editor/view/unit.h"
#include "form/recipe/corners.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double CLOSE = 2;     /* px: corners this far apart are closed at the user's word */
static const double MEETS = 1e-6;  /* of the size of the smallest: corners this far apart meet */
static const double BESIDE = 0.25; /* the same: beyond this the curves do not go round a patch */

static const double ON_AXIS = 0.05; /* of how far a profile reaches: as much may lie beyond its axis */

typedef struct chosen {
    int count;
    const bat_object *objects[BAT_RECIPE_CURVES];
    const bat_curve *curves[BAT_RECIPE_CURVES];
    bool closed, open; /* some are */
    double smallest;   /* size */
} chosen;

/* False: it is not one curve, or one too many. */
static bool add(const bat_object *object, chosen *out) {
    if (out->count == BAT_RECIPE_CURVES) return false;
    if (!bat_object_is_one_curve(object)) return false;
    const bat_curve *curve = bat_object_curve(object, 0);
    out->objects[out->count] = object, out->curves[out->count++] = curve;
    *(bat_curve_is_closed(curve) ? &out->closed : &out->open) = true;
    out->smallest = fmin(out->smallest, bat_curve_size(curve));
    return true;
}

/* All that are seen and not locked, where nothing is selected: what the drawing has is what is meant. */
static bool find_all(const bat_document *document, chosen *out) {
    bat_nesting nesting = {0};
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        bat_nesting_next(&nesting, object, &level);
        if (level.hidden || level.locked || !bat_object_is_made_of_curves(object)) continue;
        if (!add(object, out)) return false;
    }
    return out->count > 1;
}

/* False: something else is selected, too, or not as many as there can be. */
static bool find(const bat_context *c, chosen *out) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    *out = (chosen){.smallest = INFINITY};
    if (selection->count == 0) return find_all(document, out);
    for (int i = 0; i < selection->count; i++)
        if (!add(bat_document_at(document, bat_document_find(document, selection->ids[i])), out))
            return false;
    return out->count > 1;
}

static void swap(chosen *of) {
    const bat_object *object = of->objects[0];
    const bat_curve *curve = of->curves[0];
    of->objects[0] = of->objects[1], of->curves[0] = of->curves[1];
    of->objects[1] = object, of->curves[1] = curve;
}

static bool is_straight(const bat_curve *curve) {
    const bat_flat flat = bat_curve_flat(curve);
    return !bat_curve_is_closed(curve) && bat_flat_is_straight(&flat);
}

static bool is_planar(const bat_curve *curve) {
    const bat_flat flat = bat_curve_flat(curve);
    return bat_curve_dimension(curve) == 2 || flat.planar || bat_flat_is_straight(&flat);
}

/* Path and profile: of two curves the closed one, or the smaller, is the profile. */
static bool order_sweep(chosen *of) {
    const bat_curve *a = of->curves[0], *b = of->curves[1];
    const bool closed = bat_curve_is_closed(a), other = bat_curve_is_closed(b);
    if (of->count != 2) return false;
    if (closed != other ? closed : bat_curve_size(a) < bat_curve_size(b)) swap(of);
    return is_planar(of->curves[1]);
}

/* Profile and axis: of two lines the one drawn last is the axis. */
static bool order_revolve(chosen *of) {
    if (of->count != 2) return false;
    if (!is_straight(of->curves[1])) swap(of);
    return is_straight(of->curves[1]) && is_planar(of->curves[0]);
}

/* Whether all of a planar curve's points are on one side of the line from the axis's first point to its last, or on it. */
static bool is_beside(const bat_curve *curve, const bat_curve *axis) {
    const double *x = bat_curve_points(curve), *from = bat_curve_points(axis);
    const double *to = from + 2 * ((int)bat_curve_count(axis) - 1);
    double least = 0, most = 0;
    if (bat_curve_dimension(curve) != 2 || bat_curve_dimension(axis) != 2) return false;
    for (int i = 0; i < (int)bat_curve_count(curve); i++) {
        const double side = (to[0] - from[0]) * (x[2 * i + 1] - from[1]) -
                            (to[1] - from[1]) * (x[2 * i] - from[0]);
        least = fmin(least, side), most = fmax(most, side);
    }
    return most - least > 0 && fmin(-least, most) <= ON_AXIS * (most - least);
}

/* Four open curves that go round a patch; the greatest distance in a corner. */
static bool goes_round(const chosen *of, double *apart) {
    bat_recipe_corners corners;
    if (of->count != 4 || of->closed || bat_recipe_meet(of->curves, &corners) != BAT_OK) return false;
    *apart = corners.apart;
    return corners.apart <= BESIDE * of->smallest;
}

static bool closes(const bat_context *c, const chosen *of, double apart) {
    return apart > MEETS * of->smallest && apart <= CLOSE * bat_stage_pixel(c->stage);
}

static void middle_of(const bat_curve *curve, double out[3]) {
    const int dimension = bat_curve_dimension(curve), count = (int)bat_curve_count(curve);
    out[0] = out[1] = out[2] = 0;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < dimension; k++) out[k] += bat_curve_points(curve)[i * dimension + k] / count;
}

static double between(const double a[3], const double b[3]) {
    return bat_hypot(bat_hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* Sections side by side: from one of the two that are farthest apart, always to the nearest that is left. */
static void order_loft(chosen *of) {
    double middles[BAT_RECIPE_CURVES][3], most = -1;
    bool used[BAT_RECIPE_CURVES] = {false};
    int at = 0;
    const chosen from = *of;
    for (int i = 0; i < of->count; i++) middle_of(of->curves[i], middles[i]);
    for (int i = 0; i < of->count; i++)
        for (int k = i + 1; k < of->count; k++)
            if (between(middles[i], middles[k]) > most) most = between(middles[i], middles[k]), at = i;
    for (int n = 0; n < of->count; n++) {
        of->objects[n] = from.objects[at], of->curves[n] = from.curves[at];
        used[at] = true;
        double least = INFINITY;
        int next = at;
        for (int k = 0; k < of->count; k++)
            if (!used[k] && between(middles[at], middles[k]) < least)
                least = between(middles[at], middles[k]), next = k;
        at = next;
    }
}

/* Puts the curves into the recipe's order; false: they do not fit. */
static bool order(const bat_context *c, bat_recipe_kind kind, bool closing, chosen *of) {
    double apart = 0;
    switch (kind) {
    case BAT_RECIPE_SWEEP: return order_sweep(of);
    case BAT_RECIPE_RULED: return of->count == 2 && !(of->closed && of->open);
    case BAT_RECIPE_REVOLVE: return order_revolve(of);
    case BAT_RECIPE_COONS: return goes_round(of, &apart) && closes(c, of, apart) == closing;
    case BAT_RECIPE_LOFT:
        if (of->count < 3 || (of->closed && of->open) || goes_round(of, &apart)) return false;
        order_loft(of);
        return true;
    }
    return false;
}

bool bat_making_fits(const bat_context *c, bat_recipe_kind kind, bool closing) {
    chosen of;
    return find(c, &of) && order(c, kind, closing, &of);
}

bool bat_making_offers_revolving(const bat_context *c) {
    chosen of;
    return c->choice->selection.count == 0 && find(c, &of) && of.count == 2 && order_revolve(&of) &&
           !is_straight(of.curves[0]) && is_beside(of.curves[0], of.curves[1]);
}

/* ---- making ---- */

static void tell_refusal(bat_context *c, bat_status status) {
    if (status == BAT_UNSUPPORTED)
        bat_notice(c, BAT_STRING_NOTICE_NO_SWEEP);
    else if (status == BAT_SINGULAR || status == BAT_COUNT || status == BAT_TOLERANCE)
        bat_notice(c, BAT_STRING_NOTICE_MAKES_NOTHING);
    else
        bat_notice_failure(c, status);
}

/* Folds come before everything else; where the page is seen from above, the notice offers to tilt the view. */
static void tell(bat_context *c, const bat_recipe_report *report, bool closing) {
    char text[BAT_UNIT_ROOM];
    if (report->folds > 0) {
        snprintf(text, sizeof text, "%d", (int)report->folds);
        bat_notice_value(c, BAT_STRING_NOTICE_FOLDS, text);
    } else if (closing) {
        bat_unit_write(c, report->apart, text);
        bat_notice_value(c, BAT_STRING_NOTICE_CORNERS_CLOSED, text);
    } else {
        bat_notice(c, BAT_STRING_NOTICE_SURFACE_MADE);
    }
    if (!bat_stage_tilted(c->stage)) c->notices->offer = BAT_COMMAND_ORBIT_UP;
}

/* Behind the hindmost of its curves, so that these can be grasped. */
static bat_status put_behind(bat_context *c, const chosen *of, const bat_object *made) {
    const bat_document *document = c->session->document;
    int index = bat_document_count(document);
    bat_object *placed = NULL;
    for (int i = 0; i < of->count; i++) {
        const int at = bat_document_find(document, bat_object_id(of->objects[i]));
        if (at < index) index = at;
    }
    bat_status status = bat_object_with_parent(made, bat_object_parent(bat_document_at(document, index)),
                                               &placed);
    if (status == BAT_OK) status = bat_transaction_insert(c, index, placed);
    bat_object_release(placed);
    return status;
}

static bat_status insert(bat_context *c, const bat_recipe *recipe, const chosen *of) {
    const bat_style style = bat_styling_new(c);
    const bat_id id = bat_document_new_id(c->session->document);
    bat_object *made = NULL;
    bat_status status = bat_object_create_made(id, "", &style, recipe, (size_t)of->count, of->objects, &made);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) status = bat_transaction_end(c, put_behind(c, of, made), BAT_STRING_STEP_SURFACE);
    bat_object_release(made);
    if (status != BAT_OK) return status;
    bat_selection_clear(&c->choice->selection);
    bat_selection_add(&c->choice->selection, id); /* out of memory: not selected */
    return BAT_OK;
}

static bat_status report_of(const bat_recipe *recipe, const chosen *of, bat_recipe_report *report) {
    bat_surface *surface = NULL;
    bat_status status = bat_recipe_surface(recipe, (size_t)of->count, of->curves, &surface, report);
    bat_surface_free(surface);
    return status;
}

bat_status bat_making_make(bat_context *c, bat_recipe_kind kind, bool closing) {
    bat_recipe recipe = bat_recipe_of(kind);
    bat_recipe_report report;
    chosen of;
    double apart = 0;
    if (!find(c, &of) || !order(c, kind, closing, &of)) return BAT_STATE;
    if (kind == BAT_RECIPE_COONS && goes_round(&of, &apart) && apart > MEETS * of.smallest && !closing) {
        char text[BAT_UNIT_ROOM];
        bat_unit_write(c, apart, text);
        bat_notice_value(c, BAT_STRING_NOTICE_CORNERS_APART, text);
        return BAT_STATE;
    }
    if (kind == BAT_RECIPE_SWEEP) recipe.stand = bat_recipe_stands(of.curves[0], of.curves[1]);
    bat_status status = report_of(&recipe, &of, &report);
    if (status == BAT_OK) status = insert(c, &recipe, &of);
    if (status == BAT_OK)
        tell(c, &report, closing);
    else
        tell_refusal(c, status);
    return status;
}

/* ---- free ---- */

static bool is_made(const bat_object *object) { return bat_object_recipe(object) != NULL; }

static bat_status freed(const bat_object *object, bat_object **out) {
    return bat_object_with_surface(object, bat_object_surface(object), out);
}

bool bat_making_can_free(const bat_context *c) {
    return bat_document_has_followers(c->session->document) && bat_each_any(c, is_made);
}

bat_status bat_making_free(bat_context *c) {
    return bat_each_replace(c, is_made, freed, BAT_STRING_STEP_SURFACE_FREE);
}

/* ---- numbers ---- */

static const bat_object *selected(const bat_context *c) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    return selection->count == 1 ? bat_document_at(document, bat_document_find(document, selection->ids[0]))
                                 : NULL;
}

/* The number in the recipe; NULL: it has none such. */
static double *number_in(bat_recipe *recipe, bat_making_number which) {
    if (recipe->kind == BAT_RECIPE_SWEEP && which == BAT_MAKING_TWIST) return &recipe->twist;
    if (recipe->kind == BAT_RECIPE_SWEEP && which == BAT_MAKING_SCALE) return &recipe->scale;
    if (recipe->kind == BAT_RECIPE_REVOLVE && which == BAT_MAKING_ANGLE) return &recipe->angle;
    return NULL;
}

bool bat_making_get(const bat_context *c, bat_making_number which, double *value) {
    const bat_object *object = selected(c);
    const bat_recipe *recipe = object ? bat_object_recipe(object) : NULL;
    if (!recipe) return false;
    bat_recipe copy = *recipe;
    const double *number = number_in(&copy, which);
    if (number) *value = *number;
    return number != NULL;
}

bat_status bat_making_set(bat_context *c, bat_making_number which, double value) {
    const bat_document *document = c->session->document;
    const bat_object *object = selected(c), *sources[BAT_RECIPE_CURVES];
    if (!object || !bat_object_recipe(object)) return BAT_STATE;
    bat_recipe recipe = *bat_object_recipe(object);
    double *number = number_in(&recipe, which);
    const size_t count = (size_t)bat_object_sources(object, NULL);
    if (!number || !bat_document_sources(document, object, sources)) return BAT_STATE;
    *number = value;
    bat_object *made = NULL;
    bat_status status = bat_object_with_recipe(object, &recipe, count, sources, &made);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        const int index = bat_document_find(document, bat_object_id(object));
        status = bat_transaction_end(c, bat_transaction_replace(c, index, made),
                                     BAT_STRING_STEP_SURFACE_NUMBER);
    }
    bat_object_release(made);
    return status;
}
