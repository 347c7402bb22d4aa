/*
 * Where a ray meets a surface (docs/math/surfaces.md). Seen along the ray, the surface is a map from (u, v) to
 * the plane at right angles to the ray, and the hits are its zeros. Each span becomes a Bézier cell. A cell is
 * dropped when zero lies outside the box of its image, or outside the image's box along and across its longer
 * side (which is thin near a fold), or when it lies behind the origin. When the map is one-to-one on the cell,
 * Newton's method from the middle finds the only zero. Otherwise the cell is halved; cells that remain at the end
 * are places where the ray touches the surface.
 */
#include "form/surface/finder.h"
#include "base/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS_MAX = 8192, STEPS = 12 };          /* cells per span; more: the ray runs within the surface */
static const double smallest = 1.0 / (1 << 26); /* of a span: the ray touches at a cell this small */
static const double same =
    1e-6; /* of a span: hits this close are one, as rounding separates those of a touching ray */

typedef struct search {
    const bat_surface *surface;
    bat_surface *seen;       /* seen: in coordinates with x and y across the ray, z along it */
    double rounding, behind; /* what counts as zero across; smaller depths are behind */
    int degree[2], span[2];
    bat_surface_point *hits;
    size_t count, room;
    bool failed;
    bat_cells waiting;
} search;

/* ---- The hits ---- */

static double apart(const bat_curve *axis, double a, double b) {
    const double d = fabs(a - b);
    return axis->closed ? fmin(d, fabs(d - (axis->knots[axis->spread] - axis->knots[axis->degree]))) : d;
}

/* Whether x in a span's [0, 1] is one of the ends. */
static bool at_end(double x) { return x <= same || x >= 1 - same; }

/* Whether a hit is known already: at the same parameters or, on edges of spans, at the same point in space (a
 * seam, a pole). */
static bool is_known(const search *s, const bat_surface_point *p, bool edge) {
    const bat_curve *axis = s->seen->axis;
    const double *u = axis[0].knots + s->span[0], *v = axis[1].knots + s->span[1];
    for (size_t i = 0; i < s->count; i++) {
        const bat_surface_point *q = &s->hits[i];
        if (apart(&axis[0], p->u, q->u) <= same * (u[1] - u[0]) &&
            apart(&axis[1], p->v, q->v) <= same * (v[1] - v[0]))
            return true;
        if (edge && bat_distance(p->point, q->point, 3) <= 1e-9 * s->surface->size) return true;
    }
    return false;
}

static void add(search *s, const double x[2]) {
    bat_surface_point p;
    double jet[3];
    p.u = bat_span_parameter(s->seen, 0, s->span[0], x[0]);
    p.v = bat_span_parameter(s->seen, 1, s->span[1], x[1]);
    bat_surface_eval_spans(s->seen, s->span, p.u, p.v, 0, jet);
    if (jet[2] < s->behind) return;
    p.distance = fmax(jet[2], 0);
    bat_surface_eval_spans(s->surface, s->span, p.u, p.v, 0, p.point);
    p.u = bat_curve_reduce(&s->seen->axis[0], p.u), p.v = bat_curve_reduce(&s->seen->axis[1], p.v);
    if (s->failed || is_known(s, &p, at_end(x[0]) || at_end(x[1]))) return;
    if (s->count == s->room) {
        const size_t room = 2 * s->room + 4;
        bat_surface_point *more = realloc(s->hits, room * sizeof *more);
        if (!more) {
            s->failed = true;
            return;
        }
        s->hits = more, s->room = room;
    }
    size_t at = s->count++;
    for (; at > 0 && s->hits[at - 1].distance > p.distance; at--) s->hits[at] = s->hits[at - 1];
    s->hits[at] = p;
}

/* ---- One cell ---- */

/* Whether the net's box along (x, y) and across it, widened by `slack`, holds zero. Flags, as they need not wait for one
 * another like a least and a greatest number. */
static bool box_holds_zero(const search *s, const double *net, double x, double y, double slack) {
    const int count = (s->degree[0] + 1) * (s->degree[1] + 1);
    int low = 0, high = 0, left = 0, right = 0;
    for (int i = 0; i < count; i++, net += 3) {
        const double along = x * net[0] + y * net[1], across = x * net[1] - y * net[0];
        low |= along <= slack, high |= along >= -slack;
        left |= across <= slack, right |= across >= -slack;
    }
    return low & high & left & right;
}

static bool is_behind(const search *s, const double *net) {
    const int count = (s->degree[0] + 1) * (s->degree[1] + 1);
    int before = 0;
    for (int i = 0; i < count; i++) before |= net[3 * i + 2] >= s->behind;
    return !before;
}

/* How far a cell reaches along u (0) or v (1) in the image: the sum of the vectors from end to end of its two
 * sides in that direction. */
static void extent(const search *s, const double *net, int direction, double way[2]) {
    const int p = s->degree[0], q = s->degree[1], row = 3 * (q + 1);
    const double *a = net, *b = direction == 0 ? net + 3 * q : net + p * row;
    const int step = direction == 0 ? p * row : 3 * q;
    for (int c = 0; c < 2; c++) way[c] = (a[step + c] - a[c]) + (b[step + c] - b[c]);
}

static double longest(const search *s, const double *net, int direction) {
    const int p = s->degree[0], q = s->degree[1], row = 3 * (q + 1);
    const int step = direction == 0 ? row : 3;
    double most = 0;
    for (int i = 0; i <= p - (direction == 0); i++)
        for (int j = 0; j <= q - (direction == 1); j++) {
            const double *a = net + i * row + 3 * j;
            most = fmax(most, fabs(a[step] - a[0]) + fabs(a[step + 1] - a[1]));
        }
    return most * s->degree[direction];
}

static bool may_hit(const search *s, const double *net) {
    if (is_behind(s, net) || !box_holds_zero(s, net, 1, 0, s->rounding)) return false;
    double u[2], v[2];
    extent(s, net, 0, u);
    extent(s, net, 1, v);
    const double a = bat_hypot(u[0], u[1]), b = bat_hypot(v[0], v[1]);
    if (!(fmax(a, b) > 0)) return true;
    const double x = (a > b ? u[0] : v[0]) / fmax(a, b), y = (a > b ? u[1] : v[1]) / fmax(a, b);
    return box_holds_zero(s, net, x, y, 2 * s->rounding);
}

/* Whether every step of the net along u turns the same way to every step along v: the map is then one-to-one. */
static bool is_one_to_one(const search *s, const double *net) {
    const int p = s->degree[0], q = s->degree[1], row = 3 * (q + 1);
    int sign = 0;
    for (int i = 0; i < p; i++)
        for (int j = 0; j <= q; j++) {
            const double *a = net + i * row + 3 * j, du[2] = {a[row] - a[0], a[row + 1] - a[1]};
            for (int k = 0; k <= p; k++)
                for (int l = 0; l < q; l++) {
                    const double *b = net + k * row + 3 * l;
                    const double det = du[0] * (b[4] - b[1]) - du[1] * (b[3] - b[0]);
                    const int turn = (det > 0) - (det < 0);
                    if (turn == 0 || (sign && turn != sign)) return false;
                    sign = turn;
                }
        }
    return true;
}

/* One step towards zero, in the span's [0, 1]: Newton's, or, with damping (relative to the size of the
 * matrix), that of Levenberg and Marquardt, which also works at a fold. Returns false when there is no step.
 * *left: the distance from zero at x. */
static bool step(const search *s, const double x[2], double damping, double move[2], double *left) {
    double jet[9], width[2], at[2];
    for (int d = 0; d < 2; d++) {
        const double *t = s->seen->axis[d].knots + s->span[d];
        width[d] = t[1] - t[0], at[d] = t[0] + x[d] * width[d];
    }
    bat_surface_eval_spans(s->seen, s->span, at[0], at[1], 1, jet);
    double a = jet[3] * width[0], b = jet[6] * width[1], c = jet[4] * width[0], d = jet[7] * width[1];
    double f = jet[0], g = jet[1];
    *left = bat_hypot(f, g);
    if (damping > 0) { /* the normal equations */
        const double more = damping * (a * a + b * b + c * c + d * d), uu = a * a + c * c + more,
                     uv = a * b + c * d, vv = b * b + d * d + more, fu = a * f + c * g, fv = b * f + d * g;
        a = uu, b = c = uv, d = vv, f = fu, g = fv;
    }
    const double det = a * d - b * c;
    move[0] = (b * g - d * f) / det, move[1] = (c * f - a * g) / det;
    return isfinite(move[0]) && isfinite(move[1]);
}

/* Newton's method from the middle; true: there is a zero at x, in the cell up to rounding at its edges. */
static bool newton(const search *s, const bat_cell *cell, double x[2]) {
    double move[2], left, size[2];
    for (int d = 0; d < 2; d++) size[d] = cell->high[d] - cell->low[d], x[d] = cell->low[d] + 0.5 * size[d];
    bool settled = false;
    for (int i = 0; i < STEPS && !settled; i++) {
        if (!step(s, x, 0, move, &left)) return false;
        settled = fmax(fabs(move[0]), fabs(move[1])) < 1e-14;
        for (int d = 0; d < 2; d++) {
            x[d] += move[d];
            if (!(x[d] > cell->low[d] - size[d] && x[d] < cell->high[d] + size[d])) return false;
        }
    }
    for (int d = 0; d < 2; d++) {
        const double slack = 1e-9 * size[d] + 1e-13;
        if (x[d] < cell->low[d] - slack || x[d] > cell->high[d] + slack) return false;
        x[d] = fmin(fmax(x[d], 0), 1);
    }
    return settled || left <= s->rounding;
}

/* Finds the place where the ray touches, by damped steps from the middle as long as they come nearer. */
static void touch(search *s, const bat_cell *cell) {
    double x[2], move[2], next[2], left, now;
    for (int d = 0; d < 2; d++) x[d] = 0.5 * (cell->low[d] + cell->high[d]);
    bool nearer = step(s, x, 1e-10, move, &left);
    for (int i = 0; i < STEPS && nearer; i++) {
        for (int d = 0; d < 2; d++) next[d] = fmin(fmax(x[d] + move[d], 0), 1);
        nearer = step(s, next, 1e-10, move, &now) && now < left;
        if (now < left) memcpy(x, next, sizeof x), left = now;
    }
    /* Moves onto the span's edge if the ray passes through the edge there. */
    for (int d = 0; d < 2; d++) next[d] = x[d] < same ? 0 : x[d] > 1 - same ? 1 : x[d];
    step(s, next, 1e-10, move, &now);
    add(s, now <= fmax(left, s->rounding) ? next : x);
}

static bool is_small(const bat_cell *cell) {
    const double most = fmax(cell->high[0] - cell->low[0], cell->high[1] - cell->low[1]);
    return most <= smallest || cell->halvings == BAT_CELL_HALVINGS;
}

/* The direction in which to halve the cell: the longer one in the image, or, once the cell is tiny in that
 * one, the other, along which the ray runs. */
static int across(const search *s, const bat_cell *cell) {
    const double a = longest(s, cell->net, 0), b = longest(s, cell->net, 1);
    const int direction = a == b ? cell->halvings % 2 : a < b;
    return cell->high[direction] - cell->low[direction] > smallest * smallest ? direction : 1 - direction;
}

static void search_span(search *s, const bat_surface_finder *finder) {
    int top = 0, cells = 0;
    s->failed = !bat_cells_hold(&s->waiting, 1);
    if (s->failed) return;
    bat_cell *whole = s->waiting.at;
    bat_cell_gather(s->seen, s->span, whole->net); /* cheaper than the cell, and tells most of what misses */
    if (!may_hit(s, whole->net)) return;
    bat_finder_share(finder, s->span, whole->net);
    whole->low[0] = whole->low[1] = 0, whole->high[0] = whole->high[1] = 1, whole->halvings = 0;
    while (top >= 0 && cells++ < CELLS_MAX && !s->failed) {
        s->failed = !bat_cells_hold(&s->waiting, top + 2);
        if (s->failed) return;
        bat_cell *cell = s->waiting.at + top--;
        double x[2];
        if (!may_hit(s, cell->net)) continue;
        if (is_one_to_one(s, cell->net) && newton(s, cell, x)) {
            add(s, x);
        } else if (is_small(cell)) {
            touch(s, cell);
        } else {
            bat_cell_halve(s->degree, across(s, cell), cell, cell + 1);
            top += 2;
        }
    }
}

/* ---- All spans ---- */

/* The ray in the surface's own coordinates. */
typedef struct ray {
    const double *from, *axes; /* axes: x and y across the ray, z along it */
    double slack, behind;
} ray;

/* Whether the ray may meet a box, widened by more than rounding. */
static bool may_meet(const ray *r, const bat_box *box) {
    const double *way = r->axes + 6;
    double first = r->behind, last = INFINITY;
    for (int c = 0; c < 3; c++) {
        const double low = box->low[c] - r->slack - r->from[c], high = box->high[c] + r->slack - r->from[c];
        if (!(fabs(way[c]) > 1e-100)) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        const double a = low / way[c], b = high / way[c];
        const double near = a < b ? a : b, far = a < b ? b : a; /* no NaN: quicker than fmin */
        first = near > first ? near : first, last = far < last ? far : last;
    }
    return first <= last;
}

static void search_block(search *s, const bat_surface_finder *f, const ray *r, int i, int block) {
    const int end = (block + 1) * BAT_FINDER_BLOCK;
    for (int j = block * BAT_FINDER_BLOCK; j < end && j < f->spans[1] && !s->failed; j++) {
        if (!may_meet(r, &f->span[i * f->spans[1] + j]) || !bat_finder_span(f, i, j, s->span)) continue;
        bat_finder_see(f, s->span, r->from, r->axes, s->seen);
        search_span(s, f);
    }
}

/* Row by row, so that spans come in the order of their knots. */
static void search_all(search *s, const bat_surface_finder *f, const ray *r) {
    for (int i = 0; i < f->spans[0]; i++)
        for (int block = 0; block < f->blocks[1] && !s->failed; block++)
            if (may_meet(r, &f->block[i / BAT_FINDER_BLOCK * f->blocks[1] + block]))
                search_block(s, f, r, i, block);
}

static bool is_finite(const double x[3]) { return isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2]); }

/* How far the corners of the whole surface's box are from a point, at most, in any direction. */
static double reach_of(const bat_box *box, const double from[3]) {
    vec far;
    double most[3];
    for (int c = 0; c < 3; c++) most[c] = fmax(fabs(box->low[c] - from[c]), fabs(box->high[c] - from[c]));
    far = vec_load(most, 3);
    return vec_norm(far);
}

bat_status bat_surface_finder_hits(const bat_surface_finder *finder, const double origin[3],
                                   const double direction[3], size_t room, bat_surface_point *out,
                                   size_t *count) {
    if (!finder || !origin || !direction || !count || (room > 0 && !out)) return BAT_ARGUMENT;
    if (!is_finite(origin) || !is_finite(direction)) return BAT_NUMBER;
    const vec z = vec_unit(vec_load(direction, 3));
    if (!(vec_norm(z) > 0)) return BAT_ARGUMENT;
    const vec x = vec_any_normal(z), y = vec_cross(z, x);
    const double axes[9] = {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z};
    const bat_surface *surface = finder->surface;
    bat_surface *seen;
    bat_status status = bat_finder_seen(finder, &seen);
    if (status != BAT_OK) return status;
    search s = {.surface = surface, .seen = seen, .behind = -1e-10 * surface->size};
    const double reach = reach_of(&finder->whole, origin);
    s.rounding = 4e-15 * reach;
    const ray r = {origin, axes, 1e-13 * reach, s.behind - 1e-13 * reach};
    for (int d = 0; d < 2; d++) s.degree[d] = surface->axis[d].degree;
    search_all(&s, finder, &r);
    if (s.failed) {
        status = BAT_MEMORY;
    } else {
        for (size_t i = 0; i < s.count && i < room; i++) out[i] = s.hits[i];
        *count = s.count;
    }
    free(s.hits);
    free(s.waiting.at);
    bat_surface_free(seen);
    return status;
}

bat_status bat_surface_hits(const bat_surface *surface, const double origin[3], const double direction[3],
                            size_t room, bat_surface_point *out, size_t *count) {
    bat_surface_finder *finder = NULL;
    if (!surface || !origin || !direction || !count || (room > 0 && !out)) return BAT_ARGUMENT;
    bat_status status = bat_surface_finder_create(surface, &finder);
    if (status != BAT_OK) return status;
    status = bat_surface_finder_hits(finder, origin, direction, room, out, count);
    bat_surface_finder_free(finder);
    return status;
}
