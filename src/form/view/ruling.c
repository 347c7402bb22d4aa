/* The direction in which the ruled surface of a line runs (docs/math/surfaces.md). */
#include "form/view/ruling.h"
#include "base/order.h"
#include "curve/curve.h"
#include "form/surface/surface.h"

#include <stdlib.h>

enum { SAMPLES = 65 };
static const double slanted = 0.25881904510252076; /* sine of 15 degrees */
static const double cancels = 0.1;                 /* mean of unit normals shorter than this: they cancel */

/* The line's best normal: that of its area, when it is a loop; else its chord's. */
static vec normal_of_loop(const bat_curve *line, const double domain[2]) {
    vec area = {0, 0, 0}, first = area, last = area;
    for (int i = 0; i <= SAMPLES; i++) {
        double at[3];
        bat_curve_eval(line, domain[0] + (domain[1] - domain[0]) * (i % SAMPLES) / SAMPLES, 0, at);
        const vec now = vec_load(at, 3);
        if (i == 0)
            first = now;
        else
            area = vec_add(area, vec_cross(vec_sub(last, first), vec_sub(now, first)));
        last = now;
    }
    return vec_unit(area);
}

static vec mean_normal(const bat_surface *surface, double u, const double domain[2]) {
    vec sum = {0, 0, 0};
    int count = 0;
    for (int i = 0; i < SAMPLES; i++) {
        double normal[3];
        const double v = domain[0] + (domain[1] - domain[0]) * (i + 0.5) / SAMPLES;
        if (bat_surface_normal(surface, u, v, normal) != BAT_OK) continue;
        sum = vec_add(sum, vec_load(normal, 3)), count++;
    }
    return count > 0 ? vec_scale(sum, 1.0 / count) : sum;
}

/* The median along the line of the sine of the angle between the gaze and the ruled surface. */
static double median_sine(const bat_curve *line, const bat_gaze *gaze, vec d, const double domain[2]) {
    double sines[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
        double jet[6];
        bat_curve_eval(line, domain[0] + (domain[1] - domain[0]) * (i + 0.5) / SAMPLES, 1, jet);
        const vec towards = bat_gaze_towards(gaze, vec_load(jet, 3));
        sines[i] = fabs(vec_dot(vec_unit(vec_load(jet + 3, 3)), vec_cross(d, towards)));
    }
    qsort(sines, SAMPLES, sizeof *sines, bat_ascending); /* no ties that can be told apart */
    return sines[SAMPLES / 2];
}

bat_status bat_ruling_choose(const bat_surface *upright, double u, const bat_curve *line,
                             const bat_gaze *gaze, const double along[3], double out[3], bool *turned) {
    double domain[2], ends[3][3];
    vec d = vec_load(along, 3);
    bat_curve_domain(line, domain);
    if (!bat_are_coordinates(along, 3)) return BAT_NUMBER;
    *turned = false;
    if (!(vec_norm(d) > 0)) {
        const vec loop = normal_of_loop(line, domain);
        d = mean_normal(upright, u, domain);
        if (!(vec_norm(d) >= cancels) && vec_norm(loop) > 0) d = loop;
        for (int i = 0; i < 3; i++)
            bat_curve_eval(line, domain[0] + (domain[1] - domain[0]) * 0.5 * i, 0, ends[i]);
        const vec towards = bat_gaze_towards(gaze, vec_load(ends[1], 3));
        if (!(median_sine(line, gaze, vec_unit(d), domain) >= slanted)) {
            const vec chord = line->closed ? loop : vec_sub(vec_load(ends[2], 3), vec_load(ends[0], 3));
            const vec across = vec_cross(towards, vec_unit(chord));
            d = vec_norm(across) > 0 ? across : vec_any_normal(towards);
            *turned = true;
        }
    }
    vec_store(vec_unit(d), out);
    return BAT_OK;
}

bat_status bat_surface_ruling(const bat_surface *surface, bat_direction direction, double at,
                              const bat_viewpoint *view, const double along[3], double out[3], bool *turned) {
    bat_gaze gaze;
    bat_surface *other = NULL;
    bat_curve *line = NULL;
    bat_status status = bat_gaze_of(view, &gaze);
    if (status == BAT_OK && direction == BAT_V) status = bat_surface_transpose(surface, &other);
    const bat_surface *upright = other ? other : surface;
    if (status == BAT_OK) status = bat_surface_isocurve(upright, BAT_U, at, &line);
    if (status == BAT_OK) status = bat_ruling_choose(upright, at, line, &gaze, along, out, turned);
    bat_curve_free(line);
    bat_surface_free(other);
    return status;
}
