#include "paint_foreign.h"
#include "paint_kept.h"

#include <math.h>

bool paint_is_known(cairo_t *cairo, const bat_picture *picture) {
    paint_kept *kept = paint_kept_of(cairo);
    return kept && paint_is_whole(kept, picture);
}

void paint_placed(cairo_t *cairo, const bat_object *object) {
    const double *m = bat_object_matrix(object), opacity = bat_object_style(object)->opacity;
    const cairo_matrix_t place = {m[0], m[1], m[2], m[3], m[4], m[5]};
    cairo_save(cairo);
    cairo_transform(cairo, &place);
    if (opacity < 1) cairo_push_group(cairo);
    (void)paint_once(cairo, bat_object_picture(object));
    if (opacity < 1) {
        cairo_pop_group_to_source(cairo);
        cairo_paint_with_alpha(cairo, opacity);
    }
    cairo_restore(cairo);
}

bool paint_once(cairo_t *cairo, const bat_picture *picture) {
    paint_kept *kept = paint_kept_of(cairo);
    return kept && paint_picture(kept, cairo, picture);
}

cairo_pattern_t *paint_tile(cairo_t *cairo, const bat_picture *picture, double opacity, double scale) {
    enum { SIDE = 4096 };
    paint_kept *kept = paint_kept_of(cairo);
    double sides[2];
    int pixels[2] = {0, 0};
    bat_picture_sides(picture, sides);
    for (int k = 0; k < 2 && scale > 0; k++) pixels[k] = (int)fmin(fmax(ceil(sides[k] * scale), 1), SIDE);
    cairo_surface_t *surface = kept ? paint_tile_surface(kept, picture, opacity, pixels) : NULL;
    if (!surface) return NULL;
    cairo_pattern_t *pattern = cairo_pattern_create_for_surface(surface);
    cairo_pattern_set_extend(pattern, CAIRO_EXTEND_REPEAT);
    if (scale > 0) {
        cairo_matrix_t matrix;
        cairo_matrix_init_scale(&matrix, pixels[0] / sides[0], pixels[1] / sides[1]);
        cairo_pattern_set_matrix(pattern, &matrix);
    }
    return pattern;
}
