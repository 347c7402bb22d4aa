#include "format/model/full.h"

#include "text/number.h"

#include <batten/refine.h>

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static bat_full_axis axis_of(int degree, bool closed, size_t count, const double *knots) {
    const int own = (int)count, before = closed ? degree : 0;
    return (bat_full_axis){degree, own, own + before, before, knots, closed ? knots[own] - knots[0] : 0};
}

bat_full_axis bat_full_axis_of_curve(const bat_curve *curve) {
    return axis_of(bat_curve_degree(curve), bat_curve_is_closed(curve), bat_curve_count(curve),
                   bat_curve_knots(curve));
}

bat_full_axis bat_full_axis_of_surface(const bat_surface *surface, bat_direction direction) {
    return axis_of(bat_surface_degree(surface, direction), bat_surface_is_closed(surface, direction),
                   bat_surface_count(surface, direction), bat_surface_knots(surface, direction));
}

int bat_full_point(const bat_full_axis *axis, int i) {
    return ((i - axis->before) % axis->own + axis->own) % axis->own;
}

double bat_full_knot(const bat_full_axis *axis, int i) {
    int k = i - axis->before, turns = 0;
    for (; axis->before && k < 0; k += axis->own) turns--;
    for (; axis->before && k > axis->own; k -= axis->own) turns++;
    return turns ? axis->knots[k] + turns * axis->period : axis->knots[k]; /* -0 stays what it is */
}

/* ---- back ---- */

/* How points lie: `lines` of them, each with point i at i * step, and the next at `stride`. */
typedef struct lattice {
    const double *points;
    size_t size, step, lines, stride;
} lattice;

static bool do_points_wrap(const lattice *at, int n, int degree) {
    for (size_t l = 0; l < at->lines; l++)
        for (size_t i = 0; i < (size_t)degree; i++)
            for (size_t c = 0; c < at->size; c++) {
                const double *p = at->points + l * at->stride + i * at->step + c;
                if (*p != p[(size_t)n * at->step]) return false;
            }
    return true;
}

/* The number of distinct points, or 0 when points and knots do not wrap round. */
static int period_of(const lattice *at, int count, int degree, const double *knots) {
    const int n = count - degree;
    if (n < 2 || !(knots[degree + n] > knots[degree])) return 0;
    const double period = knots[degree + n] - knots[degree];
    if (!do_points_wrap(at, n, degree)) return 0;
    for (int i = 0; i + n <= count + degree; i++)
        if (!(fabs(knots[i + n] - knots[i] - period) <= 4 * DBL_EPSILON * (fabs(knots[i + n]) + period)))
            return 0;
    return n;
}

int bat_full_pack(size_t count, double *points) {
    for (size_t i = 0; i < count; i++)
        if (points[3 * i + 2] != 0) return 3;
    for (size_t i = 0; i < count; i++) memmove(points + 2 * i, points + 3 * i, 2 * sizeof *points);
    return 2;
}

double bat_full_side(size_t count, const double *points) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, side = 0;
    for (size_t i = 0; i < 3 * count; i++) {
        low[i % 3] = fmin(low[i % 3], points[i]);
        high[i % 3] = fmax(high[i % 3], points[i]);
    }
    for (int k = 0; k < 3; k++) side = fmax(side, high[k] - low[k]);
    return side;
}

bat_status bat_full_curve(int degree, size_t count, double *points, const double *knots, bat_curve **out) {
    if (count <= (size_t)degree || count > BAT_POINTS_MAX) return BAT_COUNT;
    const int size = bat_full_pack(count, points);
    const lattice at = {points, (size_t)size, (size_t)size, 1, 0};
    const int round = period_of(&at, (int)count, degree, knots), from = round ? degree : 0;
    return bat_curve_create(size, degree, round > 0, round ? (size_t)round : count, points + from * size,
                            round ? round + 1 : (int)count + degree + 1, knots + from, out);
}

bat_status bat_full_surface(const int degree[2], const size_t count[2], double *points,
                            const double *const knots[2], bat_surface **out) {
    int round[2], from[2], knot_count[2];
    for (int d = 0; d < 2; d++)
        if (count[d] <= (size_t)degree[d] || count[d] > BAT_POINTS_MAX) return BAT_COUNT;
    for (int d = 0; d < 2; d++) {
        const lattice at = d ? (lattice){points, 3, 3, count[0], 3 * count[1]}
                             : (lattice){points, 3, 3 * count[1], count[1], 3};
        round[d] = period_of(&at, (int)count[d], degree[d], knots[d]);
        from[d] = round[d] ? degree[d] : 0;
        knot_count[d] = round[d] ? round[d] + 1 : (int)count[d] + degree[d] + 1;
    }
    const bool closed[2] = {round[0] > 0, round[1] > 0};
    const size_t kept[2] = {closed[0] ? (size_t)round[0] : count[0], closed[1] ? (size_t)round[1] : count[1]};
    for (size_t i = 0; i < kept[0]; i++)
        memmove(points + 3 * i * kept[1], points + 3 * ((i + (size_t)from[0]) * count[1] + (size_t)from[1]),
                3 * kept[1] * sizeof *points);
    return bat_surface_create(degree, closed, kept, points, knot_count, knots[0] + from[0],
                              knots[1] + from[1], out);
}

bat_status bat_full_cut(bat_curve *curve, const double range[2], bat_curve **out) {
    double domain[2];
    bat_curve_domain(curve, domain);
    *out = curve;
    const double slack = 1e-12 * (domain[1] - domain[0]);
    if (range[0] <= domain[0] + slack && range[1] >= domain[1] - slack) return BAT_OK;
    bat_status status = bat_curve_piece(curve, fmax(range[0], domain[0]), fmin(range[1], domain[1]), out);
    bat_curve_free(curve);
    return status;
}

bool bat_full_is_whole(const bat_surface *surface, bat_direction direction, const double range[2]) {
    double domain[2];
    bat_surface_domain(surface, direction, domain);
    const double slack = 1e-6 * (domain[1] - domain[0]);
    return range[0] <= domain[0] + slack && range[1] >= domain[1] - slack;
}

/* ---- numbers ---- */

void bat_full_number(double number, char out[40]) {
    char digits[BAT_NUMBER_ROOM];
    bool point = false;
    bat_number_print(number, digits);
    for (const char *at = digits; *at; at++) {
        if (*at == 'e' && !point) *out++ = '.';
        point = point || *at == '.' || *at == 'e';
        *out++ = *at == 'e' ? 'E' : *at;
    }
    if (!point) *out++ = '.';
    *out = '\0';
}

bool bat_numbers_add(bat_numbers *to, double value) {
    if (to->count == to->room) {
        const size_t room = 2 * to->room + 64;
        double *list = realloc(to->list, room * sizeof *list);
        if (!list) return false;
        to->list = list;
        to->room = room;
    }
    to->list[to->count++] = value;
    return true;
}

void bat_numbers_clear(bat_numbers *numbers) {
    free(numbers->list);
    *numbers = (bat_numbers){0};
}
