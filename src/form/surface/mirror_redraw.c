/* A redrawn line of a surface that is its own mirror image takes its image along. */
#include "base/order.h"
#include "base/vec.h"
#include "form/surface/mirror.h"
#include "form/surface/surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double SAME = 4e-9;   /* of the width: a knot so near to another's image is it */
static const double GAIN_MOST = 4; /* as bat_surface_redraw has it */

/* `was` and `now` have the same knots, which are their own image. */
typedef struct both {
    const bat_mirror *mirror;
    const bat_surface_way *way;
    bat_surface *was, *now;
    int shift[2], rows, columns;
    double *change,
        *part; /* of control points: what the stroke did, and what makes the result with its image */
} both;

/* ---- knots ---- */

/* How many of the ascending knots are there. */
static int copies_near(const double *knots, int count, double at, double near) {
    int low = 0, high = count, copies = 0;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (knots[middle] < at - near)
            low = middle + 1;
        else
            high = middle;
    }
    while (low + copies < count && knots[low + copies] <= at + near) copies++;
    return copies;
}

/* The knots of a and b and, inside the domain, their images; returns how many. out: room for 2 (a's + b's). */
static int all_knots(const bat_surface_way *way, const bat_surface *a, const bat_surface *b, int d,
                     double *out) {
    const bat_curve *axes[2] = {&a->axis[d], &b->axis[d]};
    const double *knots[2] = {bat_curve_knots(axes[0]), bat_curve_knots(axes[1])};
    const int most[2] = {bat_curve_knot_count(axes[0]), bat_curve_knot_count(axes[1])};
    double domain[2];
    int count = 0;
    for (int i = 0, k = 0; i < most[0] || k < most[1];) {
        const double next = k == most[1] || (i < most[0] && knots[0][i] <= knots[1][k]) ? knots[0][i]
                                                                                        : knots[1][k];
        i += i < most[0] && knots[0][i] == next;
        k += k < most[1] && knots[1][k] == next;
        out[count++] = next;
    }
    bat_curve_domain(axes[0], domain);
    const double near = SAME * (domain[1] - domain[0]);
    const int plain = count;
    for (int i = 0; i < plain; i++) {
        if (out[i] <= domain[0] + near || out[i] >= domain[1] - near || out[i] <= out[i - 1] + near) continue;
        bat_direction direction = d ? BAT_V : BAT_U;
        const double there = bat_surface_way_line(way, a, &direction, out[i]);
        if (there <= domain[0] + near || there >= domain[1] - near) continue;
        const int copies = copies_near(out, plain, out[i], near);
        for (int k = copies_near(out, plain, there, near); k < copies; k++) out[count++] = there;
    }
    qsort(out, (size_t)count, sizeof *out, bat_ascending); /* no ties that can be told apart */
    return count;
}

static bat_status refined(const bat_surface_way *way, bat_surface **a, bat_surface **b, int d) {
    const bat_direction direction = d ? BAT_V : BAT_U;
    const size_t room = 2 *
                        (size_t)(bat_curve_knot_count(&(*a)->axis[d]) + bat_curve_knot_count(&(*b)->axis[d]));
    double *knots = malloc(room * sizeof *knots);
    if (!knots) return BAT_MEMORY;
    const int count = all_knots(way, *a, *b, d, knots);
    bat_surface **const all[2] = {a, b};
    bat_status status = BAT_OK;
    for (int k = 0; k < 2 && status == BAT_OK; k++) {
        bat_surface *fine = NULL;
        status = bat_surface_refine(*all[k], direction, count, knots, &fine);
        if (status == BAT_OK) bat_surface_free(*all[k]), *all[k] = fine;
    }
    free(knots);
    return status;
}

/* Brings both to one degree and one set of knots. */
static bat_status bring_together(both *w, const bat_surface *before, const bat_surface *after) {
    bat_status status = bat_surface_copy(before, &w->was);
    if (status == BAT_OK) status = bat_surface_copy(after, &w->now);
    for (int d = 0; d < 2 && status == BAT_OK; d++) {
        const int degree = w->now->axis[d].degree;
        if (degree != w->was->axis[d].degree) {
            bat_surface *raised = NULL;
            status = bat_surface_raise(w->was, d ? BAT_V : BAT_U, degree, &raised);
            if (status == BAT_OK) bat_surface_free(w->was), w->was = raised;
        }
        if (status == BAT_OK) status = refined(w->way, &w->was, &w->now, d);
        if (status == BAT_OK && !bat_surface_way_shift(w->way, w->was, w->was, d, SAME, &w->shift[d]))
            status = BAT_KNOTS;
    }
    return status;
}

/* ---- changes of control points ---- */

static size_t at_of(const both *w, int i, int j) { return (size_t)i * (size_t)w->columns + (size_t)j; }

static int image_of(const both *w, int d, int i) {
    return bat_surface_way_index(w->way, d, w->shift[d], w->was, i);
}

/* The image of a movement. */
static void turned(const both *w, const double v[3], double out[3]) {
    const double n[2] = {w->mirror->along[1], -w->mirror->along[0]}, twice = 2 * (v[0] * n[0] + v[1] * n[1]);
    for (int k = 0; k < 3; k++) out[k] = k < 2 ? v[k] - twice * n[k] : v[k];
}

static void measure(both *w) {
    for (int i = 0; i < w->rows; i++)
        for (int k = 0; k < 3 * w->columns; k++)
            w->change[(size_t)3 * at_of(w, i, 0) + (size_t)k] = bat_surface_row(w->now, i)[k] -
                                                                bat_surface_row(w->was, i)[k];
}

/* The line lies in the plane, and stays there: half of each movement, which the image makes whole. */
static void stay_in_plane(both *w) {
    for (size_t k = 0; k < 3 * at_of(w, w->rows, 0); k++) w->part[k] = 0.5 * w->change[k];
}

static double share_of(const both *w, int side) {
    double sum = 0;
    for (int i = 0; i < w->rows; i++)
        for (int j = 0; j < w->columns; j++) {
            const double *p = bat_surface_row(w->was, i) + (ptrdiff_t)3 * j,
                         *d = w->change + 3 * at_of(w, i, j);
            if (bat_mirror_side(w->mirror, p) * side > 0) sum += d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        }
    return sum;
}

static double off_plane(const both *w, int i, int j) {
    return bat_mirror_side(w->mirror, bat_surface_row(w->was, i) + (ptrdiff_t)3 * j);
}

/* The line is its own image: one side of the plane decides; what lies in the plane counts half on each. */
static void take_side(both *w) {
    const int side = share_of(w, 1) > share_of(w, -1) ? 1 : -1;
    const double near = SAME * w->was->size;
    for (int i = 0; i < w->rows; i++)
        for (int j = 0; j < w->columns; j++) {
            const size_t at = 3 * at_of(w, i, j);
            const double off = side *
                               (off_plane(w, i, j) - off_plane(w, image_of(w, 0, i), image_of(w, 1, j)));
            const double share = off > near ? 1 : off < -near ? 0 : 0.5;
            for (size_t k = at; k < at + 3; k++) w->part[k] = share * w->change[k];
        }
}

/* How much of the line's movement its image's place takes part in: as the surface moved, by least squares. */
static bat_status leak(const both *w, bat_direction direction, double at, double there, double *out) {
    bat_curve *lines[4] = {0};
    bat_status status = BAT_OK;
    double both_ways = 0, square = 0;
    for (int k = 0; k < 4 && status == BAT_OK; k++)
        status = bat_surface_isocurve(k & 1 ? w->now : w->was, direction, k & 2 ? there : at, &lines[k]);
    for (int k = 0; status == BAT_OK && k < 3 * lines[0]->count; k++) {
        const double here = bat_curve_points(lines[1])[k] - bat_curve_points(lines[0])[k];
        both_ways += here * (bat_curve_points(lines[3])[k] - bat_curve_points(lines[2])[k]);
        square += here * here;
    }
    *out = square > 0 ? both_ways / square : 0;
    for (int k = 0; k < 4; k++) bat_curve_free(lines[k]);
    return status;
}

/* The line and its image are two: with c the leak, and R the image of a row's movement, each moves by
 * (1 + c R)^-1 = (1 - c R) / (1 - c^2) of the stroke's (R R = 1). *gain: by how much that is more. */
static void solve_both(both *w, int across, double c, double *gain) {
    double most = 0, before = 0;
    for (int i = 0; i < w->rows; i++)
        for (int j = 0; j < w->columns; j++) {
            const size_t at = 3 * at_of(w, i, j);
            const size_t other = 3 * (across == 0 ? at_of(w, i, image_of(w, 1, j))
                                                  : at_of(w, image_of(w, 0, i), j));
            double back[3], part[3] = {0}, *own = w->change + at;
            turned(w, w->change + other, back);
            for (int k = 0; k < 3; k++) part[k] = (own[k] - c * back[k]) / (1 - c * c);
            memcpy(w->part + at, part, sizeof part);
            most = fmax(most, part[0] * part[0] + part[1] * part[1] + part[2] * part[2]);
            before = fmax(before, own[0] * own[0] + own[1] * own[1] + own[2] * own[2]);
        }
    *gain = before > 0 ? sqrt(most / before) : 1;
}

/* ---- the result ---- */

static bat_status assemble(const both *w, bat_surface **out) {
    bat_surface *made = NULL;
    bat_status status = bat_surface_copy(w->was, &made);
    for (int i = 0; status == BAT_OK && i < w->rows; i++)
        for (int j = 0; j < w->columns; j++) {
            const double *own = w->part + 3 * at_of(w, i, j);
            /* the way there and the way back are the same */
            const double *other = w->part + 3 * at_of(w, image_of(w, 0, i), image_of(w, 1, j));
            double back[3], *p = bat_surface_own_row(made, i) + (ptrdiff_t)3 * j;
            turned(w, other, back);
            for (int k = 0; k < 3; k++)
                if (own[k] + back[k] != 0) p[k] += own[k] + back[k];
        }
    return status == BAT_OK ? bat_surface_finish(made, out) : status;
}

static bat_status choose_parts(both *w, bat_direction direction, double at, double *gain) {
    const int across = direction == BAT_V, along = 1 - across;
    bat_direction there = direction;
    const double place = bat_surface_way_line(w->way, w->was, &there, at);
    double domain[2];
    bat_surface_domain(w->was, direction, domain);
    const double far = fabs(place - at), width = domain[1] - domain[0];
    const bool same = far <= SAME * width || (w->was->axis[across].closed && far >= (1 - SAME) * width);
    double c = 0;
    *gain = 1;
    if (same) {
        const bool runs = !w->way->back[along] && w->shift[along] == 0;
        (runs ? stay_in_plane : take_side)(w);
        return BAT_OK;
    }
    bat_status status = leak(w, direction, at, place, &c);
    if (status != BAT_OK) return status;
    if (!(fabs(c) < 1 - 1e-6)) return BAT_FAR;
    solve_both(w, across, c, gain);
    return *gain > GAIN_MOST ? BAT_FAR : BAT_OK;
}

bat_status bat_surface_redraw_image(const bat_surface *before, const bat_surface *after,
                                    const bat_mirror *mirror, const bat_surface_way *way,
                                    bat_direction direction, double at, double *gain, bat_surface **out) {
    both w = {.mirror = mirror, .way = way};
    bat_status status = bring_together(&w, before, after);
    if (status == BAT_OK) {
        w.rows = w.was->axis[0].count, w.columns = w.was->axis[1].count;
        w.change = malloc(6 * at_of(&w, w.rows, 0) * sizeof *w.change);
        status = w.change ? BAT_OK : BAT_MEMORY;
    }
    if (status == BAT_OK) {
        w.part = w.change + 3 * at_of(&w, w.rows, 0);
        measure(&w);
        status = choose_parts(&w, direction, at, gain);
    }
    if (status == BAT_OK) status = assemble(&w, out);
    free(w.change);
    bat_surface_free(w.was);
    bat_surface_free(w.now);
    return status;
}
