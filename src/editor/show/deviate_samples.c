#include "editor/show/deviate_samples.h"
#include "curve/curve.h"
#include <batten/bezier.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Samples of all things together, exact and during a drag; least of one curve, to a side of one surface. */
enum { EXACT = 6000, COARSE = 600, CURVE_LEAST = 16, CURVE_MOST = 600, SIDE_LEAST = 4, SIDE_MOST = 40 };

bool bat_deviating_takes(const bat_object *object) {
    return bat_object_surface(object) || bat_object_mesh(object) ||
           (bat_object_is_made_of_curves(object) && bat_object_curve_count(object) > 0);
}

/* ---- lists ---- */

static bool make_room(void **list, size_t *room, size_t wanted, size_t size) {
    if (wanted <= *room) return true;
    const size_t more = 2 * wanted + 64;
    void *at = realloc(*list, more * size);
    if (!at) return false;
    *list = at, *room = more;
    return true;
}

static bat_status add_sample(bat_deviating *d, const double *at) {
    if (!make_room((void **)&d->samples, &d->sample_room, d->sample_count + 1, sizeof *d->samples))
        return BAT_MEMORY;
    bat_deviation_sample *s = d->samples + d->sample_count;
    double closest[3];
    memcpy(s->at, at, sizeof s->at);
    const bat_status status = bat_reference_nearest(d->being, at, closest, &s->distance);
    if (status != BAT_OK) return status;
    if (!d->sample_count || s->distance > d->found.greatest) {
        d->found.greatest = s->distance;
        memcpy(d->found.at, at, sizeof s->at), memcpy(d->found.to, closest, sizeof closest);
    }
    d->sample_count++;
    return BAT_OK;
}

static bat_status add_patch(bat_deviating *d, int corners, size_t a, size_t b, size_t c, size_t e) {
    if (!make_room((void **)&d->patches, &d->patch_room, d->patch_count + 1, sizeof *d->patches))
        return BAT_MEMORY;
    d->patches[d->patch_count++] = (bat_deviation_patch){corners, {a, b, c, e}};
    return BAT_OK;
}

/* ---- things ---- */

static bat_status sample_curve(bat_deviating *d, const bat_curve *curve, size_t share) {
    const int segments = bat_curve_segment_count(curve);
    double *breaks = malloc(((size_t)segments + 1) * sizeof *breaks);
    bat_status status = breaks ? bat_curve_to_bezier(curve, NULL, breaks) : BAT_MEMORY;
    const double wanted = fmin(fmax((double)share, CURVE_LEAST), CURVE_MOST);
    const int steps = (int)fmax(ceil(wanted / segments), 2);
    for (int i = 0; i < segments && status == BAT_OK; i++)
        for (int k = 0; k <= steps && status == BAT_OK; k++) {
            if (k == 0 && i > 0) continue;
            const double u = breaks[i] + (breaks[i + 1] - breaks[i]) * k / steps;
            double at[3] = {0, 0, 0};
            (k == steps ? bat_curve_eval_left : bat_curve_eval)(curve, u, 0, at);
            status = add_sample(d, at);
            const size_t last = d->sample_count;
            if (status == BAT_OK && k > 0) status = add_patch(d, 2, last - 2, last - 1, 0, 0);
        }
    free(breaks);
    return status;
}

/* Between samples in rows, the last row and the first, too, where the surface is closed. */
static bat_status add_net(bat_deviating *d, const bat_surface *surface, size_t side, size_t first) {
    const size_t from[2] = {!bat_surface_is_closed(surface, BAT_U), !bat_surface_is_closed(surface, BAT_V)};
    bat_status status = BAT_OK;
    for (size_t i = from[0]; i < side; i++)
        for (size_t j = from[1]; j < side && status == BAT_OK; j++) {
            const size_t row = first + i * side, before = first + (i + side - 1) % side * side,
                         beside = (j + side - 1) % side;
            status = add_patch(d, 4, row + j, row + beside, before + beside, before + j);
        }
    return status;
}

/* *longest: of its lines of samples. */
static bat_status sample_surface(bat_deviating *d, const bat_surface *surface, size_t share,
                                 double *longest) {
    const size_t side = (size_t)fmin(fmax(sqrt((double)share), SIDE_LEAST), SIDE_MOST),
                 first = d->sample_count;
    double u[SIDE_MOST], v[SIDE_MOST], ways[2 * SIDE_MOST] = {0};
    bat_status status = BAT_OK;
    bat_surface_spread(surface, BAT_U, side, u), bat_surface_spread(surface, BAT_V, side, v);
    for (size_t i = 0; i < side; i++)
        for (size_t j = 0; j < side && status == BAT_OK; j++) {
            double at[3];
            bat_surface_eval(surface, u[i], v[j], 0, at);
            status = add_sample(d, at);
            if (status != BAT_OK) continue;
            const bat_deviation_sample *s = d->samples + d->sample_count - 1;
            if (i) ways[j] += bat_distance(at, (s - side)->at, 3);
            if (j) ways[SIDE_MOST + i] += bat_distance(at, (s - 1)->at, 3);
        }
    *longest = 0;
    for (size_t i = 0; i < 2 * SIDE_MOST; i++) *longest = fmax(*longest, ways[i]);
    return status == BAT_OK ? add_net(d, surface, side, first) : status;
}

/* All triangles if they are few enough, else some of the vertices as points. */
static bat_status sample_mesh(bat_deviating *d, const bat_polymesh *mesh, size_t share) {
    const size_t vertices = bat_polymesh_vertex_count(mesh), first = d->sample_count,
                 triangles = bat_polymesh_triangle_count(mesh);
    const bool faces = triangles > 0 && triangles <= share;
    const size_t step = faces || vertices <= share ? 1 : (vertices + share - 1) / share;
    int *corners = faces ? malloc(3 * triangles * sizeof *corners) : NULL;
    bat_status status = !faces ? BAT_OK : corners ? bat_polymesh_triangles(mesh, corners) : BAT_MEMORY;
    for (size_t i = 0; i < vertices && status == BAT_OK; i += step) {
        status = add_sample(d, bat_polymesh_vertices(mesh) + 3 * i);
        if (status == BAT_OK && !faces) status = add_patch(d, 1, d->sample_count - 1, 0, 0, 0);
    }
    for (size_t i = 0; faces && i < triangles && status == BAT_OK; i++) {
        const int *c = corners + 3 * i;
        status = add_patch(d, 3, first + (size_t)c[0], first + (size_t)c[1], first + (size_t)c[2], 0);
    }
    free(corners);
    return status;
}

/* ---- numbers ---- */

/* Over the area where there is one, else the length, else the points. */
typedef struct sums {
    int dimension;
    double extent, mean, square;
} sums;

static void add_numbers(bat_deviating *d, sums *all, const bat_deviation *one, int dimension) {
    if (one->greatest > d->found.greatest) {
        d->found.greatest = one->greatest;
        memcpy(d->found.at, one->at, sizeof one->at), memcpy(d->found.to, one->to, sizeof one->to);
    }
    if (dimension < all->dimension) return;
    if (dimension > all->dimension) *all = (sums){.dimension = dimension};
    all->extent += one->extent;
    all->mean += one->extent * one->mean, all->square += one->extent * one->rms * one->rms;
}

static bat_status measure_object(bat_deviating *d, const bat_object *object, size_t share, sums *all) {
    const bat_surface *surface = bat_object_surface(object);
    const bat_polymesh *mesh = bat_object_mesh(object);
    bat_deviation one;
    bat_status status = BAT_OK;
    double longest;
    if (surface) {
        status = sample_surface(d, surface, share, &longest);
        const double spacing = fmax(bat_surface_size(surface) / 32, longest / 64);
        if (status == BAT_OK && d->exact) status = bat_surface_deviation(surface, d->being, spacing, &one);
        if (status == BAT_OK && d->exact) add_numbers(d, all, &one, 2);
        return status;
    }
    if (mesh) {
        status = sample_mesh(d, mesh, share);
        if (status == BAT_OK && d->exact) status = bat_polymesh_deviation(mesh, d->being, 0, &one);
        if (status == BAT_OK && d->exact) add_numbers(d, all, &one, bat_polymesh_face_count(mesh) ? 2 : 0);
        return status;
    }
    const int count = bat_object_curve_count(object);
    for (int i = 0; i < count && status == BAT_OK; i++) {
        const bat_curve *curve = bat_object_curve(object, i);
        status = sample_curve(d, curve, share / (size_t)count);
        if (status == BAT_OK && d->exact) status = bat_curve_deviation(curve, d->being, 0, &one);
        if (status == BAT_OK && d->exact) add_numbers(d, all, &one, 1);
    }
    return status;
}

static bat_status make_reference(bat_deviating *d) {
    size_t most = 0, curves = 0, surfaces = 0, meshes = 0;
    for (int i = 0; i < d->seen_of_reference; i++) most += 1 + (size_t)bat_object_curve_count(d->seen[i]);
    const void **list = malloc(3 * most * sizeof *list);
    if (!list) return BAT_MEMORY;
    const bat_curve **curve = (const bat_curve **)list;
    const bat_surface **surface = (const bat_surface **)(list + most);
    const bat_polymesh **mesh = (const bat_polymesh **)(list + 2 * most);
    for (int i = 0; i < d->seen_of_reference; i++) {
        const bat_object *object = d->seen[i];
        if (bat_object_surface(object))
            surface[surfaces++] = bat_object_surface(object);
        else if (bat_object_mesh(object))
            mesh[meshes++] = bat_object_mesh(object);
        else
            for (int k = 0; k < bat_object_curve_count(object); k++)
                curve[curves++] = bat_object_curve(object, k);
    }
    bat_reference_free(d->being);
    d->being = NULL;
    const bat_status status = bat_reference_create(curves, curve, surfaces, surface, meshes, mesh, &d->being);
    free(list);
    return status;
}

bat_status bat_deviating_measure(bat_deviating *d) {
    const int first = d->seen_of_reference, count = d->seen_count - first;
    sums all = {.dimension = -1};
    d->sample_count = d->patch_count = 0;
    d->found = (bat_deviation){.greatest = 0};
    bat_status status = make_reference(d);
    const size_t share = (size_t)(d->exact ? EXACT : COARSE) / (size_t)(count > 0 ? count : 1);
    for (int i = first; i < d->seen_count && status == BAT_OK; i++)
        status = measure_object(d, d->seen[i], share, &all);
    if (all.extent > 0) {
        d->found.mean = all.mean / all.extent, d->found.rms = sqrt(all.square / all.extent);
    } else if (d->sample_count) {
        double sum = 0, square = 0;
        for (size_t i = 0; i < d->sample_count; i++)
            sum += d->samples[i].distance, square += d->samples[i].distance * d->samples[i].distance;
        d->found.mean = sum / (double)d->sample_count, d->found.rms = sqrt(square / (double)d->sample_count);
    }
    d->found.samples = status == BAT_OK ? d->sample_count : 0;
    return status;
}
