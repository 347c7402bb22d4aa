/* Which surfaces are each other's mirror image, and which lines. */
#include "form/surface/mirror.h"
#include "base/vec.h"
#include "form/surface/surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double SAME = 1e-9;      /* of the width: knots so near to each other are equal */
static const double REPEATED = 1e-13; /* of the width: by rounding alone */

bat_status bat_surface_image(const bat_surface *surface, const bat_mirror *mirror, bat_surface **out) {
    double m[6];
    bat_mirror_matrix(mirror, m);
    const double rows[12] = {m[0], m[2], 0, m[4], m[1], m[3], 0, m[5], 0, 0, 1, 0};
    return bat_surface_transform(surface, rows, out);
}

/* ---- parameters ---- */

static double width_of(const bat_curve *axis) {
    double domain[2];
    bat_curve_domain(axis, domain);
    return domain[1] - domain[0];
}

/* Which axis of the other surface the axis d becomes. */
static int axis_there(const bat_surface_way *way, int d) { return way->swap ? 1 - d : d; }

/* How far two parameters are apart; in closed directions up to whole periods. */
static double apart(const bat_curve *axis, double a, double b) {
    const double width = width_of(axis), far = fabs(a - b);
    return axis->closed ? fabs(far - width * floor(far / width + 0.5)) : far;
}

double bat_surface_way_line(const bat_surface_way *way, const bat_surface *other, bat_direction *direction,
                            double at) {
    const int d = *direction == BAT_V, there = axis_there(way, d);
    *direction = there ? BAT_V : BAT_U;
    return bat_curve_reduce(&other->axis[there], way->back[d] ? way->sum[d] - at : at + way->sum[d]);
}

void bat_surface_way_range(const bat_surface_way *way, const bat_surface *other, bat_direction *direction,
                           const double range[2], double out[2]) {
    const int d = *direction == BAT_V, there = axis_there(way, d);
    const bat_curve *axis = &other->axis[there];
    const bool back = way->back[d];
    const double width = range[1] - range[0];
    double low = back ? way->sum[d] - range[1] : range[0] + way->sum[d];
    if (axis->closed) low = bat_curve_reduce(axis, low);
    *direction = there ? BAT_V : BAT_U;
    out[0] = low, out[1] = low + width;
}

/* Knot k of the axis; a closed one goes on in whole periods. */
static double knot_at(const bat_curve *axis, int k) {
    const double *knots = bat_curve_knots(axis);
    const int n = axis->count;
    if (!axis->closed) return knots[k];
    const int turns = k >= 0 ? k / n : -((n - 1 - k) / n);
    return knots[k - turns * n] + turns * width_of(axis);
}

/* The parameter that knot 0 of a adds up to with knot `first` of b. */
static double sum_at(const bat_curve *a, const bat_curve *b, bool back, int first) {
    return back ? knot_at(b, first) + knot_at(a, 0) : knot_at(b, first) - knot_at(a, 0);
}

/* Whether all knots of a become knots of b: knot k the knot `first` + k, or `first` - k. */
static bool knots_match(const bat_curve *a, const bat_curve *b, bool back, int first, double same) {
    const int count = bat_curve_knot_count(a);
    const double sum = sum_at(a, b, back, first), near = same * width_of(b);
    for (int k = 0; k < count; k++) {
        const double knot = knot_at(a, k), there = back ? sum - knot : knot + sum;
        if (fabs(there - knot_at(b, back ? first - k : first + k)) > near) return false;
    }
    return true;
}

/* Control point i lies over the knots from i to i + degree + 1, where closed. */
static int shift_of(const bat_curve *axis, bool back, int first) {
    if (!axis->closed) return back ? axis->count - 1 : 0;
    return back ? first - axis->degree - 1 : first;
}

int bat_surface_way_index(const bat_surface_way *way, int d, int shift, const bat_surface *a, int i) {
    const int n = a->axis[d].count, at = way->back[d] ? shift - i : shift + i;
    return a->axis[d].closed ? ((at % n) + n) % n : at;
}

bool bat_surface_way_shift(const bat_surface_way *way, const bat_surface *a, const bat_surface *b, int d,
                           double same, int *shift) {
    const bat_curve *from = &a->axis[d], *to = &b->axis[axis_there(way, d)];
    const int last = bat_curve_knot_count(to) - 1, turns = to->closed ? to->count : 1;
    for (int k = 0; k < turns; k++) {
        const int first = to->closed ? k : way->back[d] ? last : 0;
        if (apart(to, sum_at(from, to, way->back[d], first), way->sum[d]) > same * width_of(to) ||
            !knots_match(from, to, way->back[d], first, same))
            continue;
        *shift = shift_of(to, way->back[d], first);
        return true;
    }
    return false;
}

/* ---- surfaces ---- */

/* A point of b that a's point (i, j) becomes. */
static const double *partner(const bat_surface_way *way, const int shift[2], const bat_surface *a,
                             const bat_surface *b, int i, int j) {
    const int u = bat_surface_way_index(way, 0, shift[0], a, i),
              v = bat_surface_way_index(way, 1, shift[1], a, j);
    return way->swap ? bat_surface_row(b, v) + (ptrdiff_t)3 * u : bat_surface_row(b, u) + (ptrdiff_t)3 * v;
}

/* The image of a control point. */
static void image_at(const bat_mirror *mirror, const bat_surface *a, int i, int j, double out[3]) {
    const double *p = bat_surface_row(a, i) + (ptrdiff_t)3 * j;
    bat_mirror_point(mirror, p, out);
    out[2] = p[2];
}

static bool axes_match(const bat_curve *a, const bat_curve *b) {
    return a->degree == b->degree && a->closed == b->closed && a->count == b->count &&
           fabs(width_of(a) - width_of(b)) <= SAME * width_of(b);
}

/* What is looked for, and what has been found. */
typedef struct search {
    const bat_mirror *mirror;
    const bat_surface *a, *b;
    double within;
    bool own; /* the surface's way onto itself */
    bat_surface_way way;
    int shift[2];
} search;

static bool points_match(const search *s) {
    double image[3];
    for (int i = 0; i < s->a->axis[0].count; i++)
        for (int j = 0; j < s->a->axis[1].count; j++) {
            image_at(s->mirror, s->a, i, j, image);
            if (!(bat_distance(image, partner(&s->way, s->shift, s->a, s->b, i, j), 3) <= s->within))
                return false;
        }
    return true;
}

/* Whether the image has the other's box. */
static bool boxes_match(const search *s) {
    double low[2][3] = {{INFINITY, INFINITY, INFINITY}}, high[2][3] = {{-INFINITY, -INFINITY, -INFINITY}},
           image[3];
    for (int i = 0; i < s->a->axis[0].count; i++)
        for (int j = 0; j < s->a->axis[1].count; j++) {
            image_at(s->mirror, s->a, i, j, image);
            for (int k = 0; k < 3; k++)
                low[0][k] = fmin(low[0][k], image[k]), high[0][k] = fmax(high[0][k], image[k]);
        }
    bat_surface_box(s->b, low[1], high[1]);
    return bat_distance(low[0], low[1], 3) <= 2 * s->within &&
           bat_distance(high[0], high[1], 3) <= 2 * s->within;
}

/* Whether the way is one of a surface onto itself: not every point stays, and twice that way every point does. */
static bool is_turn(const search *s) {
    bool moves = false;
    for (int d = 0; d < 2; d++) {
        const int n = s->a->axis[d].count;
        if (!s->way.back[d] && 2 * s->shift[d] % n != 0) return false;
        for (int i = 0; i < n && i < 3; i++)
            moves = moves || bat_surface_way_index(&s->way, d, s->shift[d], s->a, i) != i;
    }
    return moves;
}

/* Tries all first knots of direction d, and then of the next. */
static bool search_from(search *s, int d) {
    if (d == 2) return (!s->own || is_turn(s)) && points_match(s);
    const bat_curve *from = &s->a->axis[d], *to = &s->b->axis[axis_there(&s->way, d)];
    const int last = bat_curve_knot_count(to) - 1, turns = to->closed ? to->count : 1;
    for (int back = 0; back < 2; back++)
        for (int k = 0; k < turns; k++) {
            const int first = to->closed ? k : back ? last : 0;
            s->way.back[d] = back != 0;
            s->way.sum[d] = sum_at(from, to, back != 0, first);
            s->shift[d] = shift_of(to, back != 0, first);
            if (knots_match(from, to, back != 0, first, SAME) && search_from(s, d + 1)) return true;
        }
    return false;
}

static bool search_way(search *s, bool swaps) {
    if (!boxes_match(s)) return false;
    for (int swap = 0; swap <= swaps; swap++) {
        s->way.swap = swap != 0;
        if (axes_match(&s->a->axis[0], &s->b->axis[swap]) &&
            axes_match(&s->a->axis[1], &s->b->axis[1 - swap]) && search_from(s, 0))
            return true;
    }
    return false;
}

static bool is_image(const bat_surface *a, const bat_surface *b, const bat_mirror *mirror, double within,
                     bool own, bat_surface_way *way) {
    search s = {.mirror = mirror, .a = a, .b = b, .within = within, .own = own};
    const bool found = search_way(&s, !own);
    if (found) *way = s.way;
    return found;
}

bool bat_surface_is_image(const bat_surface *a, const bat_surface *b, const bat_mirror *mirror, double within,
                          bat_surface_way *way) {
    return is_image(a, b, mirror, within, false, way);
}

bool bat_surface_is_own_image(const bat_surface *surface, const bat_mirror *mirror, double within,
                              bat_surface_way *way) {
    return is_image(surface, surface, mirror, within, true, way);
}

/* ---- the image of what has changed ---- */

/* The knots of axis d run that way, ascending, from where the other's begin. */
static void run_knots(const bat_surface_way *way, const bat_surface *from, const bat_surface *other, int d,
                      bat_curve *to) {
    const bat_curve *axis = &from->axis[d], *like = &other->axis[axis_there(way, d)];
    const int count = bat_curve_knot_count(axis), n = axis->count;
    double *out = bat_curve_own_knots(to);
    int first = way->back[d] ? count - 1 : 0;
    if (axis->closed) { /* the knot that becomes the start of the other's domain */
        const double start = bat_curve_knots(like)[0];
        for (int k = 0; k < n; k++) {
            const double knot = knot_at(axis, k);
            const bool twice = k > 0 && knot == knot_at(axis, k - 1);
            if (!(twice && !way->back[d]) &&
                apart(axis, way->back[d] ? way->sum[d] - knot : knot + way->sum[d], start) <=
                    4 * SAME * width_of(axis))
                first = k;
        }
    }
    const double begin = way->back[d] ? way->sum[d] - knot_at(axis, first)
                                      : knot_at(axis, first) + way->sum[d];
    const double periods = axis->closed ? bat_curve_knots(like)[0] - begin : 0;
    for (int k = 0; k < count; k++) {
        const double knot = knot_at(axis, way->back[d] ? first - k : first + k);
        out[k] = (way->back[d] ? way->sum[d] - knot : knot + way->sum[d]) + periods;
        if (k > 0 && out[k] - out[k - 1] <= REPEATED * width_of(axis)) out[k] = out[k - 1];
    }
}

/* Whether the surfaces have the same knots and counts. */
static bool same_net(const bat_surface *a, const bat_surface *b) {
    for (int d = 0; d < 2; d++) {
        const int count = bat_curve_knot_count(&a->axis[d]);
        if (a->axis[d].degree != b->axis[d].degree || count != bat_curve_knot_count(&b->axis[d]) ||
            memcmp(bat_curve_knots(&a->axis[d]), bat_curve_knots(&b->axis[d]),
                   (size_t)count * sizeof(double)) != 0)
            return false;
    }
    return true;
}

/* An empty surface with the knots of `image` run that way. */
static bat_status begin_run(const bat_surface_way *way, const bat_surface *image, const bat_surface *other,
                            bool keeps, bat_surface **out) {
    int degree[2], count[2];
    bool closed[2];
    for (int d = 0; d < 2; d++) {
        const int there = axis_there(way, d);
        degree[there] = image->axis[d].degree, count[there] = image->axis[d].count;
        closed[there] = image->axis[d].closed;
    }
    bat_status status = bat_surface_allocate(degree, closed, count, out);
    for (int d = 0; d < 2 && status == BAT_OK; d++) {
        const int there = axis_there(way, d);
        if (keeps)
            memcpy(bat_curve_own_knots(&(*out)->axis[there]), bat_curve_knots(&other->axis[there]),
                   (size_t)bat_curve_knot_count(&other->axis[there]) * sizeof(double));
        else
            run_knots(way, image, other, d, &(*out)->axis[there]);
    }
    return status;
}

bat_status bat_surface_follow_image(const bat_surface *was, const bat_surface *now, const bat_surface *other,
                                    const bat_mirror *mirror, const bat_surface_way *way, bat_surface **out) {
    const bool keeps = same_net(was, now);
    bat_surface *image = NULL, *made = NULL;
    int shift[2] = {0, 0};
    bat_status status = bat_surface_image(now, mirror, &image);
    if (status == BAT_OK) status = begin_run(way, image, other, keeps, &made);
    for (int d = 0; d < 2 && status == BAT_OK; d++)
        if (!bat_surface_way_shift(way, image, made, d, 4 * SAME, &shift[d])) status = BAT_KNOTS;
    for (int i = 0; status == BAT_OK && i < image->axis[0].count; i++)
        for (int j = 0; j < image->axis[1].count; j++) {
            const int u = bat_surface_way_index(way, 0, shift[0], image, i),
                      v = bat_surface_way_index(way, 1, shift[1], image, j), row = way->swap ? v : u;
            const ptrdiff_t at = (ptrdiff_t)3 * (way->swap ? u : v), from = (ptrdiff_t)3 * j;
            const bool stays = keeps && !memcmp(bat_surface_row(was, i) + from,
                                                bat_surface_row(now, i) + from, 3 * sizeof(double));
            memcpy(bat_surface_own_row(made, row) + at,
                   stays ? bat_surface_row(other, row) + at : bat_surface_row(image, i) + from,
                   3 * sizeof(double));
        }
    bat_surface_free(image);
    if (status == BAT_OK) return bat_surface_finish(made, out);
    free(made);
    return status;
}
