/*
 * What distances are measured to. Curves, surfaces and triangles are ordered along a curve that fills space (Morton's), so
 * that those which follow each other are near each other, and then stand in boxes within boxes.
 */
#include "form/compare/seek.h"
#include "form/compare/triangle.h"
#include "form/surface/finder.h"
#include "relate/hulls.h"

#include <batten/nearest.h>

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

enum { TOGETHER = 4 /* triangles in one box */, BITS = 21 /* of each coordinate of a place in the order */ };

typedef enum kind { ON_TRIANGLES, ON_CURVE, ON_SURFACE } kind;

typedef struct thing {
    double box[6]; /* low, high */
    kind kind;
    size_t first, count; /* triangles, or the number of the curve or surface */
} thing;

typedef struct triangle {
    const double *corner[3]; /* all the same: a point */
} triangle;

struct bat_reference {
    size_t curve_count, surface_count, triangle_count, thing_count;
    int *dimensions; /* of the curves */
    bat_finder **curves;
    bat_surface_finder **surfaces;
    triangle *triangles;
    thing *things;
    bat_hull *hulls; /* only their boxes along the coordinates hold all of the things */
};

/* ---- boxes ---- */

static void clear_box(double box[6]) {
    for (int c = 0; c < 3; c++) box[c] = INFINITY, box[3 + c] = -INFINITY;
}

static void hold_points(double box[6], const double *points, size_t count, int dimension) {
    for (size_t i = 0; i < count; i++)
        for (int c = 0; c < 3; c++) {
            const double x = c < dimension ? points[i * (size_t)dimension + (size_t)c] : 0;
            box[c] = fmin(box[c], x), box[3 + c] = fmax(box[3 + c], x);
        }
}

static void hold_triangle(double box[6], const triangle *t) {
    for (int k = 0; k < 3; k++) hold_points(box, t->corner[k], 1, 3);
}

static const double *corners_of(const void *things, size_t i, size_t *count) {
    *count = 2;
    return ((const thing *)things)[i].box;
}

/* ---- the order ---- */

typedef struct entry {
    uint64_t place; /* along Morton's curve */
    size_t number;  /* of the triangle, or after these of the curve, of the surface */
    double box[6];
} entry;

static int by_place(const void *a, const void *b) {
    const entry *x = a, *y = b;
    if (x->place != y->place) return x->place < y->place ? -1 : 1;
    return x->number < y->number ? -1 : x->number > y->number;
}

static uint64_t place_of(const double box[6], const double all[6]) {
    uint64_t place = 0, at[3];
    for (int c = 0; c < 3; c++) {
        const double wide = all[3 + c] - all[c], share = (0.5 * (box[c] + box[3 + c]) - all[c]) / wide;
        at[c] = wide > 0 ? (uint64_t)(fmin(fmax(share, 0), 1) * ((1 << BITS) - 1)) : 0;
    }
    for (int bit = BITS - 1; bit >= 0; bit--)
        for (int c = 0; c < 3; c++) place = place << 1 | (at[c] >> bit & 1);
    return place;
}

/* Entries in their order as things; triangles that follow each other share one. ordered: room for all triangles. */
static void put_together(bat_reference *r, const entry *entries, size_t count, triangle *ordered) {
    size_t put = 0;
    r->thing_count = 0;
    for (size_t i = 0; i < count; i++) {
        const entry *e = entries + i;
        const bool triangular = e->number < r->triangle_count;
        thing *last = r->thing_count ? r->things + r->thing_count - 1 : NULL;
        if (triangular) ordered[put++] = r->triangles[e->number];
        if (triangular && last && last->kind == ON_TRIANGLES && last->count < TOGETHER) {
            last->count++;
            hold_points(last->box, e->box, 2, 3);
            continue;
        }
        const size_t other = triangular ? 0 : e->number - r->triangle_count;
        thing *next = r->things + r->thing_count++;
        *next = (thing){.kind = triangular               ? ON_TRIANGLES
                                : other < r->curve_count ? ON_CURVE
                                                         : ON_SURFACE,
                        .first = triangular               ? put - 1
                                 : other < r->curve_count ? other
                                                          : other - r->curve_count,
                        .count = 1};
        clear_box(next->box), hold_points(next->box, e->box, 2, 3);
    }
}

static bat_status order(bat_reference *r, const bat_curve *const *curves,
                        const bat_surface *const *surfaces) {
    const size_t count = r->triangle_count + r->curve_count + r->surface_count;
    entry *entries = malloc(count * sizeof *entries);
    triangle *ordered = malloc((r->triangle_count + 1) * sizeof *ordered);
    r->things = malloc(count * sizeof *r->things);
    if (!entries || !ordered || !r->things) {
        free(entries), free(ordered);
        return BAT_MEMORY;
    }
    double all[6];
    clear_box(all);
    for (size_t i = 0; i < count; i++) {
        entry *e = entries + i;
        e->number = i;
        clear_box(e->box);
        if (i < r->triangle_count) {
            hold_triangle(e->box, r->triangles + i);
        } else if (i < r->triangle_count + r->curve_count) {
            const bat_curve *curve = curves[i - r->triangle_count];
            hold_points(e->box, bat_curve_points(curve), bat_curve_count(curve), bat_curve_dimension(curve));
        } else {
            bat_surface_box(surfaces[i - r->triangle_count - r->curve_count], e->box, e->box + 3);
        }
        hold_points(all, e->box, 2, 3);
    }
    for (size_t i = 0; i < count; i++) entries[i].place = place_of(entries[i].box, all);
    qsort(entries, count, sizeof *entries, by_place); /* no ties */
    put_together(r, entries, count, ordered);
    free(entries), free(r->triangles);
    r->triangles = ordered;
    return bat_hulls_create(3, r->thing_count, corners_of, r->things, &r->hulls);
}

/* ---- making ---- */

static bat_status make_finders(bat_reference *r, size_t curve_count, const bat_curve *const *curves,
                               size_t surface_count, const bat_surface *const *surfaces) {
    bat_status status = BAT_OK;
    r->dimensions = malloc((curve_count + 1) * sizeof *r->dimensions);
    r->curves = calloc(curve_count + 1, sizeof(bat_finder *));
    r->surfaces = calloc(surface_count + 1, sizeof(bat_surface_finder *));
    if (!r->dimensions || !r->curves || !r->surfaces) return BAT_MEMORY;
    for (size_t i = 0; i < curve_count && status == BAT_OK; i++) {
        r->dimensions[i] = bat_curve_dimension(curves[i]);
        status = bat_finder_create(curves[i], &r->curves[i]);
        r->curve_count += status == BAT_OK;
    }
    for (size_t i = 0; i < surface_count && status == BAT_OK; i++) {
        status = bat_surface_finder_create(surfaces[i], &r->surfaces[i]);
        r->surface_count += status == BAT_OK;
    }
    return status;
}

static bat_status add_triangles(bat_reference *r, const bat_polymesh *mesh) {
    const bool cloud = bat_polymesh_face_count(mesh) == 0;
    const size_t more = cloud ? bat_polymesh_vertex_count(mesh) : bat_polymesh_triangle_count(mesh);
    const double *vertices = bat_polymesh_vertices(mesh);
    int *corners = NULL;
    bat_status status = BAT_OK;
    triangle *list = realloc(r->triangles, (r->triangle_count + more + 1) * sizeof *list);
    if (!list) return BAT_MEMORY;
    r->triangles = list;
    if (!cloud) {
        corners = malloc(3 * more * sizeof *corners);
        status = corners ? bat_polymesh_triangles(mesh, corners) : BAT_MEMORY;
    }
    for (size_t i = 0; i < more && status == BAT_OK; i++)
        for (size_t k = 0; k < 3; k++)
            list[r->triangle_count + i].corner[k] = vertices + 3 * (cloud ? i : (size_t)corners[3 * i + k]);
    if (status == BAT_OK) r->triangle_count += more;
    free(corners);
    return status;
}

bat_status bat_reference_create(size_t curve_count, const bat_curve *const *curves, size_t surface_count,
                                const bat_surface *const *surfaces, size_t mesh_count,
                                const bat_polymesh *const *meshes, bat_reference **out) {
    if (!out || (curve_count && !curves) || (surface_count && !surfaces) || (mesh_count && !meshes))
        return BAT_ARGUMENT;
    for (size_t i = 0; i < curve_count; i++)
        if (!curves[i]) return BAT_ARGUMENT;
    for (size_t i = 0; i < surface_count; i++)
        if (!surfaces[i]) return BAT_ARGUMENT;
    for (size_t i = 0; i < mesh_count; i++)
        if (!meshes[i]) return BAT_ARGUMENT;
    if (curve_count + surface_count + mesh_count == 0) return BAT_COUNT;
    bat_reference *r = calloc(1, sizeof *r);
    if (!r) return BAT_MEMORY;
    bat_status status = make_finders(r, curve_count, curves, surface_count, surfaces);
    for (size_t i = 0; i < mesh_count && status == BAT_OK; i++) status = add_triangles(r, meshes[i]);
    if (status == BAT_OK) status = order(r, curves, surfaces);
    if (status != BAT_OK) {
        bat_reference_free(r);
        return status;
    }
    *out = r;
    return BAT_OK;
}

void bat_reference_free(bat_reference *r) {
    if (!r) return;
    for (size_t i = 0; i < r->curve_count; i++) bat_finder_free(r->curves[i]);
    for (size_t i = 0; i < r->surface_count; i++) bat_surface_finder_free(r->surfaces[i]);
    free(r->dimensions), free(r->curves), free(r->surfaces);
    free(r->triangles), free(r->things), free(r->hulls);
    free(r);
}

/* ---- the nearest point ---- */

typedef struct search {
    const bat_reference *reference;
    const double *point;
    double best[3], distance;
    bat_seek *seek; /* where the last one was; then where this one is */
    size_t tried;   /* the thing that was looked at first */
} search;

/* How far the point is from the box of a hull at least. */
static double gap_of(const search *s, size_t node) {
    const bat_hull *hull = s->reference->hulls + node;
    double d[3];
    for (int c = 0; c < 3; c++) d[c] = fmax(fmax(hull->low[c] - s->point[c], s->point[c] - hull->high[c]), 0);
    return vec_norm(vec_load(d, 3));
}

/* Whether the point of thing number i is the nearest so far. */
static bool offer(search *s, size_t i, const double *found) {
    const double distance = vec_norm(vec_sub(vec_load(found, 3), vec_load(s->point, 3)));
    if (!(distance < s->distance)) return false;
    s->distance = distance;
    s->seek->thing = i;
    for (int c = 0; c < 3; c++) s->best[c] = found[c];
    return true;
}

static bat_status look_at_surface(search *s, size_t number, const bat_surface_finder *finder) {
    const double at[2] = {s->seek->at[0], s->seek->at[1]};
    const bat_near_hints hints = {s->distance, s->tried == number ? at : NULL, NULL};
    bat_surface_point near;
    bool found;
    const bat_status status = bat_finder_near(finder, s->point, &hints, &near, &found);
    if (status == BAT_OK && found && offer(s, number, near.point))
        s->seek->at[0] = near.u, s->seek->at[1] = near.v;
    return status;
}

static bat_status look_at(search *s, size_t number) {
    const bat_reference *r = s->reference;
    const thing *t = r->things + number;
    double found[3] = {0, 0, 0};
    for (size_t i = t->first; t->kind == ON_TRIANGLES && i < t->first + t->count; i++) {
        const double *const *corner = r->triangles[i].corner;
        vec_store(bat_triangle_nearest(vec_load(corner[0], 3), vec_load(corner[1], 3), vec_load(corner[2], 3),
                                       vec_load(s->point, 3)),
                  found);
        offer(s, number, found);
    }
    if (t->kind == ON_CURVE) {
        bat_near near;
        bat_finder_nearest(r->curves[t->first], s->point, &near);
        for (int c = 0; c < r->dimensions[t->first]; c++) found[c] = near.point[c];
        offer(s, number, found);
    }
    return t->kind == ON_SURFACE ? look_at_surface(s, number, r->surfaces[t->first]) : BAT_OK;
}

static bat_status descend(search *s, bat_hull_part part) {
    if (part.count == 1) return part.first == s->tried ? BAT_OK : look_at(s, part.first);
    bat_hull_part half[2];
    bat_status status = BAT_OK;
    bat_hull_halve(part, half);
    const double gap[2] = {gap_of(s, half[0].node), gap_of(s, half[1].node)};
    for (int k = 0; k < 2 && status == BAT_OK; k++) {
        const int side = (gap[1] < gap[0]) != k; /* the nearer one first */
        if (gap[side] < s->distance) status = descend(s, half[side]);
    }
    return status;
}

bat_status bat_reference_seek(const bat_reference *reference, const double point[3], bat_seek *seek,
                              double closest[3], double *distance) {
    for (int c = 0; c < 3; c++)
        if (!(fabs(point[c]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    const size_t none = reference->thing_count;
    search s = {.reference = reference, .point = point, .distance = INFINITY, .seek = seek, .tried = none};
    bat_status status = BAT_OK;
    if (seek->is_known) s.tried = seek->thing, status = look_at(&s, s.tried);
    if (status == BAT_OK) status = descend(&s, (bat_hull_part){0, 0, reference->thing_count});
    if (status != BAT_OK) return status;
    seek->is_known = true;
    for (int c = 0; c < 3; c++) closest[c] = s.best[c];
    *distance = s.distance;
    return BAT_OK;
}

bat_status bat_reference_nearest(const bat_reference *reference, const double point[3], double closest[3],
                                 double *distance) {
    bat_seek seek = {.is_known = false};
    if (!reference || !point || !closest || !distance) return BAT_ARGUMENT;
    return bat_reference_seek(reference, point, &seek, closest, distance);
}
