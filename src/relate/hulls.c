#include "relate/hulls.h"

#include "base/real.h"

#include <math.h>
#include <stdlib.h>

typedef struct building {
    int size;
    bat_hull_points points;
    const void *things;
    bat_hull *hulls;
} building;

/* From the first point to the one that is furthest from it; what the coordinates reach. */
static vec furthest(const building *b, bat_hull_part s, bat_hull *hull) {
    vec start = {0, 0, 0}, way = start;
    double most = -1;
    for (size_t i = s.first; i < s.first + s.count; i++) {
        size_t count;
        const double *x = b->points(b->things, i, &count);
        if (i == s.first) start = vec_load(x, b->size);
        for (size_t k = 0; k < count; k++, x += b->size) {
            const vec d = vec_sub(vec_load(x, b->size), start);
            const double square = vec_dot(d, d);
            if (square > most) most = square, way = d;
            for (int c = 0; c < b->size; c++)
                hull->low[c] = fmin(hull->low[c], x[c]), hull->high[c] = fmax(hull->high[c], x[c]);
        }
    }
    return way;
}

static void choose_axes(bat_hull *hull, vec way) {
    const vec unit = vec_unit(way), first = vec_dot(unit, unit) > 0.5 ? unit : (vec){1, 0, 0};
    hull->axis[0] = first;
    if (hull->size == 2) {
        hull->axis[1] = (vec){-first.y, first.x, 0};
        return;
    }
    hull->axis[1] = vec_any_normal(first);
    hull->axis[2] = vec_cross(first, hull->axis[1]);
}

static void reach_along(const building *b, bat_hull_part s, bat_hull *hull) {
    double square = 0;
    for (size_t i = s.first; i < s.first + s.count; i++) {
        size_t count;
        const double *x = b->points(b->things, i, &count);
        for (size_t k = 0; k < count; k++, x += b->size)
            for (int c = 0; c < b->size; c++) {
                const double at = vec_dot(vec_load(x, b->size), hull->axis[c]);
                hull->from[c] = fmin(hull->from[c], at), hull->to[c] = fmax(hull->to[c], at);
            }
    }
    for (int c = 0; c < b->size; c++) square += (hull->to[c] - hull->from[c]) * (hull->to[c] - hull->from[c]);
    hull->across = sqrt(square);
}

static void build(const building *b, bat_hull_part s) {
    bat_hull *hull = b->hulls + s.node;
    *hull = (bat_hull){.size = b->size};
    for (int c = 0; c < 3; c++)
        hull->low[c] = hull->from[c] = INFINITY, hull->high[c] = hull->to[c] = -INFINITY;
    choose_axes(hull, furthest(b, s, hull));
    reach_along(b, s, hull);
    if (s.count < 2) return;
    bat_hull_part half[2];
    bat_hull_halve(s, half);
    build(b, half[0]), build(b, half[1]);
}

bat_status bat_hulls_create(int size, size_t n, bat_hull_points points, const void *things, bat_hull **out) {
    bat_hull *hulls = malloc((2 * n - 1) * sizeof *hulls);
    if (!hulls) return BAT_MEMORY;
    const building b = {size, points, things, hulls};
    build(&b, (bat_hull_part){0, 0, n});
    *out = hulls;
    return BAT_OK;
}

void bat_hull_halve(bat_hull_part s, bat_hull_part half[2]) {
    const size_t left = s.count / 2; /* has 2 * left - 1 hulls, which are the next ones */
    half[0] = (bat_hull_part){s.node + 1, s.first, left};
    half[1] = (bat_hull_part){s.node + 2 * left, s.first + left, s.count - left};
}

/* What its second box reaches along an axis. */
static void shadow(const bat_hull *hull, vec axis, double out[2]) {
    out[0] = out[1] = 0;
    for (int c = 0; c < hull->size; c++) {
        const double share = vec_dot(hull->axis[c], axis), x = share * hull->from[c], y = share * hull->to[c];
        out[0] += fmin(x, y), out[1] += fmax(x, y);
    }
}

static bool apart_along(const bat_hull *a, const bat_hull *b, double gap) {
    for (int c = 0; c < a->size; c++) {
        double other[2];
        shadow(b, a->axis[c], other);
        if (a->from[c] - other[1] > gap || other[0] - a->to[c] > gap) return true;
    }
    return false;
}

bool bat_hulls_apart(const bat_hull *a, const bat_hull *b, double gap) {
    for (int c = 0; c < a->size; c++)
        if (a->low[c] - b->high[c] > gap || b->low[c] - a->high[c] > gap) return true;
    return apart_along(a, b, gap) || apart_along(b, a, gap);
}

bool bat_hull_beside(const bat_hull *hull, const double *point, double gap) {
    const vec x = vec_load(point, hull->size);
    for (int c = 0; c < hull->size; c++)
        if (point[c] < hull->low[c] - gap || point[c] > hull->high[c] + gap) return false;
    for (int c = 0; c < hull->size; c++) {
        const double at = vec_dot(x, hull->axis[c]);
        if (at < hull->from[c] - gap || at > hull->to[c] + gap) return false;
    }
    return true;
}
