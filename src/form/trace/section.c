/* Sections by a plane: the zeros of n . S - d, a polynomial on each span. */
#include "base/vec.h"
#include "form/trace/contour.h"
#include "form/view/view.h"

#include <math.h>
#include <string.h>

static const double rounding = 1e-12, usual = 1e-6; /* of the surface's size */

typedef struct plane {
    const bat_surface *surface;
    vec origin, normal;
} plane;

static bool of_span(const void *user, const bat_cell *cell, bat_poly *out, double *tiny) {
    const plane *p = user;
    for (int d = 0; d < 2; d++) out->degree[d] = p->surface->axis[d].degree;
    double far = 0;
    for (int i = 0; i < (out->degree[0] + 1) * (out->degree[1] + 1); i++) {
        const vec way = vec_sub(vec_load(cell->net + 3 * i, 3), p->origin);
        out->c[i] = vec_dot(way, p->normal);
        far = fmax(far, vec_norm(way));
    }
    *tiny = fmax(rounding * p->surface->size, 4e-15 * far);
    return bat_poly_most(out) > *tiny;
}

static void place(const void *user, const double point[3], double out[3]) {
    (void)user;
    memcpy(out, point, 3 * sizeof(double));
}

bat_status bat_surface_section(const bat_surface *surface, const double origin[3], const double normal[3],
                               double tolerance, bat_tracks **out) {
    if (!surface || !origin || !normal || !out) return BAT_ARGUMENT;
    if (!bat_are_coordinates(origin, 3) || !bat_are_coordinates(normal, 3) ||
        !bat_are_coordinates(&tolerance, 1))
        return BAT_NUMBER;
    const plane p = {surface, vec_load(origin, 3), vec_unit(vec_load(normal, 3))};
    if (!(vec_norm(p.normal) > 0) || tolerance < 0) return BAT_ARGUMENT;
    const double chord = bat_chord(tolerance, usual * bat_surface_size(surface),
                                   bat_surface_least_chord(surface));
    if (!(chord > 0)) return BAT_TOLERANCE;
    const bat_contour contour = {surface, &p, of_span, place, chord};
    return bat_contour_trace(&contour, out);
}
