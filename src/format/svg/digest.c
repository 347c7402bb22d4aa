#include "format/svg/digest.h"

#include "document/digest.h"

#include <math.h>

uint64_t bat_svg_digest(uint64_t digest, const bat_outline *outline, const bat_style *style,
                        const bat_paint *paint) {
    digest = bat_digest_number(digest, style->stroked);
    if (style->stroked) {
        const uint64_t gradient = bat_paint_digest(paint, BAT_PAINT_STROKE),
                       line = bat_paint_digest(paint, BAT_PAINT_LINE);
        digest = bat_digest_number(digest, gradient ? gradient : style->stroke);
        if (line) digest = bat_digest_number(digest, line);
        digest = bat_digest_double(digest, style->width);
        digest = bat_digest_number(digest, (uint64_t)style->cap);
        digest = bat_digest_number(digest, (uint64_t)style->join);
        digest = bat_digest_double(digest, style->miter_limit);
    }
    digest = bat_digest_number(digest, style->filled);
    if (style->filled) {
        const uint64_t gradient = bat_paint_digest(paint, BAT_PAINT_FILL);
        digest = bat_digest_number(digest, gradient ? gradient : style->fill);
        digest = bat_digest_number(digest, style->even_odd);
    }
    digest = bat_digest_double(digest, style->opacity);
    digest = bat_digest_number(digest, (uint64_t)outline->subpath_count);
    for (int i = 0; i < outline->subpath_count; i++) {
        const bat_subpath *path = &outline->subpaths[i];
        digest = bat_digest_number(digest, (uint64_t)path->segments);
        digest = bat_digest_number(digest, path->closed);
    }
    for (size_t i = 0; i < 2 * outline->count; i++) digest = bat_digest_double(digest, outline->points[i]);
    return digest;
}

uint64_t bat_svg_digest_group(uint64_t digest, double opacity) {
    return bat_digest_double(bat_digest_number(digest, 2), opacity);
}

uint64_t bat_svg_digest_region(uint64_t digest, const bat_outline *outline, bool even_odd) {
    digest = bat_digest_number(bat_digest_number(digest, 3), even_odd);
    digest = bat_digest_number(digest, (uint64_t)outline->subpath_count);
    for (size_t i = 0; i < 2 * outline->count; i++) digest = bat_digest_double(digest, outline->points[i]);
    return digest;
}

uint64_t bat_svg_digest_image(uint64_t digest, const bat_picture *picture, const double matrix[6],
                              double opacity) {
    digest = bat_digest_number(digest, bat_picture_digest(picture));
    for (int i = 0; i < 6; i++) digest = bat_digest_double(digest, matrix[i]);
    return bat_digest_double(digest, opacity);
}

uint64_t bat_svg_digest_marking(uint64_t digest, const bat_marking *m) {
    digest = bat_digest_number(digest, (uint64_t)m->turn << 2 | (uint64_t)m->by_width << 1 | m->clipped);
    digest = bat_digest_double(digest, m->angle + 0.0);
    for (int i = 0; i < 6; i++) digest = bat_digest_double(digest, m->matrix[i] + 0.0);
    for (int i = 0; i < 4 && m->clipped; i++) digest = bat_digest_double(digest, m->clip[i] + 0.0);
    return digest;
}

uint64_t bat_svg_digest_inks(uint64_t digest, bat_marker_ink fill, bat_marker_ink stroke) {
    return bat_digest_number(digest, (uint64_t)fill << 2 | (uint64_t)stroke);
}

void bat_svg_page(const bat_document *document, double page[4]) {
    bat_document_page(document, page);
    if (page[2] > 0 && page[3] > 0) return;
    double box[4], widest = 0;
    bat_document_bounds(document, box);
    for (int i = 0; i < bat_document_count(document); i++) {
        if (!bat_object_is_drawn(bat_document_at(document, i))) continue;
        const bat_style *style = bat_object_style(bat_document_at(document, i));
        if (style->stroked) widest = fmax(widest, style->width);
    }
    if (!(box[0] <= box[2])) box[0] = box[1] = 0, box[2] = box[3] = 100;
    page[0] = box[0] - widest, page[1] = box[1] - widest;
    page[2] = box[2] - box[0] + 2 * widest, page[3] = box[3] - box[1] + 2 * widest;
    for (int k = 2; k < 4; k++)
        if (!(page[k] > 0)) page[k] = 1;
}
