/*
 * Offsets of closed curves whose widths or dashes begin at their start: they begin beside it and run the same way, whichever way that
 * is, and holes stay holes; others keep the start that the offset gives them. With any allocation failing.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/alloc_fail.h"
#include "base/real.h"
#include "editor/edit/outlining.h"

#include <batten/measure.h>
#include <batten/paint.h>
#include <batten/refine.h>

#include <math.h>

/* Round a place; turned: the other way round. */
static bat_curve *egg(double x, double size, bool turned) {
    double points[2 * 8];
    bat_curve *made, *back;
    for (int i = 0; i < 8; i++) {
        const double a = i * 0.78539816339744831 + 0.4;
        points[2 * i] = x + size * bat_cos(a) * (i == 2 ? 1.3 : 1);
        points[2 * i + 1] = 0.7 * size * bat_sin(a);
    }
    const double knots[9] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    assert_int_equal(bat_curve_create(2, 3, true, 8, points, 9, knots, &made), BAT_OK);
    if (!turned) return made;
    assert_int_equal(bat_curve_reverse(made, &back), BAT_OK);
    bat_curve_free(made);
    return back;
}

enum { PLAIN, DASHED, SWELLING };

static bat_object *object_of(int count, bat_curve **curves, int kind) {
    static const bat_width_stop stops[] = {{0, 0.5}, {0.4, 3}};
    static const double dashes[] = {5, 3};
    const bat_paint paints[] = {
        [DASHED] = {.dash_count = 2, .dashes = dashes}, [SWELLING] = {.width_count = 2, .widths = stops}};
    bat_style style = bat_style_defaults();
    bat_object *plain = NULL, *painted = NULL;
    assert_int_equal(bat_object_create_path(1, "", &style, count, curves, &plain), BAT_OK);
    if (kind == PLAIN) return plain;
    assert_int_equal(bat_object_with_paint(plain, &paints[kind], &painted), BAT_OK);
    bat_object_release(plain);
    return painted;
}

static void begin_beside(void **state) {
    (void)state;
    for (int way = 0; way < 2; way++)
        for (int side = BAT_OFFSET_OUTSIDE; side <= BAT_OFFSET_INSIDE; side++)
            for (int kind = DASHED; kind <= SWELLING; kind++) {
                bat_curve *curve = egg(0, 100, way == 1);
                double here[4], there[4], domain[2];
                bat_curve_domain(curve, domain);
                bat_curve_eval(curve, domain[0], 1, here);
                bat_object *object = object_of(1, &curve, kind), *out = NULL;
                assert_int_equal(bat_outlining_offset(object, 10, (bat_offset_side)side, &out), BAT_OK);
                assert_int_equal(bat_object_curve_count(out), 1);
                bat_curve_domain(bat_object_curve(out, 0), domain);
                bat_curve_eval(bat_object_curve(out, 0), domain[0], 1, there);
                const double apart = bat_hypot(there[0] - here[0], there[1] - here[1]);
                const double cosine = (here[2] * there[2] + here[3] * there[3]) /
                                      (bat_hypot(here[2], here[3]) * bat_hypot(there[2], there[3]));
                assert_true(fabs(apart - 10) < 0.02 && cosine > 0.999);
                bat_object_release(out);
                bat_object_release(object);
            }
}

static void holes_stay_holes(void **state) {
    (void)state;
    for (int way = 0; way < 4; way++)
        for (int kind = PLAIN; kind <= SWELLING; kind++) {
            bat_curve *curves[2] = {egg(0, 100, way & 1), egg(5, 50, way & 2)};
            bat_object *object = object_of(2, curves, kind), *out = NULL;
            bat_object *ring = NULL;
            bat_style style = *bat_object_style(object);
            style.even_odd = true;
            assert_int_equal(bat_object_with_style(object, &style, &ring), BAT_OK);
            assert_int_equal(bat_outlining_offset(ring, 5, BAT_OFFSET_OUTSIDE, &out), BAT_OK);
            assert_int_equal(bat_object_curve_count(out), 2);
            const double first = bat_curve_area(bat_object_curve(out, 0)),
                         second = bat_curve_area(bat_object_curve(out, 1));
            assert_true(first * second < 0);
            bat_object_release(out);
            bat_object_release(ring);
            bat_object_release(object);
        }
}

static void memory_may_end(void **state) {
    (void)state;
    bat_curve *curve = egg(0, 100, true);
    bat_object *object = object_of(1, &curve, SWELLING);
    const long before = alloc_live();
    for (int n = 1;; n += 1 + n / 16) {
        bat_object *out = NULL;
        alloc_fail_at(n);
        const bat_status status = bat_outlining_offset(object, 10, BAT_OFFSET_BOTH, &out);
        const bool reached = alloc_fail_reached();
        alloc_fail_at(0);
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        bat_object_release(out);
        assert_int_equal(alloc_live(), before);
        if (!reached) break;
    }
    bat_object_release(object);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(begin_beside),
        cmocka_unit_test(holes_stay_holes),
        cmocka_unit_test(memory_may_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
