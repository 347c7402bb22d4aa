/* Any bytes as a RELIEF. One that can be read is the same when written and read again; edits of it leave valid surfaces, or
 * nothing changes; levels come off and on. */
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/relief.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { POINTS = 150 }; /* larger ones take too long */

static const bat_surface *finest(const bat_relief *r) { return bat_relief_surface(r, bat_relief_levels(r)); }

static size_t points_of(const bat_surface *s) {
    return bat_surface_count(s, BAT_U) * bat_surface_count(s, BAT_V);
}

static double reach_of(const bat_surface *s) {
    double low[3], high[3], reach = 0;
    bat_surface_box(s, low, high);
    for (int c = 0; c < 3; c++) reach = fmax(reach, fmax(fabs(low[c]), fabs(high[c])));
    return reach;
}

static void check_valid(const bat_relief *r) {
    for (int j = 0; j <= bat_relief_levels(r); j++)
        if (!isfinite(reach_of(bat_relief_surface(r, j)))) abort();
    for (int j = 1; j <= bat_relief_levels(r); j++) {
        const size_t n = points_of(bat_relief_surface(r, j));
        for (size_t i = 0; i < n; i++) {
            if (bat_relief_source(r, j)[i] < 0 || bat_relief_source(r, j)[i] >= j) abort();
            if (!isfinite(bat_relief_details(r, j)[3 * i + 2])) abort();
        }
        if (!(fabs(bat_relief_gain(r, j)) <= 1e6)) abort();
    }
}

static void check_text(const bat_relief *r) {
    char *text = NULL, *again = NULL;
    size_t size = 0, length = 0;
    bat_relief *back = NULL;
    bat_problem problem;
    if (bat_relief_write(r, &text, &size) != BAT_OK || bat_relief_read(text, size, &back, &problem) != BAT_OK)
        abort();
    if (bat_relief_write(back, &again, &length) != BAT_OK || length != size || memcmp(text, again, size) != 0)
        abort();
    bat_relief_free(back);
    bat_free(text), bat_free(again);
}

/* What is edited is a copy. */
static void check_edits(const bat_relief *relief, int level) {
    bat_relief *r = NULL;
    bat_curve *line = NULL;
    bat_surface_redraw_report report;
    double at[2][3], left = 0;
    const double delta[3] = {1, -2, .5}, matrix[12] = {0, 0, 1, 4, 1, 0, 0, 0, 0, 1, .5, 0};
    const size_t index[2] = {0, points_of(bat_relief_surface(relief, level)) / 2};
    const double deltas[6] = {1, 0, 0, 0, 0, 1};
    for (bat_direction d = BAT_U; d <= BAT_V; d++) bat_surface_spread(finest(relief), d, 3, at[d]);
    if (bat_relief_copy(relief, &r) != BAT_OK) return;
    bat_relief_move(r, level, 2, index, deltas);
    bat_relief_drag(r, level, at[0][1], at[1][2], delta);
    bat_relief_drag_finest(r, level, at[0][1], at[1][1], delta, 1e-3, &left);
    if (bat_surface_isocurve(bat_relief_surface(r, level), BAT_V, at[1][0], &line) == BAT_OK)
        bat_relief_redraw(r, level, BAT_V, at[1][1], line, NULL, NULL, &report);
    bat_curve_free(line);
    if (level > 0) bat_relief_set_muted(r, level, !bat_relief_is_muted(r, level));
    if (level > 0) bat_relief_set_gain(r, level, 1.5);
    check_valid(r);
    if (bat_relief_transform(r, matrix) == BAT_OK) check_valid(r);
    if (points_of(finest(r)) < POINTS / 4 && bat_relief_add_level(r, NULL, NULL, NULL, NULL, NULL) == BAT_OK)
        check_valid(r);
    bat_relief_free(r);
}

static void check_apart(const bat_relief *relief) {
    const bat_surface *s = finest(relief);
    const size_t least[2] = {(size_t)bat_surface_degree(s, BAT_U) + 1,
                             (size_t)bat_surface_degree(s, BAT_V) + 1};
    bat_relief *r = NULL, *down = NULL, *onto = NULL, *plain = NULL;
    if (bat_relief_decompose(s, 1, &r) == BAT_OK) {
        const double reach = reach_of(s);
        for (size_t i = 0; i < bat_surface_count(s, BAT_U); i++) {
            const double *a = bat_surface_row(s, (int)i), *b = bat_surface_row(finest(r), (int)i);
            for (size_t k = 0; k < 3 * bat_surface_count(s, BAT_V); k++)
                if (!(fabs(a[k] - b[k]) <= 1e-6 * reach)) abort(); /* wild knots make large coarse points */
        }
        check_valid(r);
    }
    if (bat_relief_decompose_to(s, 1, least, &down) == BAT_OK) check_valid(down);
    if (bat_relief_create(s, &plain) == BAT_OK && bat_relief_levels(plain) != 0) abort();
    if (r && points_of(s) < POINTS / 2 &&
        bat_relief_copy_levels(r, bat_relief_surface(relief, 0), &onto) == BAT_OK)
        check_valid(onto);
    bat_relief_free(r), bat_relief_free(down), bat_relief_free(plain), bat_relief_free(onto);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bat_relief *relief = NULL;
    bat_problem problem;
    if (size > 6000) return 0;
    if (bat_relief_read((const char *)data, size, &relief, &problem) != BAT_OK) return 0;
    if (points_of(finest(relief)) <= POINTS) {
        check_valid(relief);
        check_text(relief);
        for (int level = 0; level <= bat_relief_levels(relief); level++) check_edits(relief, level);
        check_apart(relief);
    }
    bat_relief_free(relief);
    return 0;
}
