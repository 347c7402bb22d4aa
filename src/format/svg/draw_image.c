/* An image whose picture is embedded in the file becomes an image object. */
#include "base/matrix.h"
#include "document/clip.h"
#include "document/digest.h"
#include "document/document.h"
#include "format/svg/digest.h"
#include "format/svg/geometry.h"
#include "format/svg/walk.h"

#include <string.h>

void bat_svg_draw_image(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    bat_picture *picture = s->style.visible ? bat_svg_find_picture(w, element) : NULL;
    bat_object *object = NULL;
    if (!picture && s->style.visible && !w->copied && bat_svg_draw_other_image(w, element, s)) return;
    if (!picture) {
        const char *href = bat_svg_find_href(w, element);
        const bool nothing = !href || !*href ||
                             bat_svg_geometry_length(w, element, &s->style, "width", s->width, 1) == 0 ||
                             bat_svg_geometry_length(w, element, &s->style, "height", s->height, 1) == 0;
        bat_svg_note(&w->notes, element, s->style.visible && !nothing ? BAT_LOSS_IMAGE : BAT_LOSS_INVISIBLE);
        return;
    }
    bat_svg_note_odd(&w->notes, element, s->style.odd, BAT_SVG_BIT(BAT_SVG_IMAGE_HINT));
    double box[4] = {0}, m[6], matrix[6];
    bat_picture_sides(picture, box + 2);
    double width = bat_svg_geometry_length(w, element, &s->style, "width", s->width, -1);
    double height = bat_svg_geometry_length(w, element, &s->style, "height", s->height, -1);
    if (width < 0) width = height < 0 ? box[2] : height * box[2] / box[3];
    if (height < 0) height = width * box[3] / box[2];
    const char *ratio = bat_svg_attribute_of(w, element, "preserveAspectRatio");
    if (ratio && strstr(ratio, "slice")) bat_svg_note(&w->notes, element, BAT_LOSS_CLIP);
    const double at[2] = {bat_svg_geometry_length(w, element, &s->style, "x", s->width, 0),
                          bat_svg_geometry_length(w, element, &s->style, "y", s->height, 0)};
    bat_svg_fit(box, at[0], at[1], width, height, ratio, m);
    bat_matrix_compose(s->matrix, m, matrix);
    w->boxed = s->boxed != NULL;
    bat_svg_scope own = *s;
    own.clip = bat_clip_retain(s->clip);
    const double place[4] = {at[0], at[1], at[0] + width, at[1] + height};
    if (s->mask) bat_svg_mask_paint(w, element, place, &own);
    bat_status status = (bat_picture_is_drawing(picture) ? bat_object_create_foreign
                                                         : bat_object_create_image)(
        bat_document_new_id(w->document), bat_svg_find_name(w, element), picture, matrix, s->opacity,
        &object);
    if (status == BAT_OK) status = bat_svg_clip_object(&own, place, &object);
    if (status == BAT_OK) {
        if (own.clip_digest && !w->unseen) w->digest = bat_digest_number(w->digest, own.clip_digest);
        if (!w->unseen)
            w->digest = bat_svg_digest_image(w->digest, picture, bat_object_matrix(object), s->opacity);
        bat_svg_put_object(w, element, s->style.shown, object);
    } else {
        bat_object_release(object);
        bat_svg_note(&w->notes, element, BAT_LOSS_IMAGE);
    }
    if (status == BAT_MEMORY) w->status = status;
    bat_clip_release(own.clip);
    bat_picture_release(picture);
}
