#include "editor/show/followers.h"
#include "document/bound.h"
#include "document/document.h"
#include "document/kind.h"
#include "editor/choice/choice.h"
#include "editor/scene/path.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/tubes.h"
#include "editor/tables/tables.h"
#include "editor/view/stage.h"
#include "editor/view/unit.h"
#include <batten/mesh.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINES = 40, SAMPLES = 65, EDGES = 20000, HATCHES = 24 };
static const double HARDLY = 1e-3; /* of what moves farthest */

/* ---- computed ---- */

/* How far the points of what is bound are from where they were when it was bound. Where the wire's reach ends, and at the ends of
 * what was redrawn, they hardly move. */
static void measure(const bat_object *object, bat_follow_numbers *f) {
    const bat_hold *hold = bat_object_hold(object);
    if (!hold) return;
    const size_t count = hold->bound->point_count;
    const double *rest = hold->bound->rest;
    double farthest = 0;
    double *now = malloc((3 * count + 1) * sizeof *now);
    if (!now) return; /* only the numbers lack them */
    bat_object_type(object)->points(object, now);
    for (size_t i = 0; i < count; i++) {
        const double x = now[3 * i] - rest[3 * i], y = now[3 * i + 1] - rest[3 * i + 1],
                     z = now[3 * i + 2] - rest[3 * i + 2];
        now[i] = sqrt(x * x + y * y + z * z);
        farthest = fmax(farthest, now[i]);
    }
    for (size_t i = 0; i < count; i++) f->moved += now[i] > HARDLY * farthest;
    f->farthest = fmax(f->farthest, farthest);
    free(now);
}

static void count_in(const bat_object *follower, bat_follow_numbers *f) {
    const bat_recipe *recipe = bat_object_recipe(follower);
    measure(follower, f);
    if (recipe && !f->made) f->made = true, f->recipe = *recipe;
    f->folds += bat_object_folds(follower, NULL);
    f->freed += bat_object_sources(follower, NULL) == 0;
}

enum { CHANGES = 2 };

/* The objects as they would be; NULL: none such. */
static void would_be(const bat_document *document, int count, const bat_follow_change *changes,
                     bat_object *then[CHANGES]) {
    for (int k = 0; k < count; k++) {
        const bat_object *now = bat_document_at(document, bat_document_find(document, changes[k].id));
        bat_curve *copy = NULL;
        then[k] = NULL;
        if (now && bat_curve_copy(changes[k].curve, &copy) == BAT_OK)
            bat_object_with_curve(now, 0, copy, &then[k]); /* on failure what follows it is not shown */
    }
}

/* What would become of it if these objects were put in, by the same call as in the end; NULL: nothing. */
static bat_status would_follow(const bat_document *document, int index, int count, bat_object *const *then,
                               bat_object **out) {
    const bat_object *object = bat_document_at(document, index), *from[BAT_RECIPE_CURVES];
    *out = NULL;
    if (!bat_document_sources(document, object, from)) return BAT_OK;
    const int sources = bat_object_sources(object, NULL);
    bool follows = false;
    for (int i = 0; i < sources; i++)
        for (int k = 0; k < count; k++)
            if (then[k] && bat_object_id(from[i]) == bat_object_id(then[k])) {
                from[i] = then[k], follows = true;
                break;
            }
    return follows ? bat_object_type(object)->remake(object, NULL, from, out) : BAT_OK;
}

void bat_followers_of(const bat_context *c, int count, const bat_follow_change *changes, bat_followers *out) {
    const bat_document *document = c->session->document;
    bat_object *then[CHANGES] = {NULL};
    *out = (bat_followers){.count = 0};
    if (!bat_document_has_followers(document)) return;
    would_be(document, count < CHANGES ? count : CHANGES, changes, then);
    for (int i = 0; i < bat_document_count(document) && out->count < BAT_FOLLOWERS; i++) {
        bat_object *made = NULL;
        if (would_follow(document, i, CHANGES, then, &made) != BAT_OK || !made) continue;
        out->objects[out->count++] = made;
        count_in(made, &out->numbers);
    }
    for (int k = 0; k < CHANGES; k++) bat_object_release(then[k]);
}

void bat_follow_numbers_now(const bat_context *c, bat_follow_numbers *out) {
    const bat_transaction *transaction = &c->session->transaction;
    *out = (bat_follow_numbers){.moved = 0};
    for (int i = 0; i < transaction->count && transaction->open; i++) {
        const bat_delta *delta = &transaction->deltas[i];
        if (delta->before && delta->after && bat_object_sources(delta->before, NULL) > 0)
            count_in(delta->after, out);
    }
}

void bat_follow_numbers_selected(const bat_context *c, bat_follow_numbers *out) {
    const bat_document *document = c->session->document;
    *out = (bat_follow_numbers){.moved = 0};
    if (c->choice->selection.count != 1) return;
    const bat_object *object = bat_document_at(document,
                                               bat_document_find(document, c->choice->selection.ids[0]));
    if (object && bat_object_recipe(object)) count_in(object, out);
}

void bat_followers_clear(bat_followers *f) {
    for (int i = 0; i < f->count; i++) bat_object_release(f->objects[i]);
    *f = (bat_followers){.count = 0};
}

/* ---- shown ---- */

static void add_point(const bat_context *c, const double point[3], bool *on, bat_overlay *overlay) {
    double at[2];
    const bool seen = bat_stage_look(c->stage, 3, point, at);
    if (seen) (*on ? bat_path_line : bat_path_move)(&overlay->path, at[0], at[1]);
    *on = seen;
}

static void add_line(const bat_context *c, const bat_surface *surface, const double from[2],
                     const double to[2], int samples, bat_overlay *overlay) {
    bool on = false;
    for (int k = 0; k < samples; k++) {
        const double t = k / (samples - 1.0);
        double point[3];
        bat_surface_eval(surface, from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]), 0, point);
        add_point(c, point, &on, overlay);
    }
}

/* The ranges of u and v in which the control points are others than before; false: none. */
static bool range_of(const bat_surface *before, const bat_surface *now, double range[2][2]) {
    int least[2] = {1 << 30, 1 << 30}, most[2] = {-1, -1};
    for (int d = 0; d < 2; d++) bat_surface_domain(now, (bat_direction)d, range[d]);
    const int rows = (int)bat_surface_count(now, BAT_U), width = (int)bat_surface_count(now, BAT_V);
    if (!before || (int)bat_surface_count(before, BAT_U) != rows ||
        (int)bat_surface_count(before, BAT_V) != width)
        return true;
    for (int i = 0; i < rows * width; i++) {
        const int at[2] = {i / width, i % width};
        const double *p = bat_surface_row(before, at[0]) + (ptrdiff_t)3 * at[1],
                     *q = bat_surface_row(now, at[0]) + (ptrdiff_t)3 * at[1];
        if (p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) continue;
        for (int d = 0; d < 2; d++) {
            least[d] = at[d] < least[d] ? at[d] : least[d];
            most[d] = at[d] > most[d] ? at[d] : most[d];
        }
    }
    for (int d = 0; d < 2 && most[0] >= 0; d++) {
        const double *knots = bat_surface_knots(now, (bat_direction)d);
        const int last = most[d] + bat_surface_degree(now, (bat_direction)d) + 1;
        if (bat_surface_is_closed(now, (bat_direction)d)) continue; /* supports go round */
        range[d][0] = fmax(range[d][0], knots[least[d]]), range[d][1] = fmin(range[d][1], knots[last]);
    }
    return most[0] >= 0;
}

/* Lines at knots, evenly thinned out where there are many. */
static void show_surface(const bat_context *c, const bat_surface *before, const bat_surface *now,
                         bat_overlay *overlay) {
    double range[2][2];
    if (!range_of(before, now, range)) return;
    for (int d = 0; d < 2; d++) {
        const double *knots = bat_surface_knots(now, (bat_direction)d);
        const int count = bat_surface_knot_count(now, (bat_direction)d);
        int inside = 0, passed = 0;
        for (int k = 0; k < count; k++)
            inside += knots[k] >= range[d][0] && knots[k] <= range[d][1] &&
                      (k == 0 || knots[k] > knots[k - 1]);
        for (int k = 0; k < count; k++) {
            if (knots[k] < range[d][0] || knots[k] > range[d][1] || (k > 0 && knots[k] == knots[k - 1]))
                continue;
            if (passed++ % (1 + inside / LINES)) continue;
            double from[2] = {range[0][0], range[1][0]}, to[2] = {range[0][1], range[1][1]};
            from[d] = to[d] = knots[k];
            add_line(c, now, from, to, SAMPLES, overlay);
        }
    }
}

/* The edges at the vertices that moved, thinned out where there are many. */
static void show_mesh(const bat_context *c, const bat_polymesh *before, const bat_polymesh *now,
                      bat_overlay *overlay) {
    const double *p = bat_polymesh_vertices(before), *q = bat_polymesh_vertices(now);
    const size_t faces = bat_polymesh_face_count(now), every = 1 + 4 * faces / EDGES;
    for (size_t f = 0; f < faces; f += every) {
        size_t n;
        const int *face = bat_polymesh_face(now, f, &n);
        bool moves = false, on = false;
        for (size_t k = 0; k < n; k++)
            moves = moves ||
                    memcmp(p + (ptrdiff_t)3 * face[k], q + (ptrdiff_t)3 * face[k], 3 * sizeof *p) != 0;
        for (size_t k = 0; moves && k <= n; k++) add_point(c, q + (ptrdiff_t)3 * face[k % n], &on, overlay);
    }
}

static void show_one(const bat_context *c, const bat_object *before, const bat_object *now,
                     bat_overlay *overlay) {
    const bat_polymesh *mesh = bat_object_mesh(now);
    bat_overlay_item(overlay, BAT_ROLE_FIT, BAT_ITEM_STROKED, 1.5F);
    if (bat_object_surface(now))
        show_surface(c, bat_object_surface(before), bat_object_surface(now), overlay);
    else if (mesh)
        show_mesh(c, bat_object_mesh(before), mesh, overlay);
    else
        for (int i = 0; i < bat_object_curve_count(now); i++)
            bat_path_curve(&overlay->path, bat_object_curve(now, i));
}

void bat_followers_show(const bat_context *c, bat_followers *f, bat_overlay *overlay) {
    const bat_document *document = c->session->document;
    f->numbers.torn = 0;
    for (int i = 0; i < f->count; i++) {
        const bat_object *before = bat_document_at(document,
                                                   bat_document_find(document, bat_object_id(f->objects[i])));
        if (!before) continue;
        show_one(c, before, f->objects[i], overlay);
        f->numbers.torn += bat_torn_show(c, f->objects[i], overlay);
        bat_folds_show(c, f->objects[i], overlay);
    }
}

/* ---- numbers ---- */

/* Adds the word, the number in its hole. */
static void say(const bat_context *c, bat_string word, const char *number, char text[BAT_FOLLOWERS_ROOM]) {
    if (*text) snprintf(text + strlen(text), BAT_FOLLOWERS_ROOM - strlen(text), ", ");
    const size_t used = strlen(text);
    bat_word_fill(c, word, 1, &number, text + used, BAT_FOLLOWERS_ROOM - used);
}

static void say_recipe(const bat_context *c, const bat_recipe *recipe, char text[BAT_FOLLOWERS_ROOM]) {
    char number[BAT_UNIT_ROOM];
    if (recipe->kind == BAT_RECIPE_SWEEP) {
        bat_unit_number(recipe->twist, number);
        say(c, BAT_STRING_NUMBER_TWIST, number, text);
        bat_unit_number(recipe->scale, number);
        say(c, BAT_STRING_NUMBER_SCALE, number, text);
    } else if (recipe->kind == BAT_RECIPE_REVOLVE) {
        bat_unit_number(recipe->angle, number);
        say(c, BAT_STRING_NUMBER_ANGLE, number, text);
    }
}

void bat_follow_numbers_write(const bat_context *c, const bat_follow_numbers *n,
                              char text[BAT_FOLLOWERS_ROOM]) {
    const size_t counts[] = {n->torn, n->folds, n->freed};
    const bat_string words[] = {BAT_STRING_NUMBER_TORN, BAT_STRING_NUMBER_FOLDS, BAT_STRING_NUMBER_FREED};
    char number[BAT_UNIT_ROOM];
    text[0] = 0;
    if (n->moved > 0) {
        snprintf(number, sizeof number, "%zu", n->moved);
        say(c, BAT_STRING_NUMBER_MOVED, number, text);
        bat_unit_write(c, n->farthest, number);
        say(c, BAT_STRING_NUMBER_FARTHEST, number, text);
    }
    for (int k = 0; k < 3; k++) {
        snprintf(number, sizeof number, "%zu", counts[k]);
        if (counts[k] > 0) say(c, words[k], number, text);
    }
    if (n->made) say_recipe(c, &n->recipe, text);
}

/* ---- folds ---- */

void bat_folds_show(const bat_context *c, const bat_object *object, bat_overlay *overlay) {
    double folds[2 * BAT_RECIPE_FOLDS], v[2];
    size_t count = bat_object_folds(object, folds);
    if (count == 0) return;
    if (count > BAT_RECIPE_FOLDS) count = BAT_RECIPE_FOLDS;
    const bat_surface *surface = bat_object_surface(object);
    bat_surface_domain(surface, BAT_V, v);
    bat_overlay_item(overlay, BAT_ROLE_ERASED, BAT_ITEM_STROKED, 1.5F);
    for (size_t i = 0; i < count; i++) {
        const double *u = folds + 2 * i;
        for (int k = 0; k <= HATCHES;
             k++) { /* slanted across the stretch, from one edge of it to the other */
            const double at = v[0] + (v[1] - v[0]) * k / HATCHES, on = fmin(at + (v[1] - v[0]) / 8, v[1]);
            const double part = v[1] > v[0] ? 8 * (on - at) / (v[1] - v[0]) : 1;
            const double to = u[0] + (u[1] - u[0]) * (k == HATCHES ? 1 : part);
            add_line(c, surface, (const double[2]){u[0], at}, (const double[2]){to, on}, 17, overlay);
        }
        for (int k = 0; k < 2; k++)
            add_line(c, surface, (const double[2]){u[k], v[0]}, (const double[2]){u[k], v[1]}, SAMPLES,
                     overlay);
    }
}

void bat_folds_show_chosen(const bat_context *c, bat_overlay *overlay) {
    const bat_document *document = c->session->document;
    const bat_selection *selection = &c->choice->selection;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        const bat_id *ids = NULL;
        if (bat_object_folds(object, NULL) == 0) continue;
        const int count = bat_object_sources(object, &ids);
        bool chosen = bat_selection_has(selection, bat_object_id(object));
        for (int k = 0; k < count && !chosen; k++) chosen = bat_selection_has(selection, ids[k]);
        if (chosen) bat_folds_show(c, object, overlay);
    }
}
