/* A surface in space. Its curves are its lines at the knots: they show it, and change only with it. */
#include "base/matrix.h"
#include "base/users.h"
#include "document/digest.h"
#include "format/json/fields.h"
#include "format/json/style.h"
#include "format/json/surface.h"
#include "kinds/kinds.h"
#include "text/text.h"

#include <stdlib.h>

enum { LINES = 65 }; /* in each direction at most; on finer surfaces not every knot has one */

/* The object's own part: a reference-counted value, shared by copies of the object. */
typedef struct kept_surface {
    bat_users users;
    bat_surface *surface;
} kept_surface;

typedef struct own_part {
    kept_surface *kept;
} own_part;

static kept_surface *kept_of(const void *own) { return ((const own_part *)own)->kept; }

static void release(kept_surface *kept) {
    if (!kept || !bat_users_drop(&kept->users)) return;
    bat_surface_free(kept->surface);
    free(kept);
}

static void share(const void *own) { bat_users_add(&kept_of(own)->users); }
static void end(void *own) { release(kept_of(own)); }

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

/* Makes a new object, or a copy of `object` with another surface, which is taken over on success. */
static bat_status make(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                       bat_surface *surface, bat_object **out) {
    bat_curve *curves[2 * LINES];
    int count;
    bat_status status = lines_of(surface, curves, &count);
    if (status != BAT_OK) return status;
    own_part own = {malloc(sizeof *own.kept)};
    if (own.kept) *own.kept = (kept_surface){BAT_USERS_ONE, surface};
    status = !own.kept ? BAT_MEMORY
             : object  ? bat_object_remake(object, &bat_kind_of_surface, &own, count, curves, out)
                       : bat_object_make(&bat_kind_of_surface, id, name, style, &own, count, curves, out);
    if (status == BAT_OK) return BAT_OK;
    for (int i = 0; i < count; i++) bat_curve_free(curves[i]);
    free(own.kept);
    return status;
}

static bat_status make_of_copy(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                               const bat_surface *surface, bat_object **out) {
    bat_surface *copy = NULL;
    bat_status status = surface && out ? bat_surface_copy(surface, &copy) : BAT_ARGUMENT;
    if (status == BAT_OK) status = make(object, id, name, style, copy, out);
    if (status != BAT_OK) bat_surface_free(copy);
    return status;
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

/* ---- what the document asks ---- */

static uint64_t digest_surface(uint64_t digest, const void *own) {
    const bat_surface *surface = kept_of(own)->surface;
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

static bat_status transform(const bat_object *object, const double m[6], bat_object **out) {
    double rows[12];
    bat_surface *image = NULL;
    bat_matrix_rows(m, 3, rows);
    bat_status status = bat_surface_transform(bat_object_surface(object), rows, &image);
    if (status == BAT_OK) status = make(object, 0, NULL, NULL, image, out);
    if (status != BAT_OK) bat_surface_free(image);
    return status;
}

/* ---- files: the lines are not written, as they are computed from the surface ---- */

static bat_status read(const bat_fields *f, uint32_t node, bat_id id, const char *name, bat_object **out) {
    bat_style style = bat_style_defaults();
    bat_surface *surface = NULL;
    const uint32_t member = bat_json_member(f->json, node, "surface");
    bat_status status = bat_style_from_json(f, node, &style);
    if (status == BAT_OK && !member) return bat_fields_complain(f, node, "surface", "an object");
    if (status == BAT_OK) status = bat_surface_from_json(f->json, member, &surface, f->problem);
    if (status != BAT_OK) return status;
    status = make(NULL, id, name, &style, surface, out);
    if (status == BAT_OK) return BAT_OK;
    bat_surface_free(surface);
    return bat_fields_say(f, node, status);
}

static void write(const bat_object *object, bat_text *text) {
    bat_text_string(text, ",\n  \"style\":");
    bat_style_to_json(bat_object_style(object), text);
    bat_text_string(text, ",\n  \"surface\":");
    bat_surface_to_json(bat_object_surface(object), text);
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
                                           .write = write,
                                           .read = read};
