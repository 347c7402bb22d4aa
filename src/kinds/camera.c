/* A camera move. Its curves show it: the camera at the start, as a pyramid with a tip that is up, and its path where that is
 * its own. A camera can follow a curve of the drawing instead: that is its path then, and where it goes the camera goes. */
#include "base/users.h"
#include "curve/curve.h"
#include "document/digest.h"
#include "document/digest_camera.h"
#include "form/camera/camera.h"
#include "form/camera/pyramid.h"
#include "format/json/camera.h"
#include "format/json/fields.h"
#include "format/json/style.h"
#include "kinds/kinds.h"
#include "text/text.h"

#include <math.h>
#include <stdlib.h>

enum { CURVES = 2 };

/* The object's own part: a reference-counted value, shared by copies of the object. */
typedef struct kept_camera {
    bat_users users;
    bat_camera *camera;
} kept_camera;

typedef struct own_part {
    kept_camera *kept;
    bat_id follows; /* 0: the path is its own */
} own_part;

static const own_part *part_of(const void *own) { return own; }

static void share(const void *own) { bat_users_add(&part_of(own)->kept->users); }
static void end(void *own) {
    kept_camera *kept = part_of(own)->kept;
    if (!kept || !bat_users_drop(&kept->users)) return;
    bat_camera_free(kept->camera);
    free(kept);
}

/* ---- what shows it ---- */

static bat_status pyramid_of(const bat_camera *camera, bat_curve **out) {
    double points[3 * BAT_PYRAMID_CORNERS], domain[2];
    bat_camera_pose pose;
    bat_camera_domain(camera, domain);
    bat_camera_at(camera, domain[0], &pose);
    bat_pyramid_of(&pose, bat_pyramid_depth(camera), points);
    return bat_curve_create_clamped(3, 1, BAT_PYRAMID_CORNERS, points, out);
}

/* CURVES at most, which the caller frees; on failure none are left. */
static bat_status curves_of(const bat_camera *camera, bool own_path, bat_curve *curves[CURVES], int *count) {
    *count = 0;
    bat_status status = own_path ? bat_curve_copy(camera->path, &curves[0]) : BAT_OK;
    *count = status == BAT_OK && own_path;
    if (status == BAT_OK) status = pyramid_of(camera, &curves[*count]);
    if (status == BAT_OK)
        ++*count;
    else
        while (*count > 0) bat_curve_free(curves[--*count]);
    return status;
}

/* ---- making ---- */

/* Makes a new object, or a copy of `object` with another move, which is taken over on success. */
static bat_status make(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                       bat_camera *camera, bat_id follows, bat_object **out) {
    bat_curve *curves[CURVES];
    int count;
    bat_status status = curves_of(camera, follows == 0, curves, &count);
    if (status != BAT_OK) return status;
    own_part own = {malloc(sizeof *own.kept), follows};
    if (own.kept) *own.kept = (kept_camera){BAT_USERS_ONE, camera};
    status = !own.kept ? BAT_MEMORY
             : object  ? bat_object_remake(object, &bat_kind_of_camera, &own, count, curves, out)
                       : bat_object_make(&bat_kind_of_camera, id, name, style, &own, count, curves, out);
    if (status == BAT_OK) return BAT_OK;
    for (int i = 0; i < count; i++) bat_curve_free(curves[i]);
    free(own.kept);
    return status;
}

static bat_status make_of_copy(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                               const bat_camera *camera, bat_id follows, bat_object **out) {
    bat_camera *copy = NULL;
    if (!camera || !out || follows > BAT_ID_MAX || (follows && follows == id)) return BAT_ARGUMENT;
    bat_status status = bat_camera_copy(camera, &copy);
    if (status == BAT_OK) status = make(object, id, name, style, copy, follows, out);
    if (status != BAT_OK) bat_camera_free(copy);
    return status;
}

bat_status bat_object_create_camera(bat_id id, const char *name, const bat_style *style,
                                    const bat_camera *camera, bat_id follows, bat_object **out) {
    return style ? make_of_copy(NULL, id, name, style, camera, follows, out) : BAT_ARGUMENT;
}

bat_status bat_object_with_camera(const bat_object *object, const bat_camera *camera, bat_id follows,
                                  bat_object **out) {
    return object && bat_object_camera(object)
               ? make_of_copy(object, bat_object_id(object), NULL, NULL, camera, follows, out)
               : BAT_ARGUMENT;
}

const bat_camera *bat_object_camera(const bat_object *object) {
    const void *own = bat_object_own(object, &bat_kind_of_camera);
    return own ? part_of(own)->kept->camera : NULL;
}

/* ---- what it follows ---- */

static bat_id followed(const bat_object *object) {
    return part_of(bat_object_own(object, &bat_kind_of_camera))->follows;
}

static bat_status follow(const bat_object *object, bat_id id, const bat_curve *path, bat_object **out) {
    const bat_camera *camera = bat_object_camera(object);
    if (id == followed(object) && (!path || bat_curve_is_equal(camera->given, path))) {
        *out = NULL;
        return BAT_OK;
    }
    bat_camera *made = NULL;
    bat_status status = path && id ? bat_camera_with_path(camera, path, &made)
                                   : bat_camera_copy(camera, &made);
    if (status != BAT_OK && status != BAT_MEMORY) { /* a path that it can't take: it lets go */
        id = 0;
        status = bat_camera_copy(camera, &made);
    }
    if (status == BAT_OK) status = make(object, 0, NULL, NULL, made, id, out);
    if (status != BAT_OK) bat_camera_free(made);
    return status;
}

/* ---- what the document asks ---- */

static uint64_t digest_camera(uint64_t digest, const void *own) {
    return bat_digest_camera(bat_digest_number(digest, part_of(own)->follows), part_of(own)->kept->camera);
}

static const char *check(const bat_object *object) {
    bat_curve *curves[CURVES];
    int count;
    if (curves_of(bat_object_camera(object), followed(object) == 0, curves, &count) != BAT_OK) return NULL;
    bool same = count == bat_object_curve_count(object);
    for (int i = 0; i < count; i++) {
        same = same && bat_curve_is_equal(curves[i], bat_object_curve(object, i));
        bat_curve_free(curves[i]);
    }
    return same ? NULL : "the curves of a camera do not show its move";
}

/* A path that is followed is moved on its own. */
static bat_status transform(const bat_object *object, const double rows[12], bat_object **out) {
    const bat_camera *camera = bat_object_camera(object);
    bat_camera *image = NULL;
    bat_status status = bat_camera_image(camera, rows, followed(object) ? camera->given : NULL, &image);
    if (status == BAT_OK) status = make(object, 0, NULL, NULL, image, followed(object), out);
    if (status != BAT_OK) bat_camera_free(image);
    return status;
}

/* ---- files ---- */

static bat_status read(const bat_fields *f, uint32_t node, bat_id id, const char *name, bat_object **out) {
    bat_style style = bat_style_defaults();
    bat_camera *camera = NULL;
    bat_id follows = 0;
    const uint32_t member = bat_json_member(f->json, node, "move");
    bat_status status = bat_style_from_json(f, node, &style);
    if (status == BAT_OK) status = bat_fields_id(f, node, "follows", BAT_ID_MAX, &follows);
    if (status == BAT_OK && follows == id)
        return bat_fields_complain(f, bat_json_member(f->json, node, "follows"), "follows", "another object");
    if (status == BAT_OK && !member) return bat_fields_complain(f, node, "move", "an object");
    if (status == BAT_OK) status = bat_camera_from_json(f->json, member, &camera, f->problem);
    if (status != BAT_OK) return status;
    status = make(NULL, id, name, &style, camera, follows, out);
    if (status == BAT_OK) return BAT_OK;
    bat_camera_free(camera);
    return bat_fields_say(f, node, status);
}

static void write(const bat_object *object, bat_text *text) {
    if (followed(object)) {
        bat_text_string(text, ",\"follows\":");
        bat_text_integer(text, followed(object));
    }
    bat_text_string(text, ",\n  \"style\":");
    bat_style_to_json(bat_object_style(object), text);
    bat_text_string(text, ",\n  \"move\":");
    bat_camera_to_json(bat_object_camera(object), text);
}

const bat_kind_type bat_kind_of_camera = {.number = BAT_KIND_CAMERA,
                                          .name = "camera",
                                          .traits = BAT_DRAWN | BAT_CURVES | BAT_MADE | BAT_FIXED |
                                                    BAT_SPACE | BAT_AID | BAT_MOVES,
                                          .size = sizeof(own_part),
                                          .share = share,
                                          .end = end,
                                          .check = check,
                                          .digest = digest_camera,
                                          .transform = transform,
                                          .followed = followed,
                                          .follow = follow,
                                          .write = write,
                                          .read = read};
