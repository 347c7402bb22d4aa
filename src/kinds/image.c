/* Images, and foreign content: pictures placed by a matrix that maps their pixels to the document. Foreign content is what the
 * program does not edit, kept as a small SVG file of its own. */
#include "base/pose.h"
#include "base/matrix.h"
#include "document/clip.h"
#include "document/digest.h"
#include "document/picture.h"
#include "document/placed.h"
#include "format/json/fields.h"
#include "kinds/kinds.h"
#include "text/text.h"

#include <batten/paint.h>

static const char expected_matrix[] = "six numbers that do not flatten";

static void share(const void *own) { (void)bat_picture_retain(((const bat_placed *)own)->picture); }
static void end(void *own) { bat_picture_release(((bat_placed *)own)->picture); }

static const bat_placed *own_of(const bat_object *object) {
    const bat_kind_type *type = object ? bat_object_type(object) : NULL;
    return type && type->traits & BAT_PICTURED ? bat_object_own(object, type) : NULL;
}

/* Else it makes its picture itself. */
static bool is_kept(const bat_object *object) {
    const bat_kind_type *type = bat_object_type(object);
    return type == &bat_kind_of_image || type == &bat_kind_of_foreign;
}

static bat_status create(const bat_kind_type *type, bat_id id, const char *name, const bat_picture *picture,
                         const double matrix[6], double opacity, bat_object **out) {
    bat_placed own;
    if (!picture || !matrix || !(opacity >= 0 && opacity <= 1)) return BAT_ARGUMENT;
    if (bat_picture_is_drawing(picture) != (type == &bat_kind_of_foreign)) return BAT_UNSUPPORTED;
    bat_style style = bat_style_defaults();
    style.stroked = false;
    style.filled = true; /* it covers what lies behind it */
    style.opacity = opacity;
    bat_status status = bat_placed_set(picture, matrix, &own);
    if (status == BAT_OK) status = bat_object_make(type, id, name, &style, &own, 0, NULL, out);
    if (status == BAT_OK) share(&own);
    return status;
}

bat_status bat_object_with_matrix(const bat_object *object, const double matrix[6], bat_object **out) {
    const bat_placed *old = object && is_kept(object) ? own_of(object) : NULL;
    bat_placed own;
    if (!old || !matrix || !out) return BAT_ARGUMENT;
    bat_status status = bat_placed_set(old->picture, matrix, &own);
    if (status == BAT_OK) status = bat_object_remake(object, bat_object_type(object), &own, 0, NULL, out);
    if (status == BAT_OK) share(&own);
    return status;
}

const bat_picture *bat_object_picture(const bat_object *object) {
    const bat_placed *g = own_of(object);
    return g ? g->picture : NULL;
}

const bat_picture *bat_object_picture_at(const bat_object *object, int index) {
    const bat_paint *paint = index > 0 ? bat_object_paint(object) : NULL;
    if (index == 0) return is_kept(object) ? bat_object_picture(object) : NULL;
    if (index > 2) {
        const bat_clip *clip = bat_object_clip(object);
        while (clip && index-- > 3) clip = bat_clip_within(clip);
        return bat_clip_picture(clip);
    }
    return !paint ? NULL : index == 1 ? paint->fill.tile : paint->stroke.tile;
}

bool bat_object_is_foreign(const bat_object *object) {
    return bat_object_own(object, &bat_kind_of_foreign) != NULL;
}

const double *bat_object_matrix(const bat_object *object) {
    const bat_placed *g = own_of(object);
    return g ? g->matrix : NULL;
}

void bat_object_corners(const bat_object *object, double corners[8]) {
    const bat_placed *g = own_of(object);
    if (g)
        bat_placed_corners(g, corners);
    else
        for (int i = 0; i < 8; i++) corners[i] = 0;
}

static uint64_t digest_placed(uint64_t before, const void *own) {
    const bat_placed *g = own;
    uint64_t made = bat_digest_number(before, bat_picture_digest(g->picture));
    for (int i = 0; i < 6; i++) made = bat_digest_double(made, g->matrix[i]);
    return made;
}

static bat_status transform(const bat_object *object, const double rows[12], bat_object **out) {
    double m[6], now[6];
    if (!bat_pose_in_plane(rows, m)) return BAT_UNSUPPORTED;
    bat_matrix_compose(m, bat_object_matrix(object), now);
    return bat_object_with_matrix(object, now, out);
}

static void write(const bat_object *object, bat_text *text) {
    char digest[17];
    bat_digest_print(bat_picture_digest(bat_object_picture(object)), digest);
    bat_text_string(text, ",\"picture\":");
    bat_text_json_string(text, digest);
    bat_text_string(text, ",\"matrix\":[");
    for (int i = 0; i < 6; i++) {
        if (i > 0) bat_text_string(text, ",");
        bat_text_number(text, bat_object_matrix(object)[i]);
    }
    bat_text_string(text, "],\"opacity\":");
    bat_text_number(text, bat_object_style(object)->opacity);
}

static bat_status read_as(const bat_kind_type *type, const bat_fields *f, uint32_t node, bat_id id,
                          const char *name, bat_object **out) {
    uint32_t named = bat_json_member(f->json, node, "picture");
    const char *word = bat_json_text(f->json, named);
    uint64_t digest;
    const bat_picture *picture = word && bat_digest_scan(word, &digest)
                                     ? bat_pictures_find(f->pictures, digest)
                                     : NULL;
    if (!picture)
        return bat_fields_complain(f, named ? named : node, "picture", "the digest of one of the pictures");
    double opacity = 1, matrix[6];
    bat_status status = bat_fields_number(f, node, "opacity", 0, 1, "a number from 0 to 1", &opacity);
    if (status == BAT_OK) status = bat_fields_numbers(f, node, "matrix", 6, expected_matrix, matrix);
    if (status != BAT_OK) return status;
    uint32_t list = bat_json_member(f->json, node, "matrix");
    status = create(type, id, name, picture, matrix, opacity, out);
    if (status == BAT_UNSUPPORTED)
        return bat_fields_complain(f, named, "picture", "a picture of the other sort");
    return status == BAT_NUMBER
               ? bat_json_complain(f->json, list, status, "matrix", expected_matrix, f->problem)
               : bat_fields_say(f, list, status);
}

bat_status bat_object_create_image(bat_id id, const char *name, const bat_picture *picture,
                                   const double matrix[6], double opacity, bat_object **out) {
    return create(&bat_kind_of_image, id, name, picture, matrix, opacity, out);
}

bat_status bat_object_create_foreign(bat_id id, const char *name, const bat_picture *picture,
                                     const double matrix[6], double opacity, bat_object **out) {
    return create(&bat_kind_of_foreign, id, name, picture, matrix, opacity, out);
}

static bat_status read_image(const bat_fields *f, uint32_t node, bat_id id, const char *name,
                             bat_object **out) {
    return read_as(&bat_kind_of_image, f, node, id, name, out);
}

static bat_status read_foreign(const bat_fields *f, uint32_t node, bat_id id, const char *name,
                               bat_object **out) {
    return read_as(&bat_kind_of_foreign, f, node, id, name, out);
}

const bat_kind_type bat_kind_of_image = {.number = BAT_KIND_IMAGE,
                                         .name = "image",
                                         .traits = BAT_DRAWN | BAT_PICTURED,
                                         .size = sizeof(bat_placed),
                                         .share = share,
                                         .end = end,
                                         .digest = digest_placed,
                                         .bounds = bat_placed_bounds,
                                         .transform = transform,
                                         .write = write,
                                         .read = read_image};
const bat_kind_type bat_kind_of_foreign = {.number = BAT_KIND_FOREIGN,
                                           .name = "foreign",
                                           .traits = BAT_DRAWN | BAT_NEW | BAT_PICTURED,
                                           .size = sizeof(bat_placed),
                                           .share = share,
                                           .end = end,
                                           .digest = digest_placed,
                                           .bounds = bat_placed_bounds,
                                           .transform = transform,
                                           .write = write,
                                           .read = read_foreign};
