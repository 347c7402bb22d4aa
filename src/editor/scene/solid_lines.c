/* Lines of an object as buffers: its curves; of a surface that is shaded, its edges. A point is x, y, z and the length of
 * the line up to there; 0 begins another line. */
#include "editor/scene/solid.h"
#include <batten/bezier.h>
#include <batten/curve.h>
#include <batten/trace.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS_MAX = 512, PATCHES_MAX = 4096 /* of a surface whose outline is drawn */ };

static const double chord = 0.1; /* view pixels */

typedef struct pencil {
    float *points;
    size_t count, room;
    const double *origin;
    double tolerance, length, last[3];
    bool on;
} pencil;

static bat_status add_point(pencil *p, const double at[3]) {
    const double x = at[0] - p->last[0], y = at[1] - p->last[1], z = at[2] - p->last[2];
    const double step = sqrt(x * x + y * y + z * z);
    if (p->on && !(step > 0)) return BAT_OK;
    p->length = p->on ? p->length + step : 0;
    if (p->count + 2 > p->room) { /* room for the last one twice */
        const size_t room = p->room ? 2 * p->room : 256;
        float *more = realloc(p->points, BAT_SOLID_POINT * room * sizeof *more);
        if (!more) return BAT_MEMORY;
        p->points = more, p->room = room;
    }
    for (int twice = p->count == 0; twice >= 0; twice--) {
        float *to = p->points + BAT_SOLID_POINT * p->count++;
        for (int d = 0; d < 3; d++) to[d] = (float)(at[d] - p->origin[d]);
        to[3] = (float)p->length;
    }
    memcpy(p->last, at, sizeof p->last);
    p->on = true;
    return BAT_OK;
}

/* So many steps that chords are within the tolerance. */
static int steps_of(const double *cubic, int size, double tolerance) {
    double most = 0;
    for (int k = 0; k < 2; k++) {
        double square = 0;
        for (int d = 0; d < size; d++) {
            const double *q = cubic + k * size + d, bend = q[0] - 2 * q[size] + q[2 * size];
            square += bend * bend;
        }
        most = fmax(most, sqrt(square));
    }
    const double steps = ceil(sqrt(0.75 * most / tolerance));
    return steps > 1 ? (int)fmin(steps, STEPS_MAX) : 1;
}

static bat_status add_cubic(pencil *p, const double *cubic, int size) {
    const int steps = steps_of(cubic, size, p->tolerance);
    bat_status status = BAT_OK;
    for (int i = p->on ? 1 : 0; i <= steps && status == BAT_OK; i++) {
        const double t = (double)i / steps, s = 1 - t;
        const double b[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
        double at[3] = {0};
        for (int k = 0; k < 4; k++)
            for (int d = 0; d < size; d++) at[d] += b[k] * cubic[k * size + d];
        status = add_point(p, at);
    }
    return status;
}

static bat_status add_curve(pencil *p, const bat_curve *curve) {
    const int size = bat_curve_dimension(curve);
    double *cubics = NULL;
    int count = 0;
    bat_status status = bat_curve_to_cubics(curve, p->tolerance, &count, &cubics);
    if (status == BAT_TOLERANCE) status = BAT_OK;
    p->on = false;
    for (int i = 0; i < count && status == BAT_OK; i++) status = add_cubic(p, cubics + 4 * size * i, size);
    bat_free(cubics);
    return status;
}

static bat_status add_edges(pencil *p, const bat_surface *surface) {
    bat_status status = BAT_OK;
    for (bat_direction d = BAT_U; d <= BAT_V; d++) {
        double domain[2];
        bat_surface_domain(surface, d, domain);
        for (int k = 0; k < 2 && status == BAT_OK && !bat_surface_is_closed(surface, d); k++) {
            bat_curve *line = NULL;
            status = bat_surface_isocurve(surface, d, domain[k], &line);
            if (status == BAT_OK) status = add_curve(p, line);
            bat_curve_free(line);
        }
    }
    return status;
}

/* The last point twice; how many points there are. */
static uint32_t finish(pencil *p) {
    if (!p->count) return 0;
    memcpy(p->points + BAT_SOLID_POINT * p->count, p->points + BAT_SOLID_POINT * (p->count - 1),
           BAT_SOLID_POINT * sizeof *p->points);
    return (uint32_t)(p->count + 1);
}

bat_status bat_solid_lines(bat_solid *solid, const bat_object *object, const bat_surface *surface) {
    pencil p = {.origin = solid->grain.origin, .tolerance = ldexp(chord, -solid->grain.scale)};
    const bat_surface *own = bat_object_surface(object);
    bat_status status = BAT_OK;
    if (own && solid->grain.look != BAT_LOOK_LINES)
        status = add_edges(&p, surface ? surface : own);
    else if (!bat_object_mesh(object) || solid->grain.look == BAT_LOOK_LINES ||
             bat_polymesh_face_count(bat_object_mesh(object)) == 0)
        for (int i = 0; i < bat_object_curve_count(object) && status == BAT_OK; i++)
            status = add_curve(&p, bat_object_curve(object, i));
    if (status != BAT_OK) {
        free(p.points);
        return status;
    }
    free(solid->points);
    solid->points = p.points;
    solid->point_count = finish(&p);
    return BAT_OK;
}

static bat_status add_tracks(pencil *p, const bat_tracks *tracks) {
    bat_status status = BAT_OK;
    for (size_t i = 0; i < bat_tracks_count(tracks); i++) {
        const bat_track_point *track;
        const size_t count = bat_tracks_points(tracks, i, &track);
        p->on = false;
        for (size_t k = 0; k < count && status == BAT_OK; k++) status = add_point(p, track[k].point);
    }
    return status;
}

bat_status bat_solid_outline(bat_solid *solid, const bat_object *object, const bat_viewpoint *view) {
    pencil p = {.origin = solid->grain.origin};
    const bat_surface *surface = bat_object_surface(object);
    bat_tracks *tracks = NULL;
    bat_status status = BAT_OK;
    free(solid->rim);
    solid->rim = NULL;
    solid->rim_count = 0;
    if (!surface || bat_surface_count(surface, BAT_U) * bat_surface_count(surface, BAT_V) > PATCHES_MAX)
        return BAT_OK;
    status = bat_surface_silhouettes(surface, view, &tracks);
    if (status == BAT_OK) status = add_tracks(&p, tracks);
    bat_tracks_free(tracks);
    if (status != BAT_OK) {
        free(p.points);
        return status == BAT_MEMORY ? status : BAT_OK;
    }
    solid->rim = p.points;
    solid->rim_count = finish(&p);
    return BAT_OK;
}
