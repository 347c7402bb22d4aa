/* Which line of a surface a marking means (docs/math/surfaces.md): the places of its samples are averaged as one at
 * constant u and as one at constant v; the average from which they deviate less is meant. */
#include "base/vec.h"
#include "form/view/view.h"

#include <stdlib.h>

static const double border = 0.02; /* of a domain's width: this near to an edge, the edge is meant */

typedef struct marks {
    double *places; /* u and v of each sample that is seen on the surface */
    size_t count;
    double speed[2]; /* sums of |S_u| and |S_v| there */
} marks;

/* The nearest hit of each sample's ray. */
static bat_status collect(const bat_gaze *gaze, const bat_stroke *marking, const bat_surface *surface,
                          marks *out) {
    bat_surface_finder *finder = NULL;
    bat_status status = bat_surface_finder_create(surface, &finder);
    for (size_t i = 0; i < marking->count && status == BAT_OK; i++) {
        const bat_sight ray = bat_gaze_ray(gaze, marking->points + 2 * i);
        double from[3], along[3], jet[9];
        bat_surface_point hit;
        size_t found = 0;
        vec_store(ray.from, from), vec_store(ray.along, along);
        status = bat_surface_finder_hits(finder, from, along, 1, &hit, &found);
        if (status != BAT_OK || found == 0) continue;
        out->places[2 * out->count] = hit.u, out->places[2 * out->count + 1] = hit.v;
        out->count++;
        bat_surface_eval(surface, hit.u, hit.v, 1, jet);
        for (int d = 0; d < 2; d++) out->speed[d] += vec_norm(vec_load(jet + 3 + 3 * d, 3));
    }
    bat_surface_finder_free(finder);
    return status;
}

/* The mean of a direction's parameters; in a closed direction that of the angles on a circle. */
static double mean_of(const marks *m, int direction, bool closed, const double domain[2]) {
    const double width = domain[1] - domain[0], turn = 2 * BAT_PI / width;
    double sum = 0, x = 0, y = 0;
    for (size_t i = 0; i < m->count; i++) {
        const double at = m->places[2 * i + (size_t)direction] - domain[0];
        sum += at;
        if (closed) x += bat_cos(turn * at), y += bat_sin(turn * at);
    }
    if (!closed) return fmin(fmax(domain[0] + sum / (double)m->count, domain[0]), domain[1]);
    const double angle = bat_atan2(y, x) / turn, at = domain[0] + (angle < 0 ? angle + width : angle);
    return at < domain[1] ? at : domain[0];
}

/* The root of the mean squared deviation, as a length on the surface. */
static double deviation(const marks *m, int direction, double period, double mean) {
    double sum = 0;
    for (size_t i = 0; i < m->count; i++) {
        double d = m->places[2 * i + (size_t)direction] - mean;
        if (period > 0) d = remainder(d, period);
        sum += d * d;
    }
    return sqrt(sum / (double)m->count) * (m->speed[direction] / (double)m->count);
}

static void choose(const marks *m, const bat_surface *surface, bat_surface_pick *out) {
    static const bat_direction directions[2] = {BAT_U, BAT_V};
    double mean[2], domain[2][2];
    for (int d = 0; d < 2; d++) {
        const bool closed = bat_surface_is_closed(surface, directions[d]);
        bat_surface_domain(surface, directions[d], domain[d]);
        mean[d] = mean_of(m, d, closed, domain[d]);
        out->residual[d] = deviation(m, d, closed ? domain[d][1] - domain[d][0] : 0, mean[d]);
    }
    const int d = out->residual[1] < out->residual[0];
    const double width = domain[d][1] - domain[d][0];
    out->direction = directions[d];
    out->value = mean[d];
    for (int end = 0; end < 2 && !bat_surface_is_closed(surface, directions[d]); end++)
        if (fabs(mean[d] - domain[d][end]) <= border * width)
            out->value = domain[d][end], out->boundary = true;
}

bat_status bat_surface_pick_line(const bat_viewpoint *view, const bat_stroke *marking,
                                 const bat_surface *surface, bat_surface_pick *out) {
    bat_gaze gaze;
    if (!surface || !out) return BAT_ARGUMENT;
    bat_status status = bat_gaze_through(view, marking, &gaze);
    if (status != BAT_OK) return status;
    marks m = {.places = malloc((2 * marking->count + 1) * sizeof *m.places)};
    status = m.places ? collect(&gaze, marking, surface, &m) : BAT_MEMORY;
    if (status == BAT_OK && m.count == 0) status = BAT_FAR;
    if (status == BAT_OK) {
        *out = (bat_surface_pick){.used = m.count, .dropped = marking->count - m.count};
        choose(&m, surface, out);
    }
    free(m.places);
    return status;
}
