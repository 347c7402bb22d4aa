/* A view that was saved: from where the drawing is looked at. It paints nothing; pictures can be made from it. */
#include "base/pose.h"
#include "base/matrix.h"
#include "curve/curve.h"
#include "document/digest.h"
#include "format/json/fields.h"
#include "format/json/view.h"
#include "kinds/kinds.h"
#include "text/text.h"

#include <math.h>
#include <string.h>

/* -0 becomes 0, so that equal views have equal bits. */
static void plain(double *numbers, int count) {
    for (int i = 0; i < count; i++) numbers[i] += 0.0;
}

static bat_status set(const bat_viewpoint *view, bat_viewpoint *out) {
    const bat_status status = bat_viewpoint_check(view, NULL);
    if (status != BAT_OK) return status;
    *out = *view;
    plain(out->eye, 3);
    plain(out->target, 3);
    plain(out->up, 3);
    plain(&out->fov, 1);
    plain(&out->height, 1);
    return BAT_OK;
}

bat_status bat_object_create_view(bat_id id, const char *name, const bat_viewpoint *view, bat_object **out) {
    bat_viewpoint own;
    if (!view || !out) return BAT_ARGUMENT;
    const bat_status status = set(view, &own);
    return status == BAT_OK ? bat_object_make(&bat_kind_of_view, id, name, NULL, &own, 0, NULL, out) : status;
}

const bat_viewpoint *bat_object_view(const bat_object *object) {
    return bat_object_own(object, &bat_kind_of_view);
}

static uint64_t digest_view(uint64_t digest, const void *own) {
    const bat_viewpoint *view = own;
    for (int i = 0; i < 3; i++) {
        digest = bat_digest_double(digest, view->eye[i]);
        digest = bat_digest_double(digest, view->target[i]);
        digest = bat_digest_double(digest, view->up[i]);
    }
    digest = bat_digest_double(bat_digest_double(digest, view->size[0]), view->size[1]);
    return bat_digest_double(bat_digest_double(digest, view->fov), view->height);
}

static const char *check(const bat_object *object) {
    return bat_viewpoint_check(bat_object_view(object), NULL) == BAT_OK ? NULL : "a view is not valid";
}

/* Eye and target go where the drawing goes; a parallel view shows as much of it as before. A view from straight above stays
 * one, with its upward direction carried along. */
static bat_status transform(const bat_object *object, const double rows[12], bat_object **out) {
    bat_viewpoint view = *bat_object_view(object), own;
    double m[6];
    bat_pose_apply(rows, 1, view.eye, view.eye);
    bat_pose_apply(rows, 1, view.target, view.target);
    bat_pose_turn(rows, 1, view.up, view.up);
    if (bat_pose_in_plane(rows, m)) view.height *= sqrt(bat_matrix_area(m));
    const bat_status status = set(&view, &own);
    return status == BAT_OK ? bat_object_remake(object, &bat_kind_of_view, &own, 0, NULL, out) : status;
}

static void write(const bat_object *object, bat_text *text) {
    bat_text_string(text, ",\"view\":");
    bat_viewpoint_to_json(bat_object_view(object), text);
}

static bat_status read(const bat_fields *f, uint32_t node, bat_id id, const char *name, bat_object **out) {
    bat_viewpoint view;
    const uint32_t member = bat_json_member(f->json, node, "view");
    if (!member) return bat_fields_complain(f, node, "view", "an object");
    const bat_status status = bat_viewpoint_from_json(f->json, member, &view, f->problem);
    return status == BAT_OK ? bat_fields_say(f, node, bat_object_create_view(id, name, &view, out)) : status;
}

const bat_kind_type bat_kind_of_view = {.number = BAT_KIND_VIEW,
                                        .name = "view",
                                        .traits = BAT_SPACE,
                                        .size = sizeof(bat_viewpoint),
                                        .check = check,
                                        .digest = digest_view,
                                        .transform = transform,
                                        .write = write,
                                        .read = read};
