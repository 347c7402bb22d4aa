#include "editor/edit/affine.h"

#include "base/matrix.h"
#include "base/pose.h"
#include "document/clip.h"
#include "document/kind.h"
#include "document/paint.h"

#include <math.h>

bool bat_affine_moves(const bat_object *object) {
    return !bat_object_is_group(object) || bat_object_clip(object);
}

static bat_status image_of(const bat_object *object, const double rows[12], bat_object **out) {
    const bat_kind_type *type = bat_object_type(object);
    bat_object *path = NULL;
    if (!type->transform) return BAT_ARGUMENT;
    bat_status status = type->transform(object, rows, out);
    if (status != BAT_OK || *out) return status;
    status = bat_object_to_path(object, &path);
    if (status == BAT_OK) status = bat_object_type(path)->transform(path, rows, out);
    bat_object_release(path);
    return status;
}

/* Takes `made` over. */
static bat_status map_paint(bat_object *made, const double matrix[6], double longer, bat_object **out) {
    double dashes[BAT_DASHES_MAX];
    *out = made;
    if (!bat_object_paint(made)) return BAT_OK;
    const bat_paint paint = bat_paint_mapped(bat_object_paint(made), matrix, longer, dashes);
    const bat_status status = bat_object_with_paint(made, &paint, out);
    bat_object_release(made);
    return status;
}

/* The same for what of it is seen. */
static bat_status map_clip(bat_object *made, const double matrix[6], bat_object **out) {
    bat_clip *clip = NULL;
    *out = made;
    if (!bat_object_clip(made)) return BAT_OK;
    bat_status status = bat_clip_mapped(bat_object_clip(made), matrix, &clip);
    if (status == BAT_OK) status = bat_object_with_clip(made, clip, out);
    bat_clip_release(clip);
    bat_object_release(made);
    return status;
}

bat_status bat_affine_object(const bat_object *object, const double matrix[6], bool strokes,
                             bat_object **out) {
    double rows[12];
    bat_matrix_rows(matrix, 3, rows);
    return bat_affine_pose(object, rows, strokes, out);
}

bat_status bat_affine_pose(const bat_object *object, const double rows[12], bool strokes, bat_object **out) {
    bat_object *made = NULL, *thicker = NULL;
    double matrix[6];
    if (!bat_pose_in_plane(rows, matrix)) {
        if (bat_object_clip(object)) return BAT_UNSUPPORTED;
        strokes = false;
        bat_matrix_translation(rows[3], rows[7], matrix); /* paint goes along */
    }
    if (bat_object_is_group(object)) return map_clip(bat_object_retain(object), matrix, out);
    bat_status status = image_of(object, rows, &made);
    const double area = bat_matrix_area(matrix);
    strokes = strokes && area > 0 && fabs(area - 1) > 1e-12;
    if (status == BAT_OK) status = map_paint(made, matrix, strokes ? sqrt(area) : 1, &made);
    if (status == BAT_OK) status = map_clip(made, matrix, &made);
    if (status != BAT_OK) return status;
    *out = made;
    if (!strokes || !bat_object_is(made, BAT_CURVES)) return BAT_OK;
    bat_style style = *bat_object_style(made);
    style.width = fmin(style.width * sqrt(area), BAT_COORDINATE_MAX);
    status = bat_object_with_style(made, &style, &thicker);
    bat_object_release(made);
    *out = thicker;
    return status;
}
