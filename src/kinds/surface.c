/* A surface in space. Its curves are its lines at the knots: they show it, and change only with it. It can be made from
 * curves of the drawing by a recipe: when they change, it is made again. Or its control points are bound to wires. Or it is the finest of a surface with
 * levels. */
#include "base/users.h"
#include "document/bound.h"
#include "document/digest.h"
#include "form/relief/relief.h"
#include "form/surface/surface.h"
#include "format/json/bound.h"
#include "format/json/fields.h"
#include "format/json/recipe.h"
#include "format/json/relief.h"
#include "format/json/style.h"
#include "format/json/surface.h"
#include "kinds/kinds.h"
#include "text/text.h"
#include <batten/recipe.h>

#include <stdlib.h>
#include <string.h>

enum { LINES = 65 }; /* in each direction at most; on finer surfaces not every knot has one */

/* The object's own part: a reference-counted value, shared by copies of the object. */
typedef struct kept_surface {
    bat_users users;
    bat_surface *surface; /* with levels: the finest, which the relief owns */
    bat_relief *relief;   /* NULL: it has no levels */
} kept_surface;

/* What it is made from: a value like that one. */
typedef struct kept_recipe {
    bat_users users;
    bat_recipe recipe;
    bool known; /* it is made of curves with these digests */
    bool moved; /* since then */
    int count;
    bat_id ids[BAT_RECIPE_CURVES];
    uint64_t digests[BAT_RECIPE_CURVES];
    bat_recipe_report report; /* when it is known */
} kept_recipe;

typedef struct own_part {
    kept_surface *kept;
    kept_recipe *made; /* NULL: it is not made of curves */
    bat_hold hold;     /* one of these at most */
} own_part;

static kept_surface *kept_of(const void *own) { return ((const own_part *)own)->kept; }
static kept_recipe *made_of(const void *own) { return ((const own_part *)own)->made; }
static const bat_hold *hold_of(const void *own) { return &((const own_part *)own)->hold; }

static void release(kept_surface *kept) {
    if (!kept || !bat_users_drop(&kept->users)) return;
    if (kept->relief)
        bat_relief_free(kept->relief);
    else
        bat_surface_free(kept->surface);
    free(kept);
}

static void drop(kept_recipe *made) {
    if (made && bat_users_drop(&made->users)) free(made);
}

static void share(const void *own) {
    bat_users_add(&kept_of(own)->users);
    if (made_of(own)) bat_users_add(&made_of(own)->users);
    if (hold_of(own)->bound) bat_bound_retain(hold_of(own)->bound);
}
static void end(void *own) {
    release(kept_of(own)), drop(made_of(own));
    bat_bound_release(hold_of(own)->bound);
}

/* ---- lines ---- */

static bool is_inner(const double *knots, int i, const double domain[2]) {
    return knots[i] > knots[i - 1] && knots[i] > domain[0] && knots[i] < domain[1];
}

/* Where the direction has lines: both ends, and knots between them, or as many of these as may be; closed: without the
 * end, which is the start. Ascending; returns how many. */
static int places(const bat_surface *surface, bat_direction direction, double out[LINES]) {
    const double *knots = bat_surface_knots(surface, direction);
    const int count = bat_surface_knot_count(surface, direction);
    double domain[2];
    bat_surface_domain(surface, direction, domain);
    int inner = 0, seen = 0, made = 1;
    for (int i = 1; i < count; i++) inner += is_inner(knots, i, domain);
    const int most = inner < LINES - 2 ? inner : LINES - 2;
    out[0] = domain[0];
    for (int i = 1; i < count; i++) {
        if (!is_inner(knots, i, domain)) continue;
        seen++; /* of `inner` knots take `most`, evenly */
        if ((long long)seen * most / inner > (long long)(seen - 1) * most / inner) out[made++] = knots[i];
    }
    if (!bat_surface_is_closed(surface, direction)) out[made++] = domain[1];
    return made;
}

/* At most 2 LINES curves, which the caller frees; on failure none are left. */
static bat_status lines_of(const bat_surface *surface, bat_curve *curves[2 * LINES], int *count) {
    bat_status status = BAT_OK;
    *count = 0;
    for (int d = 0; d < 2 && status == BAT_OK; d++) {
        double at[LINES];
        const int made = places(surface, (bat_direction)d, at);
        for (int i = 0; i < made && status == BAT_OK; i++) {
            status = bat_surface_isocurve(surface, (bat_direction)d, at[i], &curves[*count]);
            *count += status == BAT_OK;
        }
    }
    while (status != BAT_OK && *count > 0) bat_curve_free(curves[--*count]);
    return status;
}

/* ---- making ---- */

/* Makes a new object, or a copy of `object` with another surface, which is taken over on success, as are `made` and what
 * `hold` refers to (NULL: nothing). */
static bat_status make_held(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                            bat_surface *surface, kept_recipe *made, const bat_hold *hold, bat_object **out) {
    bat_curve *curves[2 * LINES];
    int count;
    bat_status status = lines_of(surface, curves, &count);
    if (status != BAT_OK) return status;
    own_part own = {.kept = malloc(sizeof *own.kept), .made = made};
    if (hold) own.hold = *hold;
    if (own.kept) *own.kept = (kept_surface){BAT_USERS_ONE, surface, NULL};
    status = !own.kept ? BAT_MEMORY
             : object  ? bat_object_remake(object, &bat_kind_of_surface, &own, count, curves, out)
                       : bat_object_make(&bat_kind_of_surface, id, name, style, &own, count, curves, out);
    if (status == BAT_OK) return BAT_OK;
    for (int i = 0; i < count; i++) bat_curve_free(curves[i]);
    free(own.kept);
    return status;
}

static bat_status make(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                       bat_surface *surface, kept_recipe *made, bat_object **out) {
    return make_held(object, id, name, style, surface, made, NULL, out);
}

static bat_status make_of_copy(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                               const bat_surface *surface, bat_object **out) {
    bat_surface *copy = NULL;
    bat_status status = surface && out ? bat_surface_copy(surface, &copy) : BAT_ARGUMENT;
    if (status == BAT_OK) status = make(object, id, name, style, copy, NULL, out);
    if (status != BAT_OK) bat_surface_free(copy);
    return status;
}

/* The same for a surface with levels, which is taken over on success. */
static bat_status make_levelled(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                                bat_relief *relief, bat_object **out) {
    bat_surface *finest = (bat_surface *)bat_relief_surface(relief, bat_relief_levels(relief));
    bat_status status = make(object, id, name, style, finest, NULL, out);
    if (status == BAT_OK) kept_of(bat_object_own(*out, &bat_kind_of_surface))->relief = relief;
    return status;
}

bat_status bat_object_with_relief(const bat_object *object, const bat_relief *relief, bat_object **out) {
    bat_relief *copy = NULL;
    if (!object || !bat_object_surface(object) || !relief || !out) return BAT_ARGUMENT;
    bat_status status = bat_relief_copy(relief, &copy);
    if (status == BAT_OK) status = make_levelled(object, 0, NULL, NULL, copy, out);
    if (status != BAT_OK) bat_relief_free(copy);
    return status;
}

const bat_relief *bat_object_relief(const bat_object *object) {
    const void *own = bat_object_own(object, &bat_kind_of_surface);
    return own ? kept_of(own)->relief : NULL;
}

bat_status bat_object_create_surface(bat_id id, const char *name, const bat_style *style,
                                     const bat_surface *surface, bat_object **out) {
    return style ? make_of_copy(NULL, id, name, style, surface, out) : BAT_ARGUMENT;
}

bat_status bat_object_with_surface(const bat_object *object, const bat_surface *surface, bat_object **out) {
    return object && bat_object_surface(object) ? make_of_copy(object, 0, NULL, NULL, surface, out)
                                                : BAT_ARGUMENT;
}

const bat_surface *bat_object_surface(const bat_object *object) {
    const void *own = bat_object_own(object, &bat_kind_of_surface);
    return own ? kept_of(own)->surface : NULL;
}

/* ---- what it is made from ---- */

/* Without what has no meaning for its kind, as files keep it. */
static bat_recipe plain(const bat_recipe *recipe) {
    bat_recipe kept = bat_recipe_of(recipe->kind);
    if (recipe->kind == BAT_RECIPE_SWEEP)
        kept.stand = recipe->stand, kept.twist = recipe->twist, kept.scale = recipe->scale;
    if (recipe->kind == BAT_RECIPE_REVOLVE) kept.angle = recipe->angle;
    return kept;
}

static kept_recipe *note(const bat_recipe *recipe, int count, const bat_id *ids) {
    kept_recipe *made = calloc(1, sizeof *made);
    if (!made) return NULL;
    *made = (kept_recipe){.users = BAT_USERS_ONE, .recipe = plain(recipe), .count = count};
    memcpy(made->ids, ids, (size_t)count * sizeof *ids);
    return made;
}

/* The surface of a recipe, made from objects whose digests are noted. */
static bat_status cook(kept_recipe *made, const bat_object *const *from, bat_surface **out) {
    const bat_curve *curves[BAT_RECIPE_CURVES];
    for (int i = 0; i < made->count; i++) {
        curves[i] = bat_object_curve(from[i], 0);
        made->digests[i] = bat_object_curve_digest(from[i], 0);
    }
    made->known = true;
    return bat_recipe_surface(&made->recipe, (size_t)made->count, curves, out, &made->report);
}

static bat_status take_ids(bat_id id, size_t count, const bat_object *const *sources, bat_id *ids) {
    for (size_t i = 0; i < count; i++) {
        if (!bat_object_is_made_of_curves(sources[i])) return BAT_ARGUMENT;
        ids[i] = bat_object_id(sources[i]);
        for (size_t k = 0; k < i; k++)
            if (ids[k] == ids[i]) return BAT_ARGUMENT;
        if (ids[i] == id) return BAT_ARGUMENT;
    }
    return BAT_OK;
}

static bat_status make_from(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                            const bat_recipe *recipe, size_t count, const bat_object *const *sources,
                            bat_object **out) {
    bat_id ids[BAT_RECIPE_CURVES];
    bat_surface *surface = NULL;
    bat_status status = bat_recipe_check(recipe, count, NULL);
    if (status == BAT_OK) status = sources && out ? BAT_OK : BAT_ARGUMENT;
    if (status == BAT_OK) status = take_ids(object ? bat_object_id(object) : id, count, sources, ids);
    if (status != BAT_OK) return status;
    kept_recipe *made = note(recipe, (int)count, ids);
    status = made ? cook(made, sources, &surface) : BAT_MEMORY;
    if (status == BAT_OK) status = make(object, id, name, style, surface, made, out);
    if (status == BAT_OK) return BAT_OK;
    bat_surface_free(surface), drop(made);
    return status;
}

bat_status bat_object_create_made(bat_id id, const char *name, const bat_style *style,
                                  const bat_recipe *recipe, size_t count, const bat_object *const *sources,
                                  bat_object **out) {
    return style ? make_from(NULL, id, name, style, recipe, count, sources, out) : BAT_ARGUMENT;
}

bat_status bat_object_with_recipe(const bat_object *object, const bat_recipe *recipe, size_t count,
                                  const bat_object *const *sources, bat_object **out) {
    return object && bat_object_surface(object)
               ? make_from(object, 0, NULL, NULL, recipe, count, sources, out)
               : BAT_ARGUMENT;
}

const bat_recipe *bat_object_recipe(const bat_object *object) {
    const void *own = bat_object_own(object, &bat_kind_of_surface);
    return own && made_of(own) ? &made_of(own)->recipe : NULL;
}

size_t bat_object_folds(const bat_object *object, double *out) {
    const void *own = bat_object_own(object, &bat_kind_of_surface);
    const kept_recipe *made = own ? made_of(own) : NULL;
    if (!made || !made->known) return 0;
    const size_t count = made->report.folds;
    for (size_t i = 0; out && i < 2 * count && i < 2 * BAT_RECIPE_FOLDS; i++) out[i] = made->report.folded[i];
    return count;
}

static const bat_id *sources(const bat_object *object, int *count) {
    const bat_hold *hold = bat_object_hold(object);
    const kept_recipe *made = made_of(bat_object_own(object, &bat_kind_of_surface));
    if (hold) {
        *count = hold->bound->source_count;
        return hold->bound->ids;
    }
    *count = made ? made->count : 0;
    return made ? made->ids : NULL;
}

/* A copy of the object with the same surface, made as noted, which is taken over on success; NULL: free. */
static bat_status with_note(const bat_object *object, kept_recipe *made, bat_object **out) {
    bat_surface *copy = NULL;
    bat_status status = bat_surface_copy(bat_object_surface(object), &copy);
    if (status == BAT_OK) status = make(object, 0, NULL, NULL, copy, made, out);
    if (status != BAT_OK) bat_surface_free(copy);
    return status;
}

static bool is_up_to_date(const kept_recipe *made, const bat_object *const *from) {
    bool same = made->known;
    for (int i = 0; i < made->count && same; i++)
        same = made->digests[i] == bat_object_curve_digest(from[i], 0);
    return same;
}

/* One of its objects is not there. */
static bool is_short(const kept_recipe *made, const bat_id *ids, const bat_object *const *from) {
    for (int i = 0; i < made->count; i++)
        if (ids ? !ids[i] : from && !from[i]) return true;
    return false;
}

static bat_status remake(const bat_object *object, const bat_id *ids, const bat_object *const *from,
                         bat_object **out) {
    const kept_recipe *now = made_of(bat_object_own(object, &bat_kind_of_surface));
    *out = NULL;
    if (!now) return bat_bound_remake(object, ids, from, out);
    if (is_short(now, ids, from)) return with_note(object, NULL, out);
    if (!ids && from && is_up_to_date(now, from)) {
        if (!now->moved) return BAT_OK;
        from = NULL; /* it was moved away from its curves */
    }
    if (!ids && !from) return with_note(object, NULL, out);
    kept_recipe *made = note(&now->recipe, now->count, ids ? ids : now->ids);
    if (!made) return BAT_MEMORY;
    bat_surface *surface = NULL;
    bat_status status = ids ? with_note(object, made, out) : cook(made, from, &surface);
    if (status == BAT_OK && !ids) status = make(object, 0, NULL, NULL, surface, made, out);
    if (status == BAT_OK) return BAT_OK;
    bat_surface_free(surface);
    drop(made);
    return status == BAT_MEMORY ? status : with_note(object, NULL, out);
}

/* ---- what it is bound to ---- */

static const bat_hold *hold(const void *own) { return hold_of(own); }

static size_t points(const bat_object *object, double *out) {
    const bat_surface *surface = bat_object_surface(object);
    const size_t rows = bat_surface_count(surface, BAT_U), width = 3 * bat_surface_count(surface, BAT_V);
    for (size_t i = 0; i < rows && out; i++)
        memcpy(out + i * width, bat_surface_row(surface, (int)i), width * sizeof *out);
    return rows * width / 3;
}

static bat_status with_points(const bat_surface *surface, const double *points, bat_surface **out) {
    int degree[2], knots[2];
    bool closed[2];
    size_t count[2];
    for (int d = 0; d < 2; d++) {
        degree[d] = bat_surface_degree(surface, (bat_direction)d);
        knots[d] = bat_surface_knot_count(surface, (bat_direction)d);
        closed[d] = bat_surface_is_closed(surface, (bat_direction)d);
        count[d] = bat_surface_count(surface, (bat_direction)d);
    }
    return bat_surface_create(degree, closed, count, points, knots, bat_surface_knots(surface, BAT_U),
                              bat_surface_knots(surface, BAT_V), out);
}

static bat_status put(const bat_object *object, const double *points, const bat_hold *hold,
                      bat_object **out) {
    bat_surface *surface = NULL;
    bat_status status = with_points(bat_object_surface(object), points, &surface);
    if (status != BAT_OK) return status;
    status = make_held(object, 0, NULL, NULL, surface, NULL, hold, out);
    if (status != BAT_OK)
        bat_surface_free(surface);
    else if (hold->bound)
        bat_bound_retain(hold->bound);
    return status;
}

/* ---- what the document asks ---- */

static uint64_t digest_shape(uint64_t digest, const bat_surface *surface) {
    const size_t width = 3 * bat_surface_count(surface, BAT_V);
    for (int d = 0; d < 2; d++) {
        const double *knots = bat_surface_knots(surface, (bat_direction)d);
        const int count = bat_surface_knot_count(surface, (bat_direction)d);
        digest = bat_digest_number(digest, (uint64_t)bat_surface_degree(surface, (bat_direction)d));
        digest = bat_digest_number(digest, bat_surface_is_closed(surface, (bat_direction)d));
        digest = bat_digest_number(digest, (uint64_t)count);
        for (int i = 0; i < count; i++) digest = bat_digest_double(digest, knots[i]);
    }
    for (int i = 0; i < (int)bat_surface_count(surface, BAT_U); i++) {
        const double *row = bat_surface_row(surface, i);
        for (size_t k = 0; k < width; k++) digest = bat_digest_double(digest, row[k]);
    }
    return digest;
}

/* The base, and each level's knots and details; its surface follows. */
static uint64_t digest_levels(uint64_t digest, const bat_relief *relief) {
    digest = bat_digest_number(digest, (uint64_t)bat_relief_levels(relief));
    digest = digest_shape(digest, bat_relief_surface(relief, 0));
    for (int l = 1; l <= bat_relief_levels(relief); l++) {
        const bat_surface *surface = bat_relief_surface(relief, l);
        const size_t n = bat_surface_count(surface, BAT_U) * bat_surface_count(surface, BAT_V);
        const double *details = bat_relief_details(relief, l);
        for (int d = 0; d < 2; d++) {
            const double *knots = bat_surface_knots(surface, (bat_direction)d);
            const int count = bat_surface_knot_count(surface, (bat_direction)d);
            for (int i = 0; i < count; i++) digest = bat_digest_double(digest, knots[i]);
        }
        for (size_t i = 0; i < 3 * n; i++) digest = bat_digest_double(digest, details[i]);
        for (size_t i = 0; i < n; i++)
            digest = bat_digest_number(digest, (uint64_t)bat_relief_source(relief, l)[i]);
        digest = bat_digest_double(digest, bat_relief_gain(relief, l));
        digest = bat_digest_number(digest, bat_relief_is_muted(relief, l));
    }
    return digest;
}

static uint64_t digest_surface(uint64_t digest, const void *own) {
    digest = digest_shape(digest, kept_of(own)->surface);
    if (kept_of(own)->relief) digest = digest_levels(digest, kept_of(own)->relief);
    const kept_recipe *made = made_of(own);
    if (hold_of(own)->bound) digest = bat_digest_number(digest, hold_of(own)->bound->digest);
    if (!made) return digest;
    digest = bat_digest_number(digest, (uint64_t)made->recipe.kind);
    digest = bat_digest_number(digest, (uint64_t)made->recipe.stand);
    digest = bat_digest_double(digest, made->recipe.twist);
    digest = bat_digest_double(digest, made->recipe.scale);
    digest = bat_digest_double(digest, made->recipe.angle);
    for (int i = 0; i < made->count; i++) digest = bat_digest_number(digest, made->ids[i]);
    return bat_digest_number(digest, (uint64_t)made->count);
}

static const char *check(const bat_object *object) {
    bat_curve *curves[2 * LINES];
    int count;
    if (lines_of(bat_object_surface(object), curves, &count) != BAT_OK) return NULL; /* out of memory */
    bool same = count == bat_object_curve_count(object);
    for (int i = 0; i < count; i++) {
        same = same && bat_curve_is_equal(curves[i], bat_object_curve(object, i));
        bat_curve_free(curves[i]);
    }
    return same ? NULL : "the lines of a surface are not where its knots are";
}

/* Every level is the image of what it was. */
static bat_status transform_levels(const bat_object *object, const double rows[12], bat_object **out) {
    bat_relief *image = NULL;
    bat_status status = bat_relief_copy(bat_object_relief(object), &image);
    if (status == BAT_OK) status = bat_relief_transform(image, rows);
    if (status == BAT_OK) status = make_levelled(object, 0, NULL, NULL, image, out);
    if (status != BAT_OK) bat_relief_free(image);
    return status;
}

/* What it is made from is kept: whether it was moved with it is seen when it is asked to follow. */
static bat_status transform(const bat_object *object, const double rows[12], bat_object **out) {
    const kept_recipe *now = made_of(bat_object_own(object, &bat_kind_of_surface));
    bat_surface *image = NULL;
    kept_recipe *made = NULL;
    if (bat_object_hold(object)) return bat_bound_transform(object, rows, out);
    if (bat_object_relief(object)) return transform_levels(object, rows, out);
    bat_status status = bat_surface_transform(bat_object_surface(object), rows, &image);
    if (status == BAT_OK && now) {
        made = note(&now->recipe, now->count, now->ids);
        status = made ? BAT_OK : BAT_MEMORY;
    }
    if (status == BAT_OK && made) {
        memcpy(made->digests, now->digests, sizeof made->digests);
        made->known = now->known, made->moved = true;
    }
    if (status == BAT_OK) status = make(object, 0, NULL, NULL, image, made, out);
    if (status != BAT_OK) bat_surface_free(image), drop(made);
    return status;
}

/* ---- the other side ---- */

static bat_status flip_levels(const bat_object *object, bat_object **out) {
    bat_relief *turned = NULL;
    bat_status status = bat_relief_transpose(bat_object_relief(object), &turned);
    if (status == BAT_OK) status = make_levelled(object, 0, NULL, NULL, turned, out);
    if (status != BAT_OK) bat_relief_free(turned);
    return status;
}

/* What it is bound to, with columns as rows. */
static bat_status flip_hold(const bat_object *object, bat_hold *out) {
    const bat_surface *surface = bat_object_surface(object);
    const size_t rows = bat_surface_count(surface, BAT_U), columns = bat_surface_count(surface, BAT_V);
    size_t *order = malloc(rows * columns * sizeof *order);
    if (!order) return BAT_MEMORY;
    for (size_t i = 0; i < rows; i++)
        for (size_t j = 0; j < columns; j++) order[j * rows + i] = i * columns + j;
    const bat_status status = bat_bound_reorder(bat_object_hold(object), order, out);
    free(order);
    return status;
}

/* u and v change places. */
static bat_status flip(const bat_object *object, bat_object **out) {
    bat_surface *turned = NULL;
    bat_hold hold = {.bound = NULL};
    if (bat_object_relief(object)) return flip_levels(object, out);
    bat_status status = bat_surface_transpose(bat_object_surface(object), &turned);
    if (status == BAT_OK && bat_object_hold(object)) status = flip_hold(object, &hold);
    if (status == BAT_OK) status = make_held(object, 0, NULL, NULL, turned, NULL, &hold, out);
    if (status == BAT_OK) return BAT_OK;
    bat_surface_free(turned);
    bat_bound_release(hold.bound);
    return status;
}

/* ---- files: the lines are not written, as they are computed from the surface ---- */

static bat_status read_levels(const bat_fields *f, uint32_t node, bat_id id, const char *name,
                              bat_object **out) {
    bat_style style = bat_style_defaults();
    bat_relief *relief = NULL;
    bat_status status = bat_style_from_json(f, node, &style);
    if (status == BAT_OK &&
        (bat_json_member(f->json, node, "surface") || bat_json_member(f->json, node, "made")))
        return bat_fields_complain(f, node, "relief", "no surface and no made beside it");
    if (status == BAT_OK)
        status = bat_relief_from_json(f->json, bat_json_member(f->json, node, "relief"), &relief, f->problem);
    if (status != BAT_OK) return status;
    status = make_levelled(NULL, id, name, &style, relief, out);
    if (status == BAT_OK) return BAT_OK;
    bat_relief_free(relief);
    return bat_fields_say(f, node, status);
}

static bat_status read(const bat_fields *f, uint32_t node, bat_id id, const char *name, bat_object **out) {
    if (bat_json_member(f->json, node, "relief")) return read_levels(f, node, id, name, out);
    bat_style style = bat_style_defaults();
    bat_surface *surface = NULL;
    kept_recipe *made = NULL;
    const uint32_t member = bat_json_member(f->json, node, "surface"),
                   from = bat_json_member(f->json, node, "made");
    bat_recipe recipe;
    bat_id ids[BAT_RECIPE_CURVES];
    int count = 0;
    bat_status status = bat_style_from_json(f, node, &style);
    if (status == BAT_OK && !member) return bat_fields_complain(f, node, "surface", "an object");
    if (status == BAT_OK && from) status = bat_recipe_from_json(f, from, &recipe, ids, &count);
    if (status == BAT_OK) status = bat_surface_from_json(f->json, member, &surface, f->problem);
    if (status != BAT_OK) return status;
    if (from && !(made = note(&recipe, count, ids))) status = BAT_MEMORY;
    if (status == BAT_OK) status = make(NULL, id, name, &style, surface, made, out);
    if (status == BAT_OK) return made ? BAT_OK : bat_bound_read(f, node, out);
    bat_surface_free(surface), drop(made);
    return bat_fields_say(f, node, status);
}

static void write(const bat_object *object, bat_text *text) {
    const kept_recipe *made = made_of(bat_object_own(object, &bat_kind_of_surface));
    bat_text_string(text, ",\n  \"style\":");
    bat_style_to_json(bat_object_style(object), text);
    if (made) {
        bat_text_string(text, ",\n  \"made\":");
        bat_recipe_to_json(&made->recipe, made->count, made->ids, text);
    }
    const bat_relief *relief = bat_object_relief(object);
    bat_text_string(text, relief ? ",\n  \"relief\":" : ",\n  \"surface\":");
    if (relief)
        bat_relief_to_json(relief, text);
    else
        bat_surface_to_json(bat_object_surface(object), text);
    bat_bound_write(object, text);
}

const bat_kind_type bat_kind_of_surface = {.number = BAT_KIND_SURFACE,
                                           .name = "surface",
                                           .traits = BAT_DRAWN | BAT_CURVES | BAT_MADE | BAT_FIXED |
                                                     BAT_SPACE,
                                           .size = sizeof(own_part),
                                           .share = share,
                                           .end = end,
                                           .check = check,
                                           .digest = digest_surface,
                                           .transform = transform,
                                           .flip = flip,
                                           .sources = sources,
                                           .remake = remake,
                                           .points = points,
                                           .hold = hold,
                                           .put = put,
                                           .write = write,
                                           .read = read};
