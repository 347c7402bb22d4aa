/* A spline of the tangents hand: its points and directions stay editable and define its one curve. */
#include "base/pose.h"
#include "hands/tangents/spline.h"
#include "curve/curve.h"
#include "base/users.h"
#include "document/digest.h"
#include "format/json/spline.h"
#include "format/json/style.h"
#include "kinds/kinds.h"
#include "kinds/spline.h"
#include <batten/bezier.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The object's own part: a reference-counted value with its own arrays, shared by copies of the object. */
typedef struct kept_spline {
    bat_users users;
    bat_spline spline; /* its arrays follow it in the same block; none of them is NULL */
    bat_tangents_options options;
} kept_spline;

typedef struct own_part {
    kept_spline *kept;
} own_part;

static kept_spline *kept_of(const void *own) { return ((const own_part *)own)->kept; }

static bool zero(const double *v, int size) {
    for (int d = 0; d < size; d++)
        if (v[d] != 0) return false;
    return true;
}

static kept_spline *copy(const bat_spline *spline, const bat_tangents_options *options) {
    size_t count = spline->count, size = count * (size_t)spline->dimension;
    kept_spline *kept = malloc(sizeof *kept + (2 * size + 2 * count) * sizeof(double));
    if (!kept) return NULL;
    double *points = (double *)(void *)(kept + 1), *tangents = points + size, *tension = tangents + size;
    memcpy(points, spline->points, size * sizeof(double));
    for (int i = 0; i < bat_spline_count(spline); i++) {
        int at = i * spline->dimension;
        bool given = spline->tangents && !zero(spline->tangents + at, spline->dimension);
        for (int d = 0; d < spline->dimension; d++) tangents[at + d] = given ? spline->tangents[at + d] : 0;
    }
    for (size_t i = 0; i < 2 * count; i++) tension[i] = spline->tension ? spline->tension[i] : 1;
    *kept = (kept_spline){BAT_USERS_ONE, *spline, *options};
    kept->spline.points = points;
    kept->spline.tangents = tangents;
    kept->spline.tension = tension;
    return kept;
}

/* Copies the spline and makes its curve. Directions of zero length become +0, so that equal splines have equal
 * bits. */
static bat_status keep(const bat_spline *spline, const bat_tangents_options *options, kept_spline **out,
                       bat_curve **curve) {
    /* Checks everything first, so that counts and pointers can be trusted when copying. */
    bat_tangents_options own;
    bat_status status = bat_tangents_options_read(options, &own);
    if (status == BAT_OK) status = bat_tangents(spline, &own, NULL, NULL, NULL, NULL);
    if (status != BAT_OK) return status;
    kept_spline *kept = copy(spline, &own);
    if (!kept) return BAT_MEMORY;
    status = bat_tangents(&kept->spline, &kept->options, NULL, NULL, NULL, curve);
    if (status == BAT_OK)
        *out = kept;
    else
        free(kept);
    return status;
}

static void release(kept_spline *kept) {
    if (kept && bat_users_drop(&kept->users)) free(kept);
}

static void share(const void *own) { bat_users_add(&kept_of(own)->users); }
static void end(void *own) { release(kept_of(own)); }

/* Makes a new object, or a copy of `object` with another spline. */
static bat_status make(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                       const bat_spline *spline, const bat_tangents_options *options, bat_object **out) {
    own_part own = {NULL};
    bat_curve *curve = NULL;
    bat_status status = keep(spline, options, &own.kept, &curve);
    if (status != BAT_OK) return status;
    status = object ? bat_object_remake(object, &bat_kind_of_spline, &own, 1, &curve, out)
                    : bat_object_make(&bat_kind_of_spline, id, name, style, &own, 1, &curve, out);
    if (status == BAT_OK) return status;
    bat_curve_free(curve);
    release(own.kept);
    return status;
}

bat_status bat_object_create_spline(bat_id id, const char *name, const bat_style *style,
                                    const bat_spline *spline, const bat_tangents_options *options,
                                    bat_object **out) {
    return style ? make(NULL, id, name, style, spline, options, out) : BAT_ARGUMENT;
}

bat_status bat_object_with_spline(const bat_object *object, const bat_spline *spline, bat_object **out) {
    const void *own = object ? bat_object_own(object, &bat_kind_of_spline) : NULL;
    return own ? make(object, 0, NULL, NULL, spline, &kept_of(own)->options, out) : BAT_ARGUMENT;
}

bat_status bat_object_with_spline_mode(const bat_object *object, bat_tangents_mode mode, bat_object **out) {
    const void *own = object ? bat_object_own(object, &bat_kind_of_spline) : NULL;
    if (!own) return BAT_ARGUMENT;
    bat_tangents_options options = kept_of(own)->options;
    options.mode = mode;
    return make(object, 0, NULL, NULL, &kept_of(own)->spline, &options, out);
}

const bat_spline *bat_object_spline(const bat_object *object) {
    const void *own = bat_object_own(object, &bat_kind_of_spline);
    return own ? &kept_of(own)->spline : NULL;
}

const bat_tangents_options *bat_object_spline_options(const bat_object *object) {
    const void *own = bat_object_own(object, &bat_kind_of_spline);
    return own ? &kept_of(own)->options : NULL;
}

static uint64_t digest_spline(uint64_t digest, const void *own) {
    const kept_spline *kept = kept_of(own);
    const bat_spline *s = &kept->spline;
    size_t count = s->count, size = count * (size_t)s->dimension;
    digest = bat_digest_number(digest, (uint64_t)kept->options.mode);
    digest = bat_digest_number(digest, (uint64_t)kept->options.missing);
    digest = bat_digest_number(digest, s->closed);
    digest = bat_digest_number(digest, (uint64_t)s->dimension);
    digest = bat_digest_number(digest, count);
    for (size_t i = 0; i < size; i++) digest = bat_digest_double(digest, s->points[i]);
    for (size_t i = 0; i < size; i++) digest = bat_digest_double(digest, s->tangents[i]);
    for (size_t i = 0; i < 2 * count; i++) digest = bat_digest_double(digest, s->tension[i]);
    return digest;
}

static const char *check(const bat_object *object) {
    const kept_spline *kept = kept_of(bat_object_own(object, &bat_kind_of_spline));
    bat_curve *again = NULL;
    bat_status status = bat_tangents(&kept->spline, &kept->options, NULL, NULL, NULL, &again);
    if (status == BAT_MEMORY) return NULL;
    if (status != BAT_OK) return "a spline is not valid";
    bool same = bat_object_curve_count(object) == 1 && bat_curve_is_equal(bat_object_curve(object, 0), again);
    bat_curve_free(again);
    return same ? NULL : "the curve of a spline is not the one its points give";
}

/* ---- affine images ---- */

/* Same knots and points, up to rounding. */
static bool alike(const bat_curve *a, const bat_curve *b) {
    if (bat_point_count(a) != bat_point_count(b) || bat_curve_knot_count(a) != bat_curve_knot_count(b) ||
        bat_curve_is_closed(a) != bat_curve_is_closed(b))
        return false;
    double near = 1e-9 * bat_curve_size(b);
    for (int i = 0; i < bat_curve_dimension(a) * bat_point_count(a); i++)
        if (!(fabs(bat_curve_points(a)[i] - bat_curve_points(b)[i]) <= near)) return false;
    return true;
}

/* Whether the object's curve is the image of the other's. */
static bat_status gives_image(const bat_object *object, const bat_object *of, const double *rows,
                              bool *gives) {
    bat_curve *image = NULL;
    bat_status status = bat_curve_posed(bat_object_curve(of, 0), rows, &image);
    *gives = status == BAT_OK && alike(bat_object_curve(object, 0), image);
    bat_curve_free(image);
    return status;
}

static bat_status transform(const bat_object *object, const double rows[12], bat_object **out) {
    bat_spline spline = *bat_object_spline(object);
    bool gives = false;
    double m[6];
    *out = NULL;
    const size_t n = spline.count, was = (size_t)spline.dimension;
    const size_t size = bat_pose_in_plane(rows, m) ? was : 3;
    double *numbers = malloc(2 * size * n * sizeof *numbers);
    if (!numbers) return BAT_MEMORY;
    for (size_t i = 0; i < 2 * n; i++) {
        const double *from = i < n ? spline.points : spline.tangents;
        double place[3] = {0, 0, 0};
        if (from) memcpy(place, from + was * (i % n), was * sizeof *place);
        (i < n ? bat_pose_apply : bat_pose_turn)(rows, 1, place, place);
        memcpy(numbers + size * i, place, size * sizeof *place);
    }
    spline.dimension = (int)size;
    spline.points = numbers;
    if (spline.tangents) spline.tangents = numbers + size * n;
    bat_status status = bat_object_with_spline(object, &spline, out);
    free(numbers);
    if (status != BAT_OK) { /* flattened to fewer than two points */
        *out = NULL;
        return status == BAT_MEMORY ? status : BAT_OK;
    }
    status = gives_image(*out, object, rows, &gives);
    if (status == BAT_OK && gives) return BAT_OK;
    bat_object_release(*out);
    *out = NULL;
    return status;
}

/* ---- files ---- */

static bat_status read(const bat_fields *f, uint32_t node, bat_id id, const char *name, bat_object **out) {
    bat_style style = bat_style_defaults();
    bat_status status = bat_style_from_json(f, node, &style);
    if (status != BAT_OK) return status;
    uint32_t member = bat_json_member(f->json, node, "spline");
    if (!member) return bat_fields_complain(f, node, "spline", "an object");
    bat_tangents_options options = bat_tangents_defaults();
    options.mode = BAT_TANGENTS_FAITHFUL; /* what a file means that says none */
    bat_spline spline;
    void *block = NULL;
    status = bat_spline_from_json(f->json, member, &spline, &block, &options, f->problem);
    if (status != BAT_OK) return status;
    status = bat_object_create_spline(id, name, &style, &spline, &options, out);
    bat_free(block);
    if (status == BAT_OK) return BAT_OK;
    return bat_json_say(f->json, member, status,
                        status == BAT_COUNT ? "spline: expected two different points at least, found fewer"
                                            : bat_status_message(status),
                        f->problem);
}

/* The curve is not written, as it is computed from the spline. */
static void write(const bat_object *object, bat_text *text) {
    bat_text_string(text, ",\n  \"style\":");
    bat_style_to_json(bat_object_style(object), text);
    bat_text_string(text, ",\n  \"spline\":");
    bat_spline_to_json(bat_object_spline(object), bat_object_spline_options(object), text);
}

const bat_kind_type bat_kind_of_spline = {.number = BAT_KIND_SPLINE,
                                          .name = "spline",
                                          .traits = BAT_DRAWN | BAT_CURVES | BAT_MADE,
                                          .size = sizeof(own_part),
                                          .share = share,
                                          .end = end,
                                          .check = check,
                                          .digest = digest_spline,
                                          .transform = transform,
                                          .write = write,
                                          .read = read};
