/* Every call on surfaces survives the failure of any one of its allocations: BAT_MEMORY, outputs untouched, nothing
 * leaked. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/sweep.h>
#include <batten/format_space.h>
#include "support/alloc_fail.h"
#include "support/random_surface.h"

static bat_surface *sheet;
static char *text;
static size_t text_size;

/* What a call made: at most one of each. */
typedef struct made {
    bat_surface *surface;
    bat_curve *curve;
    char *text;
} made;

typedef bat_status operation(made *out);

static bat_status copy(made *out) { return bat_surface_copy(sheet, &out->surface); }
static bat_status transform(made *out) {
    const double matrix[12] = {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0};
    return bat_surface_transform(sheet, matrix, &out->surface);
}
static bat_status line_at_u(made *out) { return bat_surface_isocurve(sheet, BAT_U, 0.5, &out->curve); }
static bat_status line_at_v(made *out) { return bat_surface_isocurve(sheet, BAT_V, 0.5, &out->curve); }
static bat_status insert(bat_direction d, made *out) {
    double domain[2];
    bat_surface_domain(sheet, d, domain);
    const double at = 0.4 * domain[0] + 0.6 * domain[1];
    return bat_surface_insert_knots(sheet, d, 1, &at, &out->surface);
}
static bat_status insert_u(made *out) { return insert(BAT_U, out); }
static bat_status insert_v(made *out) { return insert(BAT_V, out); }
static bat_status refine(made *out) {
    return bat_surface_refine(sheet, BAT_U, bat_surface_knot_count(sheet, BAT_U),
                              bat_surface_knots(sheet, BAT_U), &out->surface);
}
static bat_status grid(made *out) {
    const double at[2] = {0, 1};
    double values[4 * 18];
    (void)out;
    return bat_surface_eval_grid(sheet, 2, at, 2, at, 2, values);
}
static bat_status normal_grid(made *out) {
    const double at[2] = {0, 1};
    double values[12];
    (void)out;
    return bat_surface_normal_grid(sheet, 2, at, 2, at, NULL, values);
}
static bat_status tessellate(made *out) {
    const bat_tessellate_options options = {.size = sizeof options, .angle = 0.1};
    const double moved[2] = {0, 0.5};
    bat_tessellation *t = NULL;
    (void)out;
    bat_status status = bat_surface_tessellate(sheet, &options, &t, NULL);
    if (status == BAT_OK) status = bat_tessellation_update(t, sheet, BAT_V, moved, NULL);
    bat_tessellation_free(t);
    return status;
}
static bat_status nearest(made *out) {
    bat_surface_point near;
    (void)out;
    return bat_surface_nearest(sheet, (const double[3]){1, 2, 3}, &near);
}
static bat_status hits(made *out) {
    double at[3];
    size_t count;
    (void)out;
    bat_surface_eval(sheet, 0.3, 0.4, 0, at);
    return bat_surface_hits(sheet, (const double[3]){30, 0, 0}, (const double[3]){at[0] - 30, at[1], at[2]},
                            0, NULL, &count);
}
static bat_status redraw(made *out) {
    bat_curve *line = NULL;
    bat_status status = bat_surface_isocurve(sheet, BAT_V, 0.5, &line);
    if (status == BAT_OK)
        status = bat_surface_redraw(sheet, BAT_V, 0.5, line, NULL, &out->surface, NULL, NULL);
    bat_curve_free(line);
    return status;
}
static bat_status revolve(made *out) {
    bat_curve *line = NULL;
    bat_status status = bat_surface_isocurve(sheet, BAT_U, 0.5, &line);
    if (status == BAT_OK)
        status = bat_surface_revolve(line, (const double[3]){90, 0, 0}, (const double[3]){0, 1, 0}, 1, 0.1,
                                     &out->surface, NULL);
    bat_curve_free(line);
    return status;
}
static bat_status from_lines(bool lofted, bat_direction d, made *out) {
    bat_curve *line[2] = {NULL, NULL};
    double domain[2];
    bat_surface_domain(sheet, d, domain);
    const double width = domain[1] - domain[0];
    bat_status status = bat_surface_isocurve(sheet, d, domain[0] + 0.2 * width, &line[0]);
    if (status == BAT_OK) status = bat_surface_isocurve(sheet, d, domain[0] + 0.8 * width, &line[1]);
    const bat_curve *const sides[4] = {line[0], line[1], line[0], line[1]};
    if (status == BAT_OK)
        status = lofted ? bat_surface_loft(2, sides, &out->surface, NULL)
                        : bat_surface_coons(sides, 1e9, &out->surface, NULL);
    bat_curve_free(line[0]), bat_curve_free(line[1]);
    return status;
}
static bat_status loft_closed(made *out) { return from_lines(true, BAT_V, out); }
static bat_status loft_open(made *out) { return from_lines(true, BAT_U, out); }
static bat_status coons(made *out) { return from_lines(false, BAT_U, out); }
/* Round a closed path, with functions of their own: everything that a sweep allocates. */
static bat_status sweep(made *out) {
    static const char source[] = "{\"path\":{\"degree\":3,\"closed\":true,\"knots\":[0,1,2,3,4],\"points\":[["
                                 "9,0,0],[0,8,1],[-7,0,0],[0,-8,2]]},"
                                 "\"profile\":{\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[-1,0],[1,0]]},"
                                 "\"twist\":{\"degree\":2,\"knots\":[0,0,0,1,1,1],\"values\":[0,2,0]},"
                                 "\"scale\":{\"degree\":1,\"knots\":[0,0,1,1],"
                                 "\"values\":[1,0.5]}}";
    bat_sweep_source read;
    bat_status status = bat_sweep_read(source, sizeof source - 1, &read, NULL);
    if (status != BAT_OK) return status;
    bat_sweep *made_of = NULL;
    size_t folds = 0;
    status = bat_sweep_create(read.path, read.profile, &read.options, &made_of);
    if (status == BAT_OK) status = bat_sweep_folds(made_of, 0, NULL, &folds);
    if (status == BAT_OK) status = bat_sweep_surface(made_of, 0.01, &out->surface, NULL);
    bat_sweep_free(made_of);
    bat_sweep_source_clear(&read);
    return status;
}
static bat_status write_text(made *out) {
    size_t size;
    return bat_surface_write(sheet, &out->text, &size);
}
static bat_status read_text(made *out) { return bat_surface_read(text, text_size, &out->surface, NULL); }

static void each_allocation(void **state) {
    (void)state;
    static operation *const operations[] = {redraw,    nearest,    hits,        copy,       transform,
                                            line_at_u, line_at_v,  insert_u,    insert_v,   refine,
                                            grid,      write_text, read_text,   revolve,    loft_closed,
                                            loft_open, coons,      normal_grid, tessellate, sweep};
    random_source r = {3};
    sheet = random_surface(&r, (const int[2]){3, 2}, (const int[2]){2, 1}, (const int[2]){5, 4});
    assert_int_equal(bat_surface_write(sheet, &text, &text_size), BAT_OK);
    for (size_t i = 0; i < sizeof operations / sizeof *operations; i++) {
        const long before = alloc_live();
        for (long n = 1;; n++) {
            made out = {NULL, NULL, NULL};
            alloc_fail_at(n);
            const bat_status status = operations[i](&out);
            const bool reached = alloc_fail_reached();
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            if (reached) assert_true(!out.surface && !out.curve && !out.text);
            bat_surface_free(out.surface);
            bat_curve_free(out.curve);
            bat_free(out.text);
            assert_int_equal(alloc_live(), before);
            if (!reached) {
                assert_true(n > 1);
                break;
            }
        }
    }
    bat_free(text);
    bat_surface_free(sheet);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_allocation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
