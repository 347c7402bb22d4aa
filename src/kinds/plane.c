/* A plane in space to draw on: it passes through its origin and is spanned by two axes at right angles. */
#include "base/pose.h"
#include "base/vec.h"
#include "curve/curve.h"
#include "document/digest.h"
#include "format/json/fields.h"
#include "kinds/kinds.h"
#include "text/text.h"

#include <math.h>
#include <string.h>

enum { NUMBERS = 9 };
static const double RIGHT = 1e-12; /* axes this close to unit length and a right angle are left unchanged */

typedef struct plane {
    double frame[NUMBERS]; /* origin, x axis, y axis */
} plane;

/* Orthonormalises the axes: the x axis keeps its direction, the y axis its side. -0 becomes 0, so that equal
 * planes have equal bits. */
static bat_status set(const double *origin, const double *axes, plane *out) {
    double *x = out->frame + 3, *y = out->frame + 6;
    for (int i = 0; i < 3; i++) out->frame[i] = origin[i] + 0.0;
    for (int i = 0; i < 6; i++) x[i] = axes[i] + 0.0;
    if (!bat_are_coordinates(out->frame, NUMBERS)) return BAT_NUMBER;
    if (fabs(vec_dot3(x, x) - 1) <= RIGHT && fabs(vec_dot3(y, y) - 1) <= RIGHT &&
        fabs(vec_dot3(x, y)) <= RIGHT)
        return BAT_OK;
    for (int pass = 0; pass < 3; pass++) { /* Gram-Schmidt; the first pass only scales, two are enough */
        double *axis = pass == 0 ? x : y, most = fmax(fmax(fabs(axis[0]), fabs(axis[1])), fabs(axis[2]));
        double along = pass ? vec_dot3(x, axis) : 0, before, length;
        if (!(most > 0)) return BAT_SINGULAR;
        for (int i = 0; i < 3; i++) axis[i] /= most;
        along /= most;
        before = sqrt(vec_dot3(axis, axis));
        for (int i = 0; i < 3 && pass; i++) axis[i] -= along * x[i];
        length = sqrt(vec_dot3(axis, axis));
        if (!(length > 1e-9 * before)) return BAT_SINGULAR;
        for (int i = 0; i < 3; i++) axis[i] = axis[i] / length + 0.0;
    }
    return BAT_OK;
}

bat_status bat_object_create_plane(bat_id id, const char *name, const double origin[3], const double axes[6],
                                   bat_object **out) {
    plane own;
    if (!origin || !axes) return BAT_ARGUMENT;
    bat_status status = set(origin, axes, &own);
    return status == BAT_OK ? bat_object_make(&bat_kind_of_plane, id, name, NULL, &own, 0, NULL, out)
                            : status;
}

const double *bat_object_plane(const bat_object *object) {
    const plane *own = bat_object_own(object, &bat_kind_of_plane);
    return own ? own->frame : NULL;
}

static uint64_t digest_plane(uint64_t digest, const void *own) {
    for (int i = 0; i < NUMBERS; i++) digest = bat_digest_double(digest, ((const plane *)own)->frame[i]);
    return digest;
}

static const char *check(const bat_object *object) {
    const double *x = bat_object_plane(object) + 3, *y = x + 3;
    bool right = fabs(vec_dot3(x, x) - 1) <= 1e-9 && fabs(vec_dot3(y, y) - 1) <= 1e-9 &&
                 fabs(vec_dot3(x, y)) <= 1e-9;
    return right ? NULL : "the axes of a plane are not at right angles";
}

static bat_status transform(const bat_object *object, const double rows[12], bat_object **out) {
    double moved[NUMBERS];
    plane own;
    bat_pose_apply(rows, 1, bat_object_plane(object), moved);
    bat_pose_turn(rows, 2, bat_object_plane(object) + 3, moved + 3);
    bat_status status = set(moved, moved + 3, &own);
    return status == BAT_OK ? bat_object_remake(object, &bat_kind_of_plane, &own, 0, NULL, out) : status;
}

static void write(const bat_object *object, bat_text *text) {
    const double *frame = bat_object_plane(object);
    for (int i = 0; i < NUMBERS; i++) {
        bat_text_string(text, i == 0 ? ",\"origin\":[" : i == 3 ? "],\"axes\":[" : ",");
        bat_text_number(text, frame[i]);
    }
    bat_text_string(text, "]");
}

static bat_status read(const bat_fields *f, uint32_t node, bat_id id, const char *name, bat_object **out) {
    double origin[3], axes[6];
    bat_status status = bat_fields_numbers(f, node, "origin", 3, "three numbers", origin);
    if (status == BAT_OK) status = bat_fields_numbers(f, node, "axes", 6, "six numbers", axes);
    if (status != BAT_OK) return status;
    status = bat_object_create_plane(id, name, origin, axes, out);
    if (status != BAT_SINGULAR) return bat_fields_say(f, node, status);
    return bat_json_complain(f->json, bat_json_member(f->json, node, "axes"), status, "axes",
                             "two directions that span a plane", f->problem);
}

static const double *ground(const bat_object *object, int *count) {
    *count = NUMBERS;
    return bat_object_plane(object);
}

const bat_kind_type bat_kind_of_plane = {.number = BAT_KIND_PLANE,
                                         .name = "plane",
                                         .traits = BAT_SPACE,
                                         .size = sizeof(plane),
                                         .check = check,
                                         .digest = digest_plane,
                                         .transform = transform,
                                         .ground = ground,
                                         .write = write,
                                         .read = read};
