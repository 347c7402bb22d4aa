/* Any bytes as a SURFACE. A surface that can be read gives finite points within its box, iso-curves that lie
 * on it, and the same surface when written and read again. */
#include <batten/bezier.h>
#include <batten/check.h>
#include <batten/format.h>
#include <batten/sweep.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check_place(const bat_surface *s, double u, double v, const double low[3], const double high[3]) {
    double at[18], grid[18], normal[3], gauss, mean, on_line[3], reach = bat_surface_size(s);
    bat_curve *line = NULL;
    bat_surface_eval(s, u, v, 0, at);
    for (int c = 0; c < 3; c++) reach = fmax(reach, fmax(fabs(low[c]), fabs(high[c])));
    for (int c = 0; c < 3; c++)
        if (!(at[c] >= low[c] - 1e-9 * reach && at[c] <= high[c] + 1e-9 * reach)) abort();
    if (bat_surface_eval_grid(s, 1, &u, 1, &v, 0, grid) != BAT_OK) abort();
    if (bat_surface_normal_grid(s, 1, &u, 1, &v, grid, grid + 3) != BAT_OK) abort();
    const double length = hypot(hypot(grid[3], grid[4]), grid[5]);
    if (!(length == 0 || fabs(length - 1) < 1e-12)) abort();
    if (bat_surface_isocurve(s, BAT_U, u, &line) == BAT_OK) {
        bat_curve_eval(line, v, 0, on_line);
        if (memcmp(on_line, at, sizeof on_line) != 0) abort();
        bat_curve_free(line);
    }
    if (bat_surface_normal(s, u, v, normal) == BAT_OK) {
        if (!(fabs(hypot(hypot(normal[0], normal[1]), normal[2]) - 1) < 1e-12)) abort();
        if (bat_surface_curvature(s, u, v, &gauss, &mean) != BAT_OK) abort();
    }
}

/* The closest point is no farther than any point of the surface, and no hit of a ray is nearer than the
 * closest point. */
static void check_search(const bat_surface *s, double u, double v) {
    const double size = bat_surface_size(s);
    double at[3], from[3], way[3], far = size;
    bat_surface_point near, hit[16];
    size_t count = 0;
    bat_surface_eval(s, u, v, 0, at);
    for (int c = 0; c < 3; c++) {
        from[c] = at[c] + size * (c == 2 ? 1.5 : 0.25), way[c] = at[c] - from[c];
        far = fmax(far, fabs(at[c]));
    }
    bat_surface_finder *finder = NULL;
    if (bat_surface_finder_create(s, &finder) == BAT_OK) {
        bat_surface_finder_nearest(finder, from, &near);
        bat_surface_finder_hits(finder, from, way, 16, hit, &count);
    }
    bat_surface_finder_free(finder);
    if (bat_surface_nearest(s, from, &near) != BAT_OK) return; /* beyond the range of numbers */
    const double distance = hypot(hypot(way[0], way[1]), way[2]);
    if (!(near.distance <= distance + 1e-9 * far)) abort();
    if (bat_surface_hits(s, from, way, 16, hit, &count) != BAT_OK) return;
    for (size_t i = 0; i < count && i < 16; i++)
        if (!(hit[i].distance >= near.distance - 1e-6 * far)) abort();
}

/* Finite vertices, unit normals, and triangles between vertices that exist; an update changes nothing. */
static void check_triangles(const bat_surface *s) {
    bat_tessellate_options options;
    bat_tessellate_options_init(&options, sizeof options);
    options.triangles_max = 5000;
    bat_tessellation *t = NULL;
    bat_tessellate_report report;
    bat_mesh m;
    double domain[2];
    if (bat_surface_tessellate(s, &options, &t, &report) != BAT_OK) return;
    bat_surface_domain(s, BAT_U, domain);
    if (bat_tessellation_update(t, s, BAT_U, domain, NULL) != BAT_OK) abort();
    bat_tessellation_mesh(t, &m);
    if (m.triangle_count > 5000) abort();
    for (size_t i = 0; i < m.rows * m.columns; i++) {
        const double *n = m.normals + 3 * i, *p = m.points + 3 * i;
        if (!(fabs(hypot(hypot(n[0], n[1]), n[2]) - 1) < 1e-12) || !isfinite(p[0] + p[1] + p[2])) abort();
    }
    for (size_t i = 0; i < 3 * m.triangle_count; i++)
        if (m.triangles[i] < 0 || (size_t)m.triangles[i] >= m.rows * m.columns) abort();
    bat_tessellation_free(t);
}

static void check_finer(const bat_surface *s, bat_direction d, double at) {
    bat_surface *fine = NULL, *same = NULL;
    if (bat_surface_insert_knots(s, d, 1, &at, &fine) != BAT_OK) return;
    if (bat_surface_refine(s, d, bat_surface_knot_count(fine, d), bat_surface_knots(fine, d), &same) ==
            BAT_OK &&
        bat_surface_count(same, d) != bat_surface_count(fine, d))
        abort();
    bat_surface_free(fine);
    bat_surface_free(same);
}

/* Either the line becomes what was asked for, or the surface stays unchanged. */
static void check_redraw(const bat_surface *s, bat_direction d, double at, double other) {
    bat_curve *line = NULL;
    bat_surface *made = NULL;
    bat_surface_redraw_report report;
    bat_surface_redraw_options options;
    bat_surface_redraw_options_init(&options, sizeof options);
    double low[3], high[3], reach = 0;
    bat_surface_box(s, low, high);
    for (int c = 0; c < 3; c++) reach = fmax(reach, fmax(fabs(low[c]), fabs(high[c])));
    if (bat_surface_isocurve(s, d, other, &line) == BAT_OK) {
        const bat_status status = bat_surface_redraw(s, d, at, line, &options, &made, NULL, &report);
        if ((status == BAT_OK) != (made != NULL)) abort();
        if (made && !(report.line_error <= 1e-9 * reach)) abort();
    }
    bat_curve_free(line);
    bat_surface_free(made);
}

/* Surfaces from some of its lines: what is made is valid, and within reach of them. */
static void check_made(const bat_surface *s, const double *u, double v, const double low[3],
                       const double high[3]) {
    const double origin[3] = {1, 0, 0}, axis[3] = {0, 0, 1};
    bat_curve *line[3] = {NULL};
    bat_surface *made[6] = {NULL};
    double error = 0, apart[4], places[2];
    for (int k = 0; k < 3; k++)
        if (bat_surface_isocurve(s, k < 2 ? BAT_U : BAT_V, k < 2 ? u[k] : v, &line[k]) != BAT_OK)
            line[k] = NULL;
    if (line[0] && line[1] && line[2]) {
        const double size = bat_surface_size(s);
        double fine = 1e-2 * size + 1e-3; /* no more than a few hundred spans */
        for (int c = 0; c < 3; c++) fine += 1e-3 * (fabs(low[c]) + fabs(high[c]));
        const bat_curve *const sides[4] = {line[0], line[1], line[2], line[2]};
        if (bat_surface_revolve(line[0], origin, axis, 5, fine, &made[0], &error) == BAT_OK &&
            !(error <= fine))
            abort();
        if (bat_surface_loft(2, sides, &made[1], places) == BAT_OK && (places[0] != 0 || places[1] != 1))
            abort();
        bat_surface_coons(sides, 2 * size, &made[2], apart);
        bat_surface_blend(s, BAT_SIDE_U0, s, BAT_SIDE_V1, NULL, &made[3]);
        bat_surface_blend_curve(s, BAT_SIDE_V0, line[0], NULL, &made[4]);
        bat_surface_match(s, BAT_SIDE_U0, s, BAT_SIDE_V1, 3, 1, &made[5], NULL);
    }
    for (int k = 0; k < 3; k++) bat_curve_free(line[k]);
    for (int k = 0; k < 6; k++) bat_surface_free(made[k]);
}

static void check(const bat_surface *s) {
    double low[3], high[3], domain[2][2], at[2][3];
    bat_surface_box(s, low, high);
    for (bat_direction d = BAT_U; d <= BAT_V; d++) {
        bat_surface_domain(s, d, domain[d]);
        bat_surface_spread(s, d, 3, at[d]);
        if (bat_surface_degree(s, d) < 1 || bat_surface_count(s, d) < 2) abort();
        check_finer(s, d, at[d][1]);
        check_redraw(s, d, at[d][1], at[d][2]);
    }
    for (int k = 0; k < 9; k++) check_place(s, at[BAT_U][k / 3], at[BAT_V][k % 3], low, high);
    if (bat_surface_count(s, BAT_U) * bat_surface_count(s, BAT_V) <= 40)
        check_search(s, at[BAT_U][1], at[BAT_V][1]);
    check_made(s, at[BAT_U], at[BAT_V][1], low, high);
    if (bat_surface_count(s, BAT_U) * bat_surface_count(s, BAT_V) <= 40) check_triangles(s);
    const double matrix[12] = {0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0};
    bat_surface *other = NULL;
    if (bat_surface_transform(s, matrix, &other) != BAT_OK) abort();
    bat_surface_free(other);
    char *text = NULL;
    size_t size;
    if (bat_surface_copy(s, &other) != BAT_OK || !bat_surface_is_equal(s, other)) abort();
    bat_surface_free(other);
    if (bat_surface_write(s, &text, &size) != BAT_OK || bat_surface_read(text, size, &other, NULL) != BAT_OK)
        abort();
    if (bat_surface_is_closed(s, BAT_U) != bat_surface_is_closed(other, BAT_U) ||
        memcmp(bat_surface_row(s, 0), bat_surface_row(other, 0), 3 * sizeof(double)) != 0)
        abort();
    bat_free(text);
    bat_surface_free(other);
}

/* The reader checks what it passes to bat_surface_create; here raw bytes are passed. */
static void check_create(const uint8_t *data, size_t size) {
    double numbers[3 * 9 + 6 + 6];
    if (size < sizeof numbers) return;
    memcpy(numbers, data, sizeof numbers);
    bat_surface *s = NULL;
    const bat_status status = bat_surface_create((const int[2]){2, 2}, (const bool[2]){false, false},
                                                 (const size_t[2]){3, 3}, numbers, (const int[2]){6, 6},
                                                 numbers + 27, numbers + 33, &s);
    if (status == BAT_OK) check(s);
    bat_surface_free(s);
    bat_problem problem = {"", ""};
    if (bat_surface_check((const int[2]){2, 2}, (const bool[2]){false, false}, (const size_t[2]){3, 3},
                          numbers, (const int[2]){6, 6}, numbers + 27, numbers + 33, &problem) != status ||
        (status != BAT_OK) != (problem.message[0] != 0))
        abort();
    bat_curve *c = NULL;
    const bat_status curve = bat_curve_create(3, 2, size & 1, 9, numbers, 12 - 2 * (int)(size & 1),
                                              numbers + 27, &c);
    bat_curve_free(c);
    if (bat_curve_check(3, 2, size & 1, 9, numbers, 12 - 2 * (int)(size & 1), numbers + 27, &problem) !=
        curve)
        abort();
    const bat_status clamped = bat_curve_create_clamped(3, 2, size % 9, numbers, &c);
    if (clamped == BAT_OK) bat_curve_free(c);
    if (bat_curve_clamped_check(3, 2, size % 9, numbers, &problem) != clamped) abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bat_surface *s = NULL;
    bat_problem problem;
    if (bat_surface_read((const char *)data, size, &s, &problem) == BAT_OK) {
        if (bat_surface_count(s, BAT_U) * bat_surface_count(s, BAT_V) <= 2000) check(s);
        bat_surface_free(s);
    } else if (s) {
        abort();
    }
    check_create(data, size);
    return 0;
}
