/* Nodes of outlines are merged where the curve stays within the bound: fewer knots, never a shape that is farther off,
 * corners where they were. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "curve/curve.h"
#include "support/random_curve.h"
#include "support/xml.h"

enum { ROOM = 60000 };

static bat_document *read_with(const char *path, const bat_svg_options *options) {
    static char text[ROOM + 200];
    snprintf(
        text, sizeof text,
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1000 1000'><path d='%s' stroke='#000'/></svg>",
        path);
    bat_document *document = NULL;
    bat_svg_report report;
    bat_problem problem;
    if (xml_read(text, options, &document, &report, &problem) != BAT_OK) fail_msg("%s", problem.message);
    return document;
}

static const bat_curve *curve_of(const bat_document *document) {
    return bat_object_curve(bat_document_at(document, 0), 0);
}

/* The greatest distance, both ways, of places on the curves. */
static double apart(const bat_curve *a, const bat_curve *b) {
    double worst = 0;
    for (int way = 0; way < 2; way++) {
        const bat_curve *from = way ? b : a, *to = way ? a : b;
        double domain[2], at[2];
        bat_curve_domain(from, domain);
        for (int i = 0; i <= 160; i++) {
            bat_near near;
            bat_curve_eval(from, domain[0] + (domain[1] - domain[0]) * i / 160, 0, at);
            assert_int_equal(bat_curve_nearest(to, at, &near), BAT_OK);
            worst = fmax(worst, near.distance);
        }
    }
    return worst;
}

/* A wavy line, closed or open, in many short cubics whose numbers are rounded to so many places. */
static void wavy_path(char *out, int pieces, bool closed, double size, int places) {
    size_t used = 0;
    for (int i = 0; i <= pieces; i++) {
        double p[3][2], t[2] = {(double)(i - 1) / pieces, (double)i / pieces};
        for (int side = 0; side < 2; side++) {
            double w = 6.283185307179586 * t[side];
            double r = size * (1 + 0.3 * cos(3 * w)), slope = -0.9 * size * sin(3 * w);
            double x = closed ? r * cos(w) : size * t[side] * 3,
                   y = closed ? r * sin(w) : 0.3 * size * sin(2 * w);
            double dx = closed ? slope * cos(w) - r * sin(w) : size * 3 / 6.283185307179586;
            double dy = closed ? slope * sin(w) + r * cos(w) : 0.6 * size * cos(2 * w);
            double third = 6.283185307179586 / pieces / 3 * (side ? -1 : 1);
            p[side ? 1 : 0][0] = x + third * dx, p[side ? 1 : 0][1] = y + third * dy;
            p[2][0] = x, p[2][1] = y;
        }
        used += i ? (size_t)snprintf(out + used, ROOM - used, "C%.*f %.*f %.*f %.*f %.*f %.*f", places,
                                     p[0][0], places, p[0][1], places, p[1][0], places, p[1][1], places,
                                     p[2][0], places, p[2][1])
                  : (size_t)snprintf(out, ROOM, "M%.*f %.*f", places, p[2][0], places, p[2][1]);
    }
    if (closed) snprintf(out + used, ROOM - used, "Z");
}

/* The curve between two smooth nodes of four decimals needs neither of them: two fifths of the points stay at most. */
static void nodes_of_a_smooth_outline_merge(void **state) {
    (void)state;
    static char path[ROOM];
    const bat_svg_options merging = bat_svg_merging();
    for (int closed = 0; closed < 2; closed++) {
        wavy_path(path, 160, closed, 150, 4);
        bat_document *plain = read_with(path, NULL), *merged = read_with(path, &merging);
        int before = bat_point_count(curve_of(plain)), after = bat_point_count(curve_of(merged));
        if (!(after * 5 <= before * 2)) fail_msg("%d points, %d before", after, before);
        assert_int_equal(bat_curve_is_closed(curve_of(merged)), closed);
        assert_true(apart(curve_of(plain), curve_of(merged)) <= 1.001e-3);
        bat_document_free(plain);
        bat_document_free(merged);
    }
}

/* A path a thousandth as large, with numbers as fine as it needs: the bound shrinks along. */
static void small_paths_keep_their_shape(void **state) {
    (void)state;
    static char path[ROOM];
    const bat_svg_options merging = bat_svg_merging();
    for (double size = 0.02; size < 300; size *= 4) {
        wavy_path(path, 40, true, size, 9);
        bat_document *plain = read_with(path, NULL), *merged = read_with(path, &merging);
        double most = fmin(1e-3, 1e-4 * 2.6 * size);
        assert_true(apart(curve_of(plain), curve_of(merged)) <= most * 1.001);
        bat_document_free(plain);
        bat_document_free(merged);
    }
}

static int corners(const bat_curve *curve, double angle) {
    double domain[2], a[4], b[4];
    const double *knots = bat_curve_knots(curve);
    int found = 0;
    bat_curve_domain(curve, domain);
    for (int i = 0; i < bat_curve_knot_count(curve); i++) {
        bool closed = bat_curve_is_closed(curve);
        if (i && knots[i] == knots[i - 1]) continue;
        if (closed ? knots[i] < domain[0] || knots[i] >= domain[1]
                   : knots[i] <= domain[0] || knots[i] >= domain[1])
            continue;
        bat_curve_eval_left(curve, knots[i] == domain[0] ? domain[1] : knots[i], 1, a);
        bat_curve_eval(curve, knots[i], 1, b);
        double turn = fabs(atan2(a[2] * b[3] - a[3] * b[2], a[2] * b[2] + a[3] * b[3]));
        found += turn > angle;
    }
    return found;
}

/* Stars whose corners are blunt, tiny and sharp: each is there afterwards, to the bit where it was. */
static void corners_stay(void **state) {
    (void)state;
    static char path[ROOM];
    const bat_svg_options merging = bat_svg_merging();
    for (int spikes = 3; spikes < 40; spikes += 4)
        for (int depth = 0; depth < 3; depth++) {
            size_t used = 0;
            for (int i = 0; i < 2 * spikes; i++) {
                double w = 3.141592653589793 * i / spikes, r = i % 2 ? 100 * (0.45 + 0.2 * depth) : 100;
                used += (size_t)snprintf(path + used, ROOM - used, "%s%.3f %.3f", i ? "L" : "M",
                                         200 + r * cos(w), 200 + r * sin(w));
            }
            snprintf(path + used, ROOM - used, "Z");
            bat_document *plain = read_with(path, NULL), *merged = read_with(path, &merging);
            int sharp = corners(curve_of(plain), 0.06);
            assert_int_equal(corners(curve_of(merged), 0.06), sharp);
            assert_int_equal(sharp, 2 * spikes);
            assert_true(apart(curve_of(plain), curve_of(merged)) < 1e-9);
            bat_document_free(plain);
            bat_document_free(merged);
        }
}

/* Random curves as files have them: never further off than the bound. */
static void never_further_off(void **state) {
    (void)state;
    random_source r = {8};
    const bat_svg_options merging = bat_svg_merging();
    for (int round = 0; round < 90; round++) {
        bat_curve *curve = random_curve(&r, 1 + round % 4, 2, round % 3, 1 + round % 12);
        bat_style style = bat_style_defaults();
        bat_object *object = NULL;
        bat_document *document = NULL, *plain = NULL, *merged = NULL;
        char *text = NULL;
        size_t size;
        bat_svg_report report;
        bat_problem problem;
        bat_document_create(&document);
        assert_int_equal(bat_object_create_path(1, "c", &style, 1, &curve, &object), BAT_OK);
        assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
        bat_object_release(object);
        assert_int_equal(bat_svg_write(document, false, &text, &size), BAT_OK);
        assert_int_equal(xml_read(text, NULL, &plain, &report, &problem), BAT_OK);
        assert_int_equal(xml_read(text, &merging, &merged, &report, &problem), BAT_OK);
        assert_true(bat_point_count(curve_of(merged)) <= bat_point_count(curve_of(plain)));
        assert_true(apart(curve_of(plain), curve_of(merged)) <= 1.001e-3);
        bat_free(text);
        bat_document_free(document);
        bat_document_free(plain);
        bat_document_free(merged);
    }
}

static void bad_options(void **state) {
    (void)state;
    bat_svg_reader *reader = NULL;
    const double bad[] = {-1, NAN, -INFINITY};
    for (int i = 0; i < 3; i++) {
        bat_svg_options options = bat_svg_merging();
        options.share = bad[i];
        assert_int_equal(bat_svg_reader_create(&options, &reader), BAT_ARGUMENT);
    }
    assert_null(reader);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nodes_of_a_smooth_outline_merge),
        cmocka_unit_test(small_paths_keep_their_shape),
        cmocka_unit_test(corners_stay),
        cmocka_unit_test(never_further_off),
        cmocka_unit_test(bad_options),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
