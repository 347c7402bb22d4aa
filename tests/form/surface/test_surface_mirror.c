/* Surfaces that mirror each other, or themselves: however their parameters run the lines are found; a redrawn line takes
 * its image along, exactly; what did not move keeps every bit. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/refine.h>
#include "form/surface/mirror.h"
#include "form/surface/surface.h"
#include "support/alloc_fail.h"
#include "support/random_surface.h"

enum { MOST = 4096 };

/* An axis of any direction; number 0: the plane x = 0. */
static bat_mirror some_mirror(random_source *r, int number) {
    const double angle = random_between(r, 0, 6), x = random_between(r, -5, 5), y = random_between(r, -5, 5);
    if (number == 0) return (bat_mirror){true, {0, 0}, {0, 1}};
    return (bat_mirror){true, {x, y}, {cos(angle), sin(angle)}};
}

static void image_of(const bat_mirror *m, const double p[3], double out[3]) {
    bat_mirror_point(m, p, out);
    out[2] = p[2];
}

static double apart(const double *a, const double *b) {
    return fmax(fmax(fabs(a[0] - b[0]), fabs(a[1] - b[1])), fabs(a[2] - b[2]));
}

/* The surface with one direction run backwards and, where it is closed, begun at another knot, by what the library
 * does with curves along that direction. */
static bat_surface *run_along_v(const bat_surface *s, bool back, int first) {
    bat_surface *made = NULL;
    double points[MOST], knots[MOST];
    const int rows = (int)bat_surface_count(s, BAT_U), n = (int)bat_surface_count(s, BAT_V);
    const bool closed = bat_surface_is_closed(s, BAT_V);
    const double *was = bat_surface_knots(s, BAT_V);
    const int knot_count = bat_surface_knot_count(s, BAT_V), p = bat_surface_degree(s, BAT_V);
    for (int i = 0; i < rows; i++) {
        bat_curve row = bat_surface_stored_row(s,
                                               i + (bat_surface_is_closed(s, BAT_U) ? s->axis[0].degree : 0));
        bat_curve *turned = NULL;
        assert_int_equal(back ? bat_curve_reverse(&row, &turned) : bat_curve_copy(&row, &turned), BAT_OK);
        for (int j = 0; j < n; j++)
            memcpy(points + 3 * (i * n + j), bat_curve_points(turned) + 3 * ((j + first) % n), 24);
        const double *now = bat_curve_knots(turned);
        for (int k = 0; k < knot_count; k++)
            knots[k] = closed && k + first > n ? now[k + first - n] + (was[n] - was[0]) : now[k + first];
        bat_curve_free(turned);
    }
    const int degree[2] = {bat_surface_degree(s, BAT_U), p};
    (void)bat_surface_create(degree, (const bool[2]){bat_surface_is_closed(s, BAT_U), closed},
                             (const size_t[2]){(size_t)rows, (size_t)n}, points,
                             (const int[2]){bat_surface_knot_count(s, BAT_U), knot_count},
                             bat_surface_knots(s, BAT_U), knots, &made);
    return made; /* NULL: a repeated knot at the seam */
}

static bat_surface *transposed(bat_surface *s) {
    bat_surface *made = NULL;
    assert_int_equal(bat_surface_transpose(s, &made), BAT_OK);
    bat_surface_free(s);
    return made;
}

/* The image of a surface, run some way. */
static bat_surface *some_image(random_source *r, const bat_surface *a, const bat_mirror *m) {
    bat_surface *image = NULL, *run;
    assert_int_equal(bat_surface_image(a, m, &image), BAT_OK);
    for (int d = 0; d < 2; d++) {
        const int n = (int)bat_surface_count(image, BAT_V), turn = random_int(r, 0, n - 1);
        const bool back = random_int(r, 0, 1) == 1, closed = bat_surface_is_closed(image, BAT_V);
        run = run_along_v(image, back, closed ? turn : 0);
        if (!run) run = run_along_v(image, back, 0);
        assert_non_null(run);
        bat_surface_free(image);
        image = transposed(run);
    }
    return random_int(r, 0, 1) ? image : transposed(image);
}

/* The way found leads every place to its image. */
static void check_way(random_source *r, const bat_surface *a, const bat_surface *b, const bat_mirror *m,
                      const bat_surface_way *way) {
    for (int k = 0; k < 8; k++) {
        double at[2], there[2] = {NAN, NAN}, p[3], q[3], image[3];
        for (int d = 0; d < 2; d++) at[d] = random_parameter(r, a, d ? BAT_V : BAT_U);
        for (int d = 0; d < 2; d++) {
            bat_direction direction = d ? BAT_V : BAT_U;
            const double value = bat_surface_way_line(way, b, &direction, at[d]);
            there[direction == BAT_V] = value;
        }
        bat_surface_eval(a, at[0], at[1], 0, p);
        bat_surface_eval(b, there[0], there[1], 0, q);
        image_of(m, p, image);
        if (!(apart(q, image) < 1e-6 * bat_surface_size(a)))
            fail_msg("%g away, %d %d, %d %d, %d", apart(q, image), bat_surface_is_closed(a, BAT_U),
                     bat_surface_is_closed(a, BAT_V), way->back[0], way->back[1], way->swap);
    }
}

static void images_are_found_however_they_run(void **state) {
    (void)state;
    random_source r = {3};
    int swapped = 0, back = 0;
    for (int number = 0; number < 200; number++) {
        const bat_mirror m = some_mirror(&r, number % 3);
        bat_surface *a = some_surface(&r, number), *b = some_image(&r, a, &m), *moved = NULL;
        const double within = 1e-9 * bat_surface_size(a);
        bat_surface_way way;
        assert_true(bat_surface_is_image(a, b, &m, within, &way));
        swapped += way.swap, back += way.back[0] + way.back[1];
        check_way(&r, a, b, &m, &way);
        /* not in another plane, and not when a point has gone elsewhere */
        const bat_mirror other = {true, {m.at[0] + 0.1, m.at[1] + 0.2}, {m.along[0], m.along[1]}};
        assert_false(bat_surface_is_image(a, b, &other, within, &way));
        assert_int_equal(bat_surface_copy(b, &moved), BAT_OK);
        bat_surface_own_row(moved, 0)[2] += 4 * within;
        assert_int_equal(bat_surface_finish(moved, &moved), BAT_OK);
        assert_false(bat_surface_is_image(a, moved, &m, within, &way));
        bat_surface_free(a), bat_surface_free(b), bat_surface_free(moved);
    }
    assert_true(swapped > 50 && back > 100);
}

/* The line redrawn at random, on its knots or one more. */
static bat_surface *redrawn(random_source *r, const bat_surface *s, bat_direction d, double at, bool finer,
                            double reach, double far) {
    bat_curve *line = NULL, *more = NULL, *moved = NULL;
    bat_surface *made = NULL;
    bat_surface_redraw_options options = bat_surface_redraw_defaults();
    double domain[2], points[MOST];
    options.reach = reach;
    assert_int_equal(bat_surface_isocurve(s, d, at, &line), BAT_OK);
    bat_curve_domain(line, domain);
    assert_int_equal(bat_curve_insert_knot(line, random_between(r, domain[0], domain[1]), finer, &more),
                     BAT_OK);
    const size_t count = bat_curve_count(more);
    for (size_t i = 0; i < 3 * count; i++) {
        const double step = random_between(r, -far, far);
        points[i] = bat_curve_points(more)[i] + (i / 3 % 3 ? step : 0);
    }
    assert_int_equal(bat_curve_create(3, bat_curve_degree(more), bat_curve_is_closed(more), count, points,
                                      bat_curve_knot_count(more), bat_curve_knots(more), &moved),
                     BAT_OK);
    if (bat_surface_redraw(s, d, at, moved, &options, &made, NULL, NULL) != BAT_OK) made = NULL;
    bat_curve_free(line), bat_curve_free(more), bat_curve_free(moved);
    return made;
}

static void a_twin_follows(void **state) {
    (void)state;
    random_source r = {8};
    int made_ones = 0;
    for (int number = 0; number < 160; number++) {
        const bat_mirror m = some_mirror(&r, number % 3);
        bat_surface *a = some_surface(&r, number), *b = some_image(&r, a, &m), *followed = NULL;
        const bat_direction d = number % 2 ? BAT_V : BAT_U;
        const double at = random_parameter(&r, a, d);
        const bool finer = number % 4 > 1;
        bat_surface *now = redrawn(&r, a, d, at, finer, 0, 1);
        bat_surface_way way, again;
        assert_true(bat_surface_is_image(a, b, &m, 1e-9 * bat_surface_size(a), &way));
        if (now) {
            made_ones++;
            assert_int_equal(bat_surface_follow_image(a, now, b, &m, &way, &followed), BAT_OK);
            check_way(&r, now, followed, &m, &way);
            assert_true(bat_surface_is_image(now, followed, &m, 1e-9 * bat_surface_size(a), &again));
            double was[2], is[2];
            for (int e = 0; e < 2; e++) {
                bat_surface_domain(b, e ? BAT_V : BAT_U, was);
                bat_surface_domain(followed, e ? BAT_V : BAT_U, is);
                assert_true(fabs(was[0] - is[0]) < 1e-9 * (was[1] - was[0]) &&
                            fabs(was[1] - is[1]) < 1e-9 * (was[1] - was[0]));
            }
            size_t kept = 0, stay = 0; /* as many points keep every bit as in the surface itself */
            if (!finer)
                for (int i = 0; i < (int)bat_surface_count(b, BAT_U); i++)
                    for (int j = 0; j < (int)bat_surface_count(b, BAT_V); j++)
                        kept += memcmp(bat_surface_row(b, i) + 3 * j, bat_surface_row(followed, i) + 3 * j,
                                       24) == 0;
            if (!finer)
                for (int i = 0; i < (int)bat_surface_count(a, BAT_U); i++)
                    for (int j = 0; j < (int)bat_surface_count(a, BAT_V); j++)
                        stay += memcmp(bat_surface_row(a, i) + 3 * j, bat_surface_row(now, i) + 3 * j, 24) ==
                                0;
            assert_true(kept >= stay);
        }
        bat_surface_free(a), bat_surface_free(b), bat_surface_free(now), bat_surface_free(followed);
    }
    assert_true(made_ones > 100);
}

/* ---- a surface that is its own image ---- */

/* Knots that are their own image: random steps there, the same steps back. */
static void even_knots(random_source *r, int degree, bool closed, int count, double *knots) {
    const int total = closed ? count + 1 : count + degree + 1, clamp = closed ? 1 : degree + 1;
    double steps[64];
    const int spans = total - 2 * clamp + 1;
    for (int i = 0; i < spans; i++) steps[i] = random_between(r, 0.5, 1.5);
    for (int i = 0; i < spans / 2; i++) steps[spans - 1 - i] = steps[i];
    for (int i = 0; i < clamp; i++) knots[i] = 0;
    for (int i = 0; i < spans; i++) knots[clamp + i] = knots[clamp + i - 1] + steps[i];
    for (int i = 0; i < clamp; i++) knots[total - 1 - i] = knots[clamp + spans - 1];
}

enum { U = 9, V = 8, CASES = 4 };

/* Across u over x from -10 to 10: open, or closed round the plane (case 1), or with its image in v (case 2), or in both (3:
 * u runs back with v). The plane is x = 0. */
static bat_surface *own_image(random_source *r, int number) {
    const bool closed = number % CASES == 1, along = number % CASES == 2, both = number % CASES == 3;
    double points[U * V * 3], ku[64], kv[64];
    for (int i = 0; i < U; i++)
        for (int j = 0; j < V; j++) {
            double *p = points + 3 * (i * V + j);
            const int k = along ? i : closed ? (U + 5 - i) % U : U - 1 - i, l = along || both ? V - 1 - j : j;
            const double angle = 6.283185307179586 * (i - 2.5) / U;
            p[0] = closed ? 10 * sin(angle) : along ? 20.0 * j / (V - 1) - 10 : 20.0 * i / (U - 1) - 10;
            p[1] = (closed ? 10 * cos(angle) : along ? i : j) + random_between(r, -0.5, 0.5);
            p[2] = (closed ? j : 0) + random_between(r, -0.5, 0.5);
            if (k * V + l < i * V + j) {
                const double *q = points + 3 * (k * V + l);
                p[0] = -q[0], p[1] = q[1], p[2] = q[2];
            } else if (k * V + l == i * V + j) {
                p[0] = 0;
            }
        }
    even_knots(r, 3, closed, U, ku);
    even_knots(r, 3, false, V, kv);
    bat_surface *made = NULL;
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){closed, false},
                                        (const size_t[2]){U, V}, points,
                                        (const int[2]){closed ? U + 1 : U + 4, V + 4}, ku, kv, &made),
                     BAT_OK);
    return made;
}

static const bat_mirror plane = {true, {0, 0}, {0, 1}};

static double line_error(const bat_surface *a, const bat_surface *b, bat_direction d, double at) {
    double worst = 0, domain[2], p[3], q[3];
    bat_surface_domain(a, d == BAT_U ? BAT_V : BAT_U, domain);
    for (int k = 0; k <= 50; k++) {
        const double other = domain[0] + (domain[1] - domain[0]) * k / 50;
        bat_surface_eval(a, d == BAT_U ? at : other, d == BAT_U ? other : at, 0, p);
        bat_surface_eval(b, d == BAT_U ? at : other, d == BAT_U ? other : at, 0, q);
        worst = fmax(worst, apart(p, q));
    }
    return worst;
}

/* Any line of any such surface, whatever the reach: its image is redrawn, too, and the line itself is the one drawn. */
static void both_lines_are_redrawn(void **state) {
    (void)state;
    random_source r = {21};
    int overlapping = 0, refused = 0, made_ones = 0;
    for (int number = 0; number < 160; number++) {
        bat_surface *s = own_image(&r, number), *both = NULL;
        bat_surface_way way, again;
        assert_true(bat_surface_is_own_image(s, &plane, 1e-9, &way));
        check_way(&r, s, s, &plane, &way);
        const bat_direction d = number % CASES == 2 ? BAT_V : BAT_U;
        const double at = random_parameter(&r, s, d), reach = random_between(&r, 0.8, 6);
        bat_direction same = d;
        const double image = bat_surface_way_line(&way, s, &same, at);
        bat_surface *one = redrawn(&r, s, d, at, number % 2 == 0, reach, 0.5);
        double gain = 0;
        if (!one) {
            bat_surface_free(s);
            continue;
        }
        const bat_status status = bat_surface_redraw_image(s, one, &plane, &way, d, at, &gain, &both);
        if (status == BAT_OK) {
            made_ones++;
            overlapping += line_error(s, one, d, image) > 1e-3;
            if (!(line_error(one, both, d, at) < 1e-10 * bat_surface_size(s)))
                fail_msg("%d: the line is %g off", number, line_error(one, both, d, at));
            assert_true(bat_surface_is_own_image(both, &plane, 1e-9, &again) && gain <= 4);
            check_way(&r, both, both, &plane, &way);
        } else {
            assert_int_equal(status, BAT_FAR);
            assert_true(gain > 4 || fabs(at - image) < 1e-3);
            refused++;
        }
        bat_surface_free(s), bat_surface_free(one), bat_surface_free(both);
    }
    assert_true(made_ones > 100 && overlapping > 30 && refused > 0);
}

/* Where nothing comes from the other side, it is the redraw and its image, and the rest keeps every bit. */
static void far_lines_do_not_meet(void **state) {
    (void)state;
    random_source r = {22};
    for (int number = 0; number < 20; number++) {
        bat_surface *s = own_image(&r, 0), *both = NULL;
        bat_surface_way way;
        double domain[2], gain = 0;
        assert_true(bat_surface_is_own_image(s, &plane, 1e-9, &way));
        bat_surface_domain(s, BAT_U, domain);
        const double at = domain[0] + random_between(&r, 0, 0.1) * domain[1];
        bat_surface *one = redrawn(&r, s, BAT_U, at, false, 0.7, 1);
        assert_non_null(one);
        assert_int_equal(bat_surface_redraw_image(s, one, &plane, &way, BAT_U, at, &gain, &both), BAT_OK);
        for (int i = 0; i < U; i++) {
            const bool low = memcmp(bat_surface_row(one, i), bat_surface_row(s, i), V * 24) != 0;
            const bool high = memcmp(bat_surface_row(one, U - 1 - i), bat_surface_row(s, U - 1 - i),
                                     V * 24) != 0;
            assert_false(low && high);
            const double *row = bat_surface_row(both, i);
            if (!low && !high) assert_memory_equal(row, bat_surface_row(s, i), V * 24);
            for (int j = 0; j < V && low; j++)
                assert_true(apart(row + 3 * j, bat_surface_row(one, i) + 3 * j) < 1e-13);
        }
        assert_true(gain == 1);
        bat_surface_free(s), bat_surface_free(one), bat_surface_free(both);
    }
}

/* The line in the plane stays in it, and moves within it as the stroke says. */
static void a_line_in_the_plane_stays_there(void **state) {
    (void)state;
    random_source r = {23};
    for (int number = 0; number < 20; number++) {
        bat_surface *s = own_image(&r, 0), *both = NULL;
        bat_surface_way way, again;
        double domain[2], gain = 0, p[3], q[3];
        bat_surface_is_own_image(s, &plane, 1e-9, &way);
        bat_surface_domain(s, BAT_U, domain);
        const double at = 0.5 * (domain[0] + domain[1]);
        bat_surface *one = redrawn(&r, s, BAT_U, at, number % 2, 0, 1);
        assert_int_equal(bat_surface_redraw_image(s, one, &plane, &way, BAT_U, at, &gain, &both), BAT_OK);
        assert_true(bat_surface_is_own_image(both, &plane, 1e-9, &again));
        for (int k = 0; k <= 20; k++) {
            const double v = random_parameter(&r, s, BAT_V);
            bat_surface_eval(one, at, v, 0, p);
            bat_surface_eval(both, at, v, 0, q);
            assert_true(fabs(q[0]) < 1e-12 && fabs(p[1] - q[1]) < 1e-11 && fabs(p[2] - q[2]) < 1e-11);
        }
        bat_surface_free(s), bat_surface_free(one), bat_surface_free(both);
    }
}

/* A line that crosses the plane: what is drawn on one side is found on both. */
static void a_line_across_the_plane_takes_one_side(void **state) {
    (void)state;
    random_source r = {24};
    int made_ones = 0;
    for (int number = 0; number < 40; number++) {
        bat_surface *s = own_image(&r, number % 2), *both = NULL, *one = NULL;
        bat_curve *line = NULL, *moved = NULL;
        bat_surface_way way, again;
        double points[3 * U], gain = 0;
        const int side = number % 4 < 2 ? 1 : -1;
        const double at = random_parameter(&r, s, BAT_V);
        assert_true(bat_surface_is_own_image(s, &plane, 1e-9, &way));
        assert_int_equal(bat_surface_isocurve(s, BAT_V, at, &line), BAT_OK);
        memcpy(points, bat_curve_points(line), sizeof points);
        for (int i = 0; i < U; i++)
            for (int k = 0; k < 3; k++) {
                const double step = random_between(&r, -1, 1);
                if (side * points[3 * i] > 2) points[3 * i + k] += step;
            }
        assert_int_equal(bat_curve_create(3, 3, bat_curve_is_closed(line), U, points,
                                          bat_curve_knot_count(line), bat_curve_knots(line), &moved),
                         BAT_OK);
        if (bat_surface_redraw(s, BAT_V, at, moved, NULL, &one, NULL, NULL) == BAT_OK) {
            assert_int_equal(bat_surface_redraw_image(s, one, &plane, &way, BAT_V, at, &gain, &both), BAT_OK);
            assert_true(bat_surface_is_own_image(both, &plane, 1e-9, &again));
            for (int i = 0; i < U; i++)
                for (int j = 0; j < V; j++) {
                    const double *p = bat_surface_row(s, i) + 3 * j, *q = bat_surface_row(both, i) + 3 * j;
                    if (side * p[0] > 1e-9) assert_true(apart(bat_surface_row(one, i) + 3 * j, q) < 1e-13);
                }
            made_ones++;
        }
        bat_curve_free(line), bat_curve_free(moved);
        bat_surface_free(s), bat_surface_free(one), bat_surface_free(both);
    }
    assert_true(made_ones > 20);
}

/* What lies in the plane, or is no image of itself, is not paired. */
static void others_are_not_paired(void **state) {
    (void)state;
    random_source r = {25};
    bat_surface_way way;
    for (int number = 0; number < 60; number++) {
        bat_surface *s = some_surface(&r, number), *flat = NULL;
        assert_false(bat_surface_is_own_image(s, &plane, 1e-6, &way));
        const double squash[12] = {0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        assert_int_equal(bat_surface_transform(s, squash, &flat), BAT_OK);
        assert_false(bat_surface_is_own_image(flat, &plane, 1e-6, &way));
        bat_surface_free(s), bat_surface_free(flat);
    }
}

static void failed_allocations(void **state) {
    (void)state;
    random_source r = {26};
    for (int number = 0; number < CASES; number++) {
        bat_surface *s = own_image(&r, number), *twin = some_image(&r, s, &plane);
        double domain[2];
        bat_surface_domain(s, BAT_V, domain);
        const double at = 0.9 * domain[0] + 0.1 * domain[1];
        bat_surface *one = redrawn(&r, s, BAT_V, at, true, 0, 0.1);
        bat_surface_way way, other;
        assert_non_null(one);
        assert_true(bat_surface_is_own_image(s, &plane, 1e-9, &way));
        assert_true(bat_surface_is_image(s, twin, &plane, 1e-9, &other));
        for (int call = 0; call < 2; call++)
            for (long n = 1, before = alloc_live();; n++) {
                bat_surface *out = NULL;
                double gain;
                alloc_fail_at(n);
                const bat_status status = call ? bat_surface_follow_image(s, one, twin, &plane, &other, &out)
                                               : bat_surface_redraw_image(s, one, &plane, &way, BAT_V, at,
                                                                          &gain, &out);
                const bool reached = alloc_fail_reached();
                assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
                assert_true((out == NULL) == reached);
                bat_surface_free(out);
                assert_int_equal(alloc_live(), before);
                if (!reached) break;
            }
        bat_surface_free(s), bat_surface_free(twin), bat_surface_free(one);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(images_are_found_however_they_run),
        cmocka_unit_test(a_twin_follows),
        cmocka_unit_test(both_lines_are_redrawn),
        cmocka_unit_test(far_lines_do_not_meet),
        cmocka_unit_test(a_line_in_the_plane_stays_there),
        cmocka_unit_test(a_line_across_the_plane_takes_one_side),
        cmocka_unit_test(others_are_not_paired),
        cmocka_unit_test(failed_allocations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
