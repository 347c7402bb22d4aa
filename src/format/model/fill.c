#include "format/model/fill.h"

static double cross(const double *a, const double *b, const double *c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* The middle of the area. */
static double find_middle(size_t count, const double *p, double middle[2]) {
    double area = 0, sum[2] = {0, 0};
    for (size_t i = 1; i + 1 < count; i++) {
        const double *a = p + 2 * i, *b = a + 2, part = cross(p, a, b);
        area += part;
        for (int k = 0; k < 2; k++) sum[k] += part * ((a[k] - p[k]) + (b[k] - p[k]));
    }
    for (int k = 0; k < 2; k++) middle[k] = p[k] + (area > 0 ? sum[k] / (3 * area) : 0);
    return area;
}

static bool is_inside(const double *a, const double *b, const double *c, const double *p) {
    return cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
}

/* Whether the corner behind `before` can be cut off: it has area, and nothing of the rest is in it, not even on its edge. */
static bool is_ear(const double *p, const int *next, int before, double least) {
    const int at = next[before], after = next[at];
    if (!(cross(p + 2 * before, p + 2 * at, p + 2 * after) > least)) return false;
    for (int i = next[after]; i != before; i = next[i])
        if (is_inside(p + 2 * before, p + 2 * at, p + 2 * after, p + 2 * i)) return false;
    return true;
}

static bool cut_ears(size_t count, const double *p, double least, int *next, int *triangles,
                     size_t *triangle_count) {
    size_t left = count, tried = 0;
    int before = 0;
    for (size_t i = 0; i < count; i++) next[i] = (int)((i + 1) % count);
    *triangle_count = 0;
    while (left >= 3 && tried <= left) {
        if (!is_ear(p, next, before, least)) {
            before = next[before];
            tried++;
            continue;
        }
        int *out = triangles + 3 * (*triangle_count)++;
        out[0] = before, out[1] = next[before], out[2] = next[out[1]];
        next[before] = out[2];
        left--;
        tried = 0;
        if (left == 2) return true;
    }
    return false;
}

/* Whether the middle sees every side from within, and the outline goes round it once. */
static bool is_star(size_t count, const double *p, const double middle[2], double least) {
    size_t rounds = 0;
    for (size_t i = 0; i < count; i++) {
        const double *a = p + 2 * i, *b = p + 2 * ((i + 1) % count);
        if (!(cross(middle, a, b) > least)) return false;
        rounds += a[1] <= middle[1] && b[1] > middle[1];
    }
    return rounds == 1;
}

bool bat_fill(size_t count, const double *corners, int *next, int *triangles, size_t *triangle_count,
              double middle[2]) {
    const double area = find_middle(count, corners, middle), least = 1e-15 * area;
    if (!(area > 0)) return false;
    if (count == 3 || !is_star(count, corners, middle, least))
        return count <= BAT_FILL_MOST && cut_ears(count, corners, least, next, triangles, triangle_count);
    for (size_t i = 0; i < count; i++) {
        triangles[3 * i] = (int)count;
        triangles[3 * i + 1] = (int)i;
        triangles[3 * i + 2] = (int)((i + 1) % count);
    }
    *triangle_count = count;
    return true;
}
