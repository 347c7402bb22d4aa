/* Strokes of objects whose width is a curve along them. */
#include <batten/paint.h>

#include <math.h>

static const double CORNER = 0.02; /* radians */
static const double FINE = 2e-4;   /* of the greatest width */

bat_width_profile bat_object_widths(const bat_object *object) {
    const bat_paint *paint = bat_object_paint(object);
    const bat_style *style = bat_object_style(object);
    if (!paint || !paint->width_count || paint->dash_count || !style->stroked || !(style->width > 0))
        return (bat_width_profile){0};
    if (paint->pen[0] != 0 || paint->pen[1] != 0 || bat_object_curve_count(object) == 0 ||
        bat_curve_dimension(bat_object_curve(object, 0)) != 2)
        return (bat_width_profile){0};
    return (bat_width_profile){paint->width_count, paint->widths};
}

bat_status bat_object_cover(const bat_object *object, int curve, size_t *cubics, double **points) {
    if (!object || !cubics || !points || !bat_object_curve(object, curve)) return BAT_ARGUMENT;
    const bat_width_profile profile = bat_object_widths(object);
    if (!profile.count) return BAT_ARGUMENT;
    const bat_style *style = bat_object_style(object);
    const bat_nib nib = {style->width, style->cap, style->join, fmax(style->miter_limit, 1)};
    double most = 0;
    for (size_t i = 0; i < profile.count; i++) most = fmax(most, profile.stops[i].share);
    if (!(most > 0)) {
        *cubics = 0, *points = NULL;
        return BAT_OK;
    }
    return bat_curve_cover_width(bat_object_curve(object, curve), &nib, &profile, FINE * most * style->width,
                                 CORNER, cubics, points);
}
