/* Why the numbers of a curve or a surface are refused. */
#include "base/count.h"
#include "curve/curve.h"
#include "text/json.h"
#include "text/number.h"

#include <batten/check.h>

#include <math.h>
#include <stdio.h>

enum { PLACE = 96, ROOM = 160 };

static bool say_knot(bat_problem *problem, const char *name, int index, const char *expected, double found) {
    char place[PLACE];
    snprintf(place, sizeof place, "%s[%d]", name, index);
    bat_problem_found(problem, BAT_OK, place, 0, expected, found);
    return true;
}

/* Says which knot is wrong, of those that bat_knots_check refuses. */
static bool is_wrong_knot(bat_problem *problem, const char *name, int degree, bool closed, int total,
                          const double *knots) {
    char expected[ROOM], before[BAT_NUMBER_ROOM];
    for (int i = 0; i < total; i++)
        if (!(fabs(knots[i]) <= BAT_KNOT_MAX))
            return say_knot(problem, name, i, "a number up to 1e30", knots[i]);
    for (int i = 1, run = 1; i < total; i++) {
        run = knots[i] == knots[i - 1] ? run + 1 : 1;
        const int most = degree + (!closed && (knots[i] == knots[0] || knots[i] == knots[total - 1]));
        bat_number_print(knots[i - 1], before);
        snprintf(expected, sizeof expected, "at least %s", before);
        if (knots[i] < knots[i - 1]) return say_knot(problem, name, i, expected, knots[i]);
        snprintf(expected, sizeof expected, "at most %d equal knots", most);
        if (run > most) return say_knot(problem, name, i, expected, knots[i]);
        if (knots[i] > knots[i - 1] && knots[i] - knots[i - 1] < BAT_SPAN_MIN)
            return say_knot(problem, name, i, "the knot before, or 1e-30 more", knots[i]);
    }
    bat_problem_set(problem, BAT_OK, name,
                    closed
                        ? "expected knots that differ one period away, and no more equal ones than the degree"
                        : "expected a domain whose first and last span are not empty");
    return true;
}

/* What is wrong with a curve's knots, or with those of one direction of a surface. */
static bool is_wrong_axis(bat_problem *problem, const char *name, const char *count_name, int degree,
                          bool closed, size_t count, int knot_count, const double *knots) {
    const int inside = bat_count_inside(count), total = closed ? inside + 1 : inside + degree + 1;
    if (bat_problem_outside(problem, count_name, 0, closed ? 2 : degree + 1, BAT_POINTS_MAX, inside))
        return true;
    if (bat_problem_outside(problem, name, 0, total, total, knot_count)) return true;
    return bat_knots_check(degree, closed, inside, knots) != BAT_OK &&
           is_wrong_knot(problem, name, degree, closed, total, knots);
}

static bool is_wrong_point(bat_problem *problem, size_t rows, size_t columns, int dimension,
                           const double *points) {
    const size_t each = (size_t)dimension;
    for (size_t i = 0; i < rows * columns * each; i++) {
        if (fabs(points[i]) <= BAT_COORDINATE_MAX) continue;
        char place[PLACE];
        if (rows > 1)
            snprintf(place, sizeof place, "points[%zu][%zu][%%zu]", i / each / columns, i / each % columns);
        else
            snprintf(place, sizeof place, "points[%zu][%%zu]", i / each);
        bat_problem_found(problem, BAT_OK, place, i % each, "a number up to 1e75", points[i]);
        return true;
    }
    return false;
}

/* Whether a status is about the numbers, which can be looked at. */
static bool is_of_numbers(bat_status status) {
    return status != BAT_OK && status != BAT_ARGUMENT && status != BAT_MEMORY;
}

/* The status, and its words where nothing else has been said. */
static bat_status finish(bat_problem *problem, bat_status status, bool is_said) {
    return status == BAT_OK || is_said ? status
                                       : bat_problem_set(problem, status, "", bat_status_message(status));
}

bat_status bat_curve_check(int dimension, int degree, bool closed, size_t count, const double *points,
                           int knot_count, const double *knots, bat_problem *problem) {
    bat_curve *made = NULL;
    const bat_status status = bat_curve_create(dimension, degree, closed, count, points, knot_count, knots,
                                               &made);
    bat_curve_free(made);
    const bool said = is_of_numbers(status) &&
                      (bat_problem_outside(problem, "degree", 0, 1, BAT_DEGREE_MAX, degree) ||
                       bat_problem_outside(problem, "dimension", 0, 2, BAT_DIMENSION_MAX, dimension) ||
                       is_wrong_axis(problem, "knots", "count", degree, closed, count, knot_count, knots) ||
                       is_wrong_point(problem, 1, count, dimension, points));
    return finish(problem, status, said);
}

bat_status bat_curve_clamped_check(int dimension, int degree, size_t count, const double *points,
                                   bat_problem *problem) {
    bat_curve *made = NULL;
    const bat_status status = bat_curve_create_clamped(dimension, degree, count, points, &made);
    bat_curve_free(made);
    const bool said = is_of_numbers(status) &&
                      (bat_problem_outside(problem, "degree", 0, 1, BAT_DEGREE_MAX, degree) ||
                       bat_problem_outside(problem, "dimension", 0, 2, BAT_DIMENSION_MAX, dimension) ||
                       bat_problem_outside(problem, "count", 0, degree + 1, BAT_POINTS_MAX, (double)count) ||
                       is_wrong_point(problem, 1, count, dimension, points));
    return finish(problem, status, said);
}

bat_status bat_surface_check(const int degree[2], const bool closed[2], const size_t count[2],
                             const double *points, const int knot_count[2], const double *u_knots,
                             const double *v_knots, bat_problem *problem) {
    bat_surface *made = NULL;
    const bat_status status = bat_surface_create(degree, closed, count, points, knot_count, u_knots, v_knots,
                                                 &made);
    bat_surface_free(made);
    const bool said = is_of_numbers(status) &&
                      (bat_problem_outside(problem, "degree[0]", 0, 1, BAT_DEGREE_MAX, degree[0]) ||
                       bat_problem_outside(problem, "degree[1]", 0, 1, BAT_DEGREE_MAX, degree[1]) ||
                       is_wrong_axis(problem, "u_knots", "count[0]", degree[0], closed[0], count[0],
                                     knot_count[0], u_knots) ||
                       is_wrong_axis(problem, "v_knots", "count[1]", degree[1], closed[1], count[1],
                                     knot_count[1], v_knots) ||
                       (count[0] <= BAT_POINTS_MAX / count[1] &&
                        is_wrong_point(problem, count[0], count[1], 3, points)));
    return finish(problem, status, said);
}
