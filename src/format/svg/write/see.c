#include "format/svg/write/see.h"

#include "base/matrix.h"
#include "document/digest.h"
#include "format/svg/digest.h"
#include "format/svg/markup.h"
#include "format/svg/svg.h"

#include <math.h>

bat_status bat_svg_see_clip(const bat_object *object, const double m[6], const double back[6],
                            bat_outline *outline, uint64_t *digest) {
    uint64_t own = 0;
    bat_status status = BAT_OK;
    if (!bat_object_clip(object)) return BAT_OK;
    for (const bat_clip *at = bat_object_clip(object); at && status == BAT_OK; at = bat_clip_within(at)) {
        bat_text data = {0};
        if (bat_clip_picture(at)) continue;
        status = bat_svg_write_region(&data, at, back);
        bat_outline_clear(outline);
        if (data.failed) status = BAT_MEMORY;
        if (status == BAT_OK && data.size) bat_svg_path(data.data, data.size, outline);
        if (outline->failed || outline->full) status = outline->failed ? BAT_MEMORY : BAT_COUNT;
        bat_outline_transform(outline, m);
        if (bat_clip_curve_count(at) > 0) own = bat_svg_digest_region(own, outline, bat_clip_is_even_odd(at));
        bat_text_free(&data);
    }
    for (const bat_clip *at = bat_object_clip(object); at; at = bat_clip_within(at)) {
        double written[6], seen[6];
        if (!bat_clip_picture(at)) continue;
        bat_matrix_compose(back, bat_clip_matrix(at), written);
        bat_matrix_compose(m, written, seen);
        own = bat_svg_digest_image(own, bat_clip_picture(at), seen, 1);
    }
    if (own) *digest = bat_digest_number(*digest, own);
    return status;
}

/* Style and paint as a reader will find them under the transform that makes the pen. */
static void see(bat_style *style, bat_paint *paint, const double pen[6], const double back[6],
                double dashes[BAT_DASHES_MAX]) {
    const double scale = sqrt(fabs(pen[0] * pen[3] - pen[1] * pen[2]));
    bat_gradient *const parts[2] = {&paint->fill, &paint->stroke};
    style->width *= scale;
    for (int k = 0; k < 2; k++) {
        double own[6];
        bat_matrix_compose(back, parts[k]->matrix, own);
        bat_matrix_compose(pen, own, parts[k]->matrix);
    }
    for (size_t i = 0; i < paint->dash_count; i++) dashes[i] = paint->dashes[i] * scale;
    paint->dashes = dashes;
    paint->dash_offset *= scale;
    for (int k = 0; k < 4; k++) paint->pen[k] = pen[k] / scale;
}

bat_status bat_svg_see_outline(const bat_object *object, const double pen[6], const double back[6],
                               bat_outline *outline, uint64_t *digest) {
    double dashes[BAT_DASHES_MAX];
    bat_style style = *bat_object_style(object);
    bat_paint paint = bat_object_paint(object) ? *bat_object_paint(object) : (bat_paint){0};
    if (outline->failed || outline->full) return outline->failed ? BAT_MEMORY : BAT_COUNT;
    if (!(pen[0] == 1 && pen[1] == 0 && pen[2] == 0 && pen[3] == 1)) {
        bat_outline_transform(outline, pen);
        see(&style, &paint, pen, back, dashes);
    }
    *digest = bat_svg_digest(*digest, outline, &style, &paint);
    return BAT_OK;
}

bat_status bat_svg_see_path(const bat_text *text, size_t start, const bat_object *object,
                            bat_outline *outline, uint64_t *digest) {
    double pen[6], back[6];
    bat_outline_clear(outline);
    bat_svg_path(text->data + start, text->size - start, outline);
    (void)bat_svg_pen(object, pen, back);
    return bat_svg_see_outline(object, pen, back, outline, digest);
}
