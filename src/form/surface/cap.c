#include "form/surface/cap.h"
#include "form/surface/surface.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double POINT = 1e-9; /* of the surface's size: a rim no larger is a point */

static bool is_closed_around(const bat_surface *surface, bat_direction around) {
    return bat_surface_is_closed(surface, around) && !bat_surface_is_closed(surface, 1 - around);
}

/* Of a row: its middle, and whether it is a point. */
static bool middle_of(const bat_surface *surface, int row, double middle[3]) {
    const double *points = bat_surface_row(surface, row);
    const size_t count = bat_surface_count(surface, BAT_V);
    double far = 0;
    for (int k = 0; k < 3; k++) middle[k] = 0;
    for (size_t j = 0; j < count; j++)
        for (int k = 0; k < 3; k++) middle[k] += points[3 * j + (size_t)k] / (double)count;
    for (size_t j = 0; j < count; j++)
        for (int k = 0; k < 3; k++) far = fmax(far, fabs(points[3 * j + (size_t)k] - middle[k]));
    return far <= POINT * bat_surface_size(surface);
}

/* Of a surface that is closed along v: which of its ends along u are open; their middles. */
static int find_ends(const bat_surface *surface, bool open[2], double middle[2][3]) {
    const int degree = bat_surface_degree(surface, BAT_U), count = (int)bat_surface_count(surface, BAT_U);
    const double *knots = bat_surface_knots(surface, BAT_U);
    int found = 0;
    for (int end = 0; end < 2; end++) {
        const double *at = knots + (end ? count : 0);
        open[end] = at[0] == at[degree] && !middle_of(surface, end ? count - 1 : 0, middle[end]);
        found += open[end];
    }
    return found;
}

/* Exchanged where need be, so that it is closed along v. */
static bat_status upright(const bat_surface *surface, bat_surface **turned) {
    return is_closed_around(surface, BAT_U) ? bat_surface_transpose(surface, turned)
                                            : bat_surface_copy(surface, turned);
}

int bat_surface_open_ends(const bat_surface *surface) {
    bat_surface *turned = NULL;
    double middle[2][3];
    bool open[2];
    if (!is_closed_around(surface, BAT_U) && !is_closed_around(surface, BAT_V)) return 0;
    if (upright(surface, &turned) != BAT_OK) return 0;
    const int found = find_ends(turned, open, middle);
    bat_surface_free(turned);
    return found;
}

/* `degree` rows on the straight ways between a rim and its middle, which is the last, or with `first` the first of them. */
static void put_rows(const double *rim, size_t count, const double middle[3], int degree, bool first,
                     double *rows) {
    for (int i = 0; i < degree; i++) {
        const double share = (double)(first ? degree - i : i + 1) / degree;
        for (size_t j = 0; j < count; j++)
            for (size_t k = 0; k < 3; k++)
                *rows++ = share == 1 ? middle[k] : rim[3 * j + k] + share * (middle[k] - rim[3 * j + k]);
    }
}

static bat_status add_caps(const bat_surface *s, const bool open[2], double middle[2][3], bat_surface **out) {
    const int degree[2] = {bat_surface_degree(s, BAT_U), bat_surface_degree(s, BAT_V)};
    const size_t rows = bat_surface_count(s, BAT_U), columns = bat_surface_count(s, BAT_V),
                 p = (size_t)degree[0];
    const size_t more = p * ((size_t)open[0] + open[1]), wide = 3 * columns;
    const size_t kept = (size_t)bat_surface_knot_count(s, BAT_U);
    const double *was = bat_surface_knots(s, BAT_U);
    double domain[2];
    bat_surface_domain(s, BAT_U, domain);
    const double step = (domain[1] - domain[0]) / (double)(rows - p); /* as long as a span, in the mean */
    double *points = malloc((rows + more) * wide * sizeof *points);
    double *knots = malloc((kept + more) * sizeof *knots);
    bat_status status = points && knots ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        double *at = points, *knot = knots;
        if (open[0]) {
            put_rows(bat_surface_row(s, 0), columns, middle[0], degree[0], true, at);
            at += p * wide;
            for (size_t i = 0; i <= p; i++) *knot++ = domain[0] - step;
        }
        for (size_t i = 0; i < rows; i++, at += wide)
            memcpy(at, bat_surface_row(s, (int)i), wide * sizeof *at);
        for (size_t i = open[0]; i < kept - open[1]; i++) *knot++ = was[i];
        if (open[1]) {
            put_rows(bat_surface_row(s, (int)rows - 1), columns, middle[1], degree[0], false, at);
            for (size_t i = 0; i <= p; i++) *knot++ = domain[1] + step;
        }
        const bool closed[2] = {false, true};
        const size_t count[2] = {rows + more, columns};
        const int knot_count[2] = {(int)(kept + more), bat_surface_knot_count(s, BAT_V)};
        status = bat_surface_create(degree, closed, count, points, knot_count, knots,
                                    bat_surface_knots(s, BAT_V), out);
    }
    free(points);
    free(knots);
    return status;
}

bat_status bat_surface_cap(const bat_surface *surface, bat_surface **out) {
    bat_surface *turned = NULL, *capped = NULL;
    double middle[2][3];
    bool open[2];
    if (!bat_surface_open_ends(surface)) return BAT_STATE;
    const bool exchange = is_closed_around(surface, BAT_U);
    bat_status status = upright(surface, &turned);
    if (status == BAT_OK) {
        find_ends(turned, open, middle);
        status = add_caps(turned, open, middle, &capped);
    }
    if (status == BAT_OK && exchange) {
        status = bat_surface_transpose(capped, out);
        bat_surface_free(capped);
    } else if (status == BAT_OK) {
        *out = capped;
    }
    bat_surface_free(turned);
    return status;
}
