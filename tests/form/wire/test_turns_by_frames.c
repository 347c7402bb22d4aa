/* Wires that turn by frames: rigid motions of a wire carry what is close to it rigidly; plane wires turn as their tangents
 * do, also past inflections and round loops; which end comes first does not matter; straight wires have no twist; a twist
 * of space is followed, which tangents know nothing of; the best rigid fit against a search; failing allocations. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/curve.h>
#include <batten/format.h>
#include <batten/nearest.h>
#include <batten/wires.h>
#include <batten/format_space.h>
#include "form/wire/turner.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { POINTS = 150 };

/* ---- helpers ---- */

static bat_curve *curve_of(bool closed, int dimension, int count, const double *points) {
    double knots[32];
    bat_curve *out = NULL;
    for (int i = 0; i <= count; i++) knots[i] = i;
    assert_int_equal(closed
                         ? bat_curve_create(dimension, 3, true, (size_t)count, points, count + 1, knots, &out)
                         : bat_curve_create_clamped(dimension, 3, (size_t)count, points, &out),
                     BAT_OK);
    return out;
}

static bat_curve *random_wire(random_source *r, bool closed) {
    double points[30];
    const int count = random_int(r, 5, 10);
    for (int i = 0; i < 3 * count; i++) points[i] = random_between(r, -10, 10);
    return curve_of(closed, 3, count, points);
}

static vec direction(random_source *r) {
    const double z = random_between(r, -1, 1), angle = random_between(r, 0, 6.28), w = sqrt(1 - z * z);
    return (vec){w * cos(angle), w * sin(angle), z};
}

/* v turned about the unit axis. */
static vec turned(vec v, vec axis, double angle) {
    const vec along = vec_scale(axis, vec_dot(axis, v));
    return vec_add(vec_add(along, vec_scale(vec_sub(v, along), cos(angle))),
                   vec_scale(vec_cross(axis, v), sin(angle)));
}

static void motion(vec axis, double angle, vec shift, double out[12]) {
    for (int column = 0; column < 3; column++) {
        const vec e = {column == 0, column == 1, column == 2}, image = turned(e, axis, angle);
        out[column] = image.x, out[4 + column] = image.y, out[8 + column] = image.z;
    }
    out[3] = shift.x, out[7] = shift.y, out[11] = shift.z;
}

static vec at(const bat_curve *curve, double u) {
    double p[3] = {0};
    bat_curve_eval(curve, u, 0, p);
    return vec_load(p, bat_curve_dimension(curve));
}

/* Points beside the curve, and how far along it each is. */
static void strew(random_source *r, const bat_curve *curve, double far, double *points) {
    double domain[2];
    bat_curve_domain(curve, domain);
    for (int i = 0; i < POINTS; i++) {
        const double u = random_between(r, domain[0], domain[1]), away = random_between(r, 0, far);
        const vec side = direction(r);
        vec_store(vec_add(at(curve, u), vec_scale(side, away)), points + 3 * i);
    }
}

static void apply(const bat_curve *reference, const bat_curve *wire, bat_wire_turn turn, double radius,
                  double *points, bat_wire_report *report) {
    const bat_wire one = {reference, bat_function_of(radius), bat_function_of(1), NULL, turn};
    bat_binding *b = NULL;
    assert_int_equal(bat_wires_bind(1, &one, POINTS, points, NULL, &b, NULL), BAT_OK);
    assert_int_equal(bat_binding_apply(b, &wire, points, report, NULL), BAT_OK);
    bat_binding_free(b);
}

static double worst(const double *a, const double *b) {
    double most = 0;
    for (int i = 0; i < POINTS; i++)
        most = fmax(most, vec_norm(vec_sub(vec_load(a + 3 * i, 3), vec_load(b + 3 * i, 3))));
    return most;
}

/* ---- rigid motions ---- */

/* A point at strength F has taken the part F of the motion: its arm is turned by F times the angle about the motion's own
 * axis. Where F is 1 this is the motion itself. */
static void a_rigid_motion_is_followed(void **state) {
    (void)state;
    random_source r = {61};
    for (int run = 0; run < 60; run++) {
        bat_curve *reference = random_wire(&r, run % 2), *wire = NULL;
        const vec axis = direction(&r);
        const double angle = random_between(&r, 0.1, 3), x = random_between(&r, -9, 9);
        const vec shift = {x, 4, 5};
        double matrix[12], points[3 * POINTS], moved[3 * POINTS];
        bat_finder *finder = NULL;
        motion(axis, angle, shift, matrix);
        assert_int_equal(bat_curve_transform(reference, matrix, &wire), BAT_OK);
        assert_int_equal(bat_finder_create(reference, &finder), BAT_OK);
        strew(&r, reference, run < 30 ? 1 : 1e-5, points);
        memcpy(moved, points, sizeof moved);
        apply(reference, wire, BAT_TURN_FRAMES, 2, moved, NULL);
        for (int i = 0; i < POINTS; i++) {
            bat_near near;
            bat_finder_nearest(finder, points + 3 * i, &near);
            const double y = near.distance / 2, f = (y * y - 1) * (y * y - 1);
            const vec p = vec_load(points + 3 * i, 3), foot = at(reference, near.u), arm = vec_sub(p, foot);
            const vec want = vec_add(vec_add(foot, turned(arm, axis, f * angle)),
                                     vec_scale(vec_sub(at(wire, near.u), foot), f));
            assert_true(vec_norm(vec_sub(want, vec_load(moved + 3 * i, 3))) <= 1e-9);
            const vec whole = vec_add(turned(p, axis, angle), shift);
            if (run >= 30) assert_true(vec_norm(vec_sub(whole, vec_load(moved + 3 * i, 3))) <= 1e-8);
        }
        bat_finder_free(finder);
        bat_curve_free(reference), bat_curve_free(wire);
    }
}

/* With a radius so large that F is 1 to the last digits, all that is bound is moved rigidly; by tangents it is not. */
static void a_tube_is_carried(void **state) {
    (void)state;
    random_source r = {62};
    double tangents = 0;
    for (int run = 0; run < 20; run++) {
        bat_curve *reference = random_wire(&r, run % 2), *wire = NULL;
        const vec axis = direction(&r), shift = {7, -3, 2};
        double matrix[12], points[3 * POINTS], want[3 * POINTS], frames[3 * POINTS], plain[3 * POINTS];
        motion(axis, 1.2, shift, matrix);
        assert_int_equal(bat_curve_transform(reference, matrix, &wire), BAT_OK);
        strew(&r, reference, 0.5, points);
        memcpy(frames, points, sizeof points), memcpy(plain, points, sizeof points);
        for (int i = 0; i < POINTS; i++)
            vec_store(vec_add(turned(vec_load(points + 3 * i, 3), axis, 1.2), shift), want + 3 * i);
        apply(reference, wire, BAT_TURN_FRAMES, 1e7, frames, NULL);
        apply(reference, wire, BAT_TURN_TANGENT, 1e7, plain, NULL);
        assert_true(worst(frames, want) <= 1e-9);
        tangents = fmax(tangents, worst(plain, want));
        bat_curve_free(reference), bat_curve_free(wire);
    }
    assert_true(tangents > 0.1);
}

/* ---- in the plane ---- */

/* All turns are about the plane's normal, so both kinds are the same. The wires have inflections, and closed ones go round. */
static void plane_wires_turn_as_their_tangents(void **state) {
    (void)state;
    random_source r = {63};
    for (int run = 0; run < 40; run++) {
        const bool closed = run % 2;
        enum { COUNT = 9 };
        double p[2 * COUNT], q[2 * COUNT], points[3 * POINTS], frames[3 * POINTS], plain[3 * POINTS];
        for (int i = 0; i < COUNT; i++) {
            const double a = 6.2831853 * i / COUNT, wave = i % 2 ? 6 : 9;
            p[2 * i] = closed ? wave * cos(a) : 3 * i, p[2 * i + 1] = closed ? wave * sin(a) : i % 2;
            for (int k = 0; k < 2; k++) q[2 * i + k] = p[2 * i + k] + random_between(&r, -0.8, 0.8);
        }
        bat_curve *reference = curve_of(closed, 2, COUNT, p), *wire = curve_of(closed, 2, COUNT, q);
        strew(&r, reference, 1.5, points);
        memcpy(frames, points, sizeof points), memcpy(plain, points, sizeof points);
        apply(reference, wire, BAT_TURN_FRAMES, 2, frames, NULL);
        apply(reference, wire, BAT_TURN_TANGENT, 2, plain, NULL);
        assert_true(worst(points, plain) > 0.1);
        assert_true(worst(frames, plain) <= 1e-7);
        bat_curve_free(reference), bat_curve_free(wire);
    }
}

/* A line that rolls up into a spiral of a turn and a half: the arms turn by more than half a turn, steadily. */
static void turns_beyond_half_a_turn(void **state) {
    (void)state;
    enum { COUNT = 24 };
    double p[2 * COUNT], q[2 * COUNT], points[3 * POINTS], domain[2];
    for (int i = 0; i < COUNT; i++) {
        const double a = 9.42477796 * i / (COUNT - 1), far = 3 + 0.5 * a;
        p[2 * i] = 1.5 * i, p[2 * i + 1] = 0, q[2 * i] = far * sin(a), q[2 * i + 1] = far - far * cos(a);
    }
    bat_curve *reference = curve_of(false, 2, COUNT, p), *wire = curve_of(false, 2, COUNT, q);
    bat_curve_domain(reference, domain);
    double before = 0, most = 0;
    for (int i = 0; i < POINTS; i++)
        points[3 * i] = 1.5 * (COUNT - 1) * i / (POINTS - 1), points[3 * i + 1] = 1, points[3 * i + 2] = 0;
    apply(reference, wire, BAT_TURN_FRAMES, 2, points, NULL);
    for (int i = 1; i + 1 < POINTS; i++) {
        const double step = vec_norm(vec_sub(vec_load(points + 3 * i + 3, 3), vec_load(points + 3 * i, 3)));
        most = fmax(most, step);
        before += step;
    }
    assert_true(most <= 6 * before / POINTS); /* no place where it jumps */
    bat_curve_free(reference), bat_curve_free(wire);
}

/* A circle that becomes a figure of eight: its tangent no longer goes round, so the frames have to. */
static void a_figure_of_eight(void **state) {
    (void)state;
    enum { COUNT = 16 };
    double p[3 * COUNT], q[3 * COUNT], points[3 * POINTS], way = 0, most = 0;
    for (int i = 0; i < COUNT; i++) {
        const double a = 6.2831853071795865 * i / COUNT;
        p[3 * i] = 10 * cos(a), p[3 * i + 1] = 10 * sin(a), p[3 * i + 2] = 0;
        q[3 * i] = 10 * sin(a), q[3 * i + 1] = 5 * sin(2 * a), q[3 * i + 2] = cos(a);
    }
    bat_curve *reference = curve_of(true, 3, COUNT, p), *wire = curve_of(true, 3, COUNT, q);
    for (int i = 0; i < POINTS; i++) {
        const double a = 6.2831853071795865 * i / POINTS;
        points[3 * i] = 11 * cos(a), points[3 * i + 1] = 11 * sin(a), points[3 * i + 2] = 0;
    }
    apply(reference, wire, BAT_TURN_FRAMES, 2, points, NULL);
    for (int i = 0; i < POINTS; i++) {
        const vec next = vec_load(points + 3 * ((i + 1) % POINTS), 3);
        const double step = vec_norm(vec_sub(next, vec_load(points + 3 * i, 3)));
        way += step / POINTS, most = fmax(most, step);
    }
    assert_true(most <= 4 * way);
    bat_curve_free(reference), bat_curve_free(wire);
}

/* ---- which end comes first; lines ---- */

static bat_curve *reversed(const bat_curve *curve) {
    const size_t count = bat_curve_count(curve);
    double points[30];
    for (size_t i = 0; i < count; i++)
        memcpy(points + 3 * i, bat_curve_points(curve) + 3 * (count - 1 - i), 3 * sizeof *points);
    return curve_of(bat_curve_is_closed(curve), 3, (int)count, points);
}

static bat_curve *shaken(random_source *r, const bat_curve *curve, double most) {
    double points[30];
    const size_t count = bat_curve_count(curve);
    for (size_t i = 0; i < 3 * count; i++)
        points[i] = bat_curve_points(curve)[i] + random_between(r, -most, most);
    return curve_of(bat_curve_is_closed(curve), 3, (int)count, points);
}

static void either_end_may_come_first(void **state) {
    (void)state;
    random_source r = {64};
    for (int run = 0; run < 40; run++) {
        bat_curve *reference = random_wire(&r, run % 2), *wire = shaken(&r, reference, 2);
        bat_curve *back = reversed(reference), *wire_back = reversed(wire);
        double there[3 * POINTS], back_again[3 * POINTS];
        strew(&r, reference, 0.3, there);
        memcpy(back_again, there, sizeof there);
        apply(reference, wire, BAT_TURN_FRAMES, 1, there, NULL);
        apply(back, wire_back, BAT_TURN_FRAMES, 1, back_again, NULL);
        int far = 0;
        for (int i = 0; i < POINTS; i++)
            far += vec_norm(vec_sub(vec_load(there + 3 * i, 3), vec_load(back_again + 3 * i, 3))) > 1e-6;
        assert_true(far <= 1); /* where two places are as close */
        bat_curve_free(reference), bat_curve_free(wire), bat_curve_free(back), bat_curve_free(wire_back);
    }
}

/* No fit knows how a line is turned about itself: the least turn is taken, which is that of the tangents. */
static void lines_have_no_twist(void **state) {
    (void)state;
    random_source r = {65};
    for (int run = 0; run < 20; run++) {
        double p[12], q[12], points[3 * POINTS], frames[3 * POINTS], plain[3 * POINTS];
        const vec from = direction(&r), to = direction(&r);
        for (int i = 0; i < 4; i++)
            vec_store(vec_scale(from, 5 * i), p + 3 * i), vec_store(vec_scale(to, 4 * i), q + 3 * i);
        bat_curve *reference = curve_of(false, 3, 4, p), *wire = curve_of(false, 3, 4, q);
        strew(&r, reference, 2, points);
        memcpy(frames, points, sizeof points), memcpy(plain, points, sizeof points);
        apply(reference, wire, BAT_TURN_FRAMES, 3, frames, NULL);
        apply(reference, wire, BAT_TURN_TANGENT, 3, plain, NULL);
        assert_true(worst(frames, plain) <= 1e-7);
        for (int i = 0; i < 4; i++) vec_store(vec_scale(from, -5 * i), q + 3 * i);
        bat_curve *opposite = curve_of(false, 3, 4, q);
        memcpy(frames, points, sizeof points);
        apply(reference, opposite, BAT_TURN_FRAMES, 1e7, frames, NULL); /* half a turn about some normal */
        for (int i = 0; i < POINTS; i++) {
            const vec a = vec_load(points + 3 * i, 3), b = vec_load(frames + 3 * i, 3);
            assert_true(fabs(vec_norm(vec_reject(a, from)) - vec_norm(vec_reject(b, from))) <= 1e-9);
            if (vec_dot(a, from) > 0 && vec_dot(a, from) < 15)
                assert_true(fabs(vec_dot(a, from) + vec_dot(b, from)) <= 1e-9);
        }
        bat_curve_free(reference), bat_curve_free(wire), bat_curve_free(opposite);
    }
}

/* ---- what stays ---- */

static void the_reference_moves_nothing(void **state) {
    (void)state;
    random_source r = {66};
    for (int run = 0; run < 20; run++) {
        bat_curve *reference = random_wire(&r, run % 2), *finer = NULL;
        double points[3 * POINTS], after[3 * POINTS];
        bat_wire_report report;
        strew(&r, reference, 3, points);
        memcpy(after, points, sizeof points);
        apply(reference, reference, BAT_TURN_FRAMES, 2, after, &report);
        assert_memory_equal(points, after, sizeof points);
        assert_int_equal(report.moved, 0);
        bat_curve_free(reference), bat_curve_free(finer);
    }
}

/* ---- the best fit ---- */

static double misfit(size_t count, const vec *a, const vec *b, quat q) {
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        const vec d = vec_sub(quat_turn(q, a[i]), b[i]);
        sum += vec_dot(d, d);
    }
    return sum;
}

/* No rotation near or far does better. */
static void the_fit_is_the_best(void **state) {
    (void)state;
    random_source r = {67};
    for (int run = 0; run < 40; run++) {
        enum { COUNT = 12 };
        vec a[COUNT], b[COUNT], mean_a = {0, 0, 0}, mean_b = {0, 0, 0};
        const vec axis = direction(&r);
        const double angle = random_between(&r, 0, 3.1);
        for (int i = 0; i < COUNT; i++) {
            const vec away = direction(&r), noise = direction(&r);
            a[i] = vec_scale(away, 5), b[i] = vec_add(turned(a[i], axis, angle), vec_scale(noise, run % 4));
            mean_a = vec_add(mean_a, vec_scale(a[i], 1.0 / COUNT)),
            mean_b = vec_add(mean_b, vec_scale(b[i], 1.0 / COUNT));
        }
        const quat q = bat_rigid_fit(COUNT, a, b);
        for (int i = 0; i < COUNT; i++) a[i] = vec_sub(a[i], mean_a), b[i] = vec_sub(b[i], mean_b);
        const double least = misfit(COUNT, a, b, q);
        assert_true(fabs(quat_norm(q) - 1) < 1e-14);
        if (run % 4 == 0) assert_true(least < 1e-24 * COUNT * 25);
        for (int k = 0; k < 200; k++) {
            const vec other = direction(&r);
            const double by = k % 2 ? random_between(&r, 0, 3.1) : 1e-4;
            assert_true(misfit(COUNT, a, b, quat_mul(quat_exp(vec_scale(other, by)), q)) >= least - 1e-12);
        }
    }
    const vec same[2] = {{1, 2, 3}, {1, 2, 3}};
    assert_true(bat_rigid_fit(2, same, same).w == 1);
}

/* ---- JSON, refusals, failing allocations ---- */

#define SHAPE(z) "{\"degree\":2,\"knots\":[0,0,0,1,1,1],\"points\":[[0,0,0],[2,1," z "],[4,0,0]]}"
static const char WIRES[] = "{\"wires\":[{\"reference\":" SHAPE("0") ",\"curve\":" SHAPE(
    "1") ",\"radius\":2,\"turn\":\"frames\"}]}";

static bat_status work(void) {
    double points[6] = {1, 0, 0, 2, 0.5, 0};
    bat_wires_source source;
    bat_binding *b = NULL;
    bat_status status = bat_wires_read(WIRES, sizeof WIRES - 1, &source, NULL);
    if (status != BAT_OK) return status;
    assert_int_equal(source.wires[0].turn, BAT_TURN_FRAMES);
    status = bat_wires_bind(1, source.wires, 2, points, &source.options, &b, NULL);
    if (status == BAT_OK)
        status = bat_binding_apply(b, (const bat_curve *const *)source.curves, points, NULL, NULL);
    bat_binding_free(b);
    bat_wires_source_clear(&source);
    return status;
}

static void each_allocation(void **state) {
    (void)state;
    const long before = alloc_live();
    for (long n = 1;; n++) {
        alloc_fail_at(n);
        const bat_status status = work();
        const bool reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        assert_int_equal(alloc_live(), before);
        if (!reached) break;
        assert_true(n < 1000);
    }
}

static void refusals(void **state) {
    (void)state;
    static const char other[] = "{\"wires\":[{\"reference\":" SHAPE("0") ",\"curve\":" SHAPE(
        "1") ",\"radius\":2,\"turn\":\"round\"}]}";
    bat_wires_source source;
    bat_problem problem = {.place = ""};
    assert_int_equal(bat_wires_read(other, sizeof other - 1, &source, &problem), BAT_SYNTAX);
    assert_non_null(strstr(problem.message, "\"tangent\" or \"frames\""));
    random_source r = {68};
    bat_curve *curve = random_wire(&r, false);
    const bat_wire wire = {curve, bat_function_of(1), bat_function_of(1), NULL, (bat_wire_turn)2};
    bat_binding *b = NULL;
    double point[3] = {0, 0, 0};
    assert_int_equal(bat_wires_bind(1, &wire, 1, point, NULL, &b, NULL), BAT_ARGUMENT);
    assert_null(b);
    bat_curve_free(curve);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rigid_motion_is_followed),
        cmocka_unit_test(a_tube_is_carried),
        cmocka_unit_test(plane_wires_turn_as_their_tangents),
        cmocka_unit_test(turns_beyond_half_a_turn),
        cmocka_unit_test(a_figure_of_eight),
        cmocka_unit_test(either_end_may_come_first),
        cmocka_unit_test(lines_have_no_twist),
        cmocka_unit_test(the_reference_moves_nothing),
        cmocka_unit_test(the_fit_is_the_best),
        cmocka_unit_test(refusals),
        cmocka_unit_test(each_allocation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
