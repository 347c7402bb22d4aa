/* The intersection of two surfaces: seeds, branches, contacts; and tracks as curves. */
#include "curve/fit.h"
#include "form/surface/surface.h"
#include "form/trace/meet.h"
#include "form/view/view.h"
#include <batten/fit.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double usual_gap = 1e-4, usual_chord = 1e-6, usual_leaf = 0.03; /* of the size */

/* Members from `leaf` on are kept when an older program does not know of them. */
void bat_intersect_options_init(bat_intersect_options *options, size_t size) {
    const bat_intersect_options usual = {.size = size};
    memcpy(options, &usual, size < sizeof usual ? size : sizeof usual);
}

static bat_status read_options(const bat_intersect_options *options, bat_meet *m) {
    const double *given[] = {&m->gap, &m->chord, &m->leaf};
    if (options) {
        if (options->size < sizeof *options) return BAT_ARGUMENT;
        m->gap = options->tolerance, m->chord = options->chord, m->leaf = options->leaf;
    }
    for (int i = 0; i < 3; i++) {
        if (!bat_are_coordinates(given[i], 1)) return BAT_NUMBER;
        if (*given[i] < 0) return BAT_ARGUMENT;
    }
    if (!(m->gap > 0)) m->gap = usual_gap * m->size;
    const double least = fmax(bat_surface_least_chord(m->side[0]), bat_surface_least_chord(m->side[1]));
    m->chord = bat_chord(m->chord, usual_chord * m->size, least);
    if (!(m->chord > 0)) return BAT_TOLERANCE;
    if (!(m->leaf > 0)) m->leaf = usual_leaf;
    m->leaf = fmin(fmax(m->leaf, 1e-3), 1);
    return BAT_OK;
}

static bat_status put_contacts(const bat_meet *m, bat_tracks *out) {
    bat_status status = BAT_OK;
    for (size_t i = 0; i < m->contact_count && status == BAT_OK; i++) {
        bat_track_point p;
        vec_store(m->contacts[i].at, p.point);
        for (int k = 0; k < 4; k++)
            (k < 2 ? p.uv : p.other_uv)[k % 2] = bat_curve_reduce(&m->side[k / 2]->axis[k % 2],
                                                                  m->contacts[i].x[k]);
        status = bat_tracks_cross(out, &p);
    }
    return status;
}

bat_status bat_surface_intersect(const bat_surface *a, const bat_surface *b,
                                 const bat_intersect_options *options, bat_tracks **out) {
    if (!a || !b || !out) return BAT_ARGUMENT;
    bat_meet m = {.side = {a, b}, .size = fmin(bat_surface_size(a), bat_surface_size(b))};
    bat_tracks made = {.list = NULL};
    bat_status status = read_options(options, &m);
    if (status != BAT_OK) return status;
    status = bat_meet_search(&m);
    made.given_up = m.given_up || bat_meet_touches_along(&m);
    if (status == BAT_OK && !m.given_up) status = bat_meet_march(&m, &made);
    if (status == BAT_OK) status = put_contacts(&m, &made);
    free(m.seeds);
    free(m.contacts);
    if (status != BAT_OK) {
        bat_tracks_clear(&made);
        return status;
    }
    return bat_tracks_finish(&made, out);
}

bat_status bat_tracks_curve(const bat_tracks *tracks, size_t i, double tolerance, bat_curve **out) {
    if (!tracks || !out || i >= tracks->count) return BAT_ARGUMENT;
    if (!bat_are_coordinates(&tolerance, 1)) return BAT_NUMBER;
    if (!(tolerance > 0)) return BAT_ARGUMENT;
    const bat_track *track = &tracks->list[i];
    const size_t count = track->closed ? track->count - 1 : track->count;
    double *points = malloc(count * 3 * sizeof *points);
    if (!points) return BAT_MEMORY;
    for (size_t k = 0; k < count; k++)
        memcpy(points + 3 * k, track->points[k].point, sizeof track->points[k].point);
    bat_fit_options options;
    bat_fit_options_init(&options, sizeof options);
    options.tolerance = tolerance, options.closed = track->closed, options.hold_ends = !track->closed;
    const bat_status status = bat_fit_plain(3, count, points, &options, out, NULL);
    free(points);
    return status;
}
