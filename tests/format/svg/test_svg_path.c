/* Path data, arcs, transforms and basic shapes against closed forms. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "format/svg/svg.h"
#include "format/svg/style.h"
#include "support/random_curve.h"

static bool parse(const char *data, bat_outline *o) {
    bat_outline_clear(o);
    return bat_svg_path(data, strlen(data), o);
}

static void expect(const bat_outline *o, int subpath, int segments, bool closed, const double *points) {
    assert_true(subpath < o->subpath_count);
    const bat_subpath *path = &o->subpaths[subpath];
    assert_int_equal(path->segments, segments);
    assert_int_equal(path->closed, closed);
    for (int i = 0; i < 2 * (3 * segments + 1); i++)
        if (fabs(o->points[2 * path->first + (size_t)i] - points[i]) > 1e-12)
            fail_msg("number %d: %g, not %g", i, o->points[2 * path->first + (size_t)i], points[i]);
}

/* Each pair draws the same: all that is relative, shorthand or glued against plain M, L, C. */
static void commands_agree(void **state) {
    (void)state;
    static const char *const pairs[][2] = {
        {"m1 2 3 4-5 6z", "M1 2L4 6L-1 12Z"},
        {"M1,2h3v-4H0V0", "M1 2L4 2L4 -2L0 -2L0 0"},
        {"M0 0c1 2 3 4 5 6s1 1 2 2", "M0 0C1 2 3 4 5 6C7 8 6 7 7 8"},
        {"M0 0S1 1 2 2", "M0 0C0 0 1 1 2 2"},
        {"M0 0L1 1S1 1 2 2", "M0 0L1 1C1 1 1 1 2 2"},
        {"M3 3q3 0 3 3t3 3", "M3 3C5 3 6 4 6 6C6 8 7 9 9 9"},
        {"M0 0T3 3", "M0 0C0 0 1 1 3 3"},
        {"M.5.5.5-1e1-1-1", "M0.5 0.5L0.5 -10L-1 -1"},
        {"M10 10l5 0zl0 5", "M10 10L15 10L10 10ZM10 10L10 15"},
        {"m5 5zm1 1l1 1", "M6 6L7 7"},
        {"M0 0a2 2 0 01 4 0", "M0 0A2 2 0 0 1 4 0"},
        {"M0 0a1 1 0 00.5.5", "M0 0A1 1 0 0 0 .5 .5"},
        {"M0 0A0 3 0 0 1 2 2", "M0 0L2 2"},               /* an arc of no radius */
        {"M0 0A2 224e-324 3 1 1 2 2", "M0 0L2 2"},        /* or as good as none */
        {"M0 0A1e9 1e9 0 0 1 1e-160 0", "M0 0L1e-160 0"}, /* or of one that dwarfs its chord */
    };
    bat_outline a = {0}, b = {0};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        assert_true(parse(pairs[i][0], &a));
        assert_true(parse(pairs[i][1], &b));
        assert_true(a.subpath_count > 0);
        assert_int_equal(a.subpath_count, b.subpath_count);
        for (int k = 0; k < a.subpath_count; k++)
            expect(&a, k, b.subpaths[k].segments, b.subpaths[k].closed, b.points + 2 * b.subpaths[k].first);
    }
    bat_outline_free(&a);
    bat_outline_free(&b);
}

static void lines_have_handles_at_thirds(void **state) {
    (void)state;
    bat_outline o = {0};
    assert_true(parse("M0 0L3 6", &o));
    const double points[] = {0, 0, 1, 2, 2, 4, 3, 6};
    expect(&o, 0, 1, false, points);
    bat_outline_free(&o);
}

/* What stands before the error stays. */
static void errors_stop_at_the_last_good_segment(void **state) {
    (void)state;
    static const struct {
        const char *data;
        int subpaths, segments;
    } cases[] = {{"M0 0L1 1L2", 1, 1},
                 {"M0 0L1 1X5", 1, 1},
                 {"L1 1", 0, 0},
                 {"0 0", 0, 0},
                 {"M0 0C1 1 2 2 3 3 4", 1, 1},
                 {"M0 0L1 1 1e999 0", 1, 1},
                 {"M0 0A1 1 0 2 0 1 1", 0, 0},
                 {"M0 0L1 1,", 1, 1},
                 {"M0 0L1,,1", 0, 0},
                 {"M0 0L1 1Lnan 0", 1, 1},
                 {"M0 0L1 1L\xff", 1, 1}};
    bat_outline o = {0};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (parse(cases[i].data, &o)) fail_msg("\"%s\" should not parse", cases[i].data);
        assert_int_equal(o.subpath_count, cases[i].subpaths);
        if (cases[i].subpaths) assert_int_equal(o.subpaths[0].segments, cases[i].segments);
    }
    assert_true(parse("", &o));
    assert_true(parse("M5 5", &o));
    assert_int_equal(o.subpath_count, 0);
    bat_outline_free(&o);
}

static void at(const double *p, double t, double out[2]) {
    double s = 1 - t;
    for (int d = 0; d < 2; d++)
        out[d] = s * s * s * p[d] + 3 * s * s * t * p[2 + d] + 3 * s * t * t * p[4 + d] +
                 t * t * t * p[6 + d];
}

/* Points of the arc lie on an ellipse of the asked radii and rotation, whose centre is where the ends say; the turn is
 * above or below half as the flags say, and runs the asked way. */
static void arcs_lie_on_their_ellipse(void **state) {
    (void)state;
    random_source r = {21};
    bat_outline o = {0};
    for (int i = 0; i < 2000; i++) {
        double rx = random_between(&r, 0.5, 20), ry = random_between(&r, 0.5, 20),
               turn = random_between(&r, -400, 400);
        double a = turn * 3.14159265358979323846 / 180, from = random_between(&r, 0, 6.28),
               cx = random_between(&r, -9, 9);
        double sweep = random_between(&r, 0.05, 6.2), cy = random_between(&r, -9, 9);
        bool positive = random_unit(&r) < 0.5;
        double to = positive ? from + sweep : from - sweep;
        double x0 = cx + cos(a) * rx * cos(from) - sin(a) * ry * sin(from);
        double y0 = cy + sin(a) * rx * cos(from) + cos(a) * ry * sin(from);
        double x1 = cx + cos(a) * rx * cos(to) - sin(a) * ry * sin(to);
        double y1 = cy + sin(a) * rx * cos(to) + cos(a) * ry * sin(to);
        bat_outline_clear(&o);
        bat_outline_move(&o, x0, y0);
        bat_outline_arc(&o, -rx, ry, turn, sweep > 3.14159265358979323846, positive, x1, y1);
        int segments = o.subpaths[0].segments;
        double total = 0, last = 0;
        for (int k = 0; k <= 8 * segments; k++) {
            double p[2];
            int segment = k / 8 < segments ? k / 8 : segments - 1;
            at(o.points + 6 * segment, k / 8.0 - segment, p);
            double ux = (cos(a) * (p[0] - cx) + sin(a) * (p[1] - cy)) / rx;
            double uy = (cos(a) * (p[1] - cy) - sin(a) * (p[0] - cx)) / ry;
            /* A sweep near half a turn leaves the centre ill-conditioned. */
            double slack = 1e-6 + 1e-11 / fmax(1e-9, fabs(sweep - 3.14159265358979323846));
            if (fabs(hypot(ux, uy) - 1) > slack) fail_msg("off the ellipse by %g", hypot(ux, uy) - 1);
            double angle = atan2(uy, ux);
            if (k > 0) total += remainder(angle - last, 6.28318530717958647692);
            last = angle;
        }
        assert_true(fabs(total - (positive ? sweep : -sweep)) < 1e-5);
        assert_true(o.points[6 * segments] == x1 && o.points[6 * segments + 1] == y1);
    }
    bat_outline_free(&o);
}

static void odd_arcs(void **state) {
    (void)state;
    bat_outline o = {0};
    assert_true(parse("M1 1A0 5 0 0 1 4 4", &o)); /* no radius: a line */
    const double line[] = {1, 1, 2, 2, 3, 3, 4, 4};
    expect(&o, 0, 1, false, line);
    assert_true(parse("M1 1A5 5 0 0 1 1 1L2 2", &o)); /* no way to go: left out */
    assert_int_equal(o.subpaths[0].segments, 1);
    assert_true(parse("M0 0A1 1 0 0 1 10 0", &o)); /* too small: scaled up to a half circle of radius 5 */
    for (int k = 0; k <= o.subpaths[0].segments * 4; k++) {
        double p[2];
        int segment = k / 4 < o.subpaths[0].segments ? k / 4 : o.subpaths[0].segments - 1;
        at(o.points + 6 * segment, k / 4.0 - segment, p);
        assert_true(fabs(hypot(p[0] - 5, p[1]) - 5) < 5e-6 && p[1] < 1e-9);
    }
    bat_outline_free(&o);
}

static void transforms(void **state) {
    (void)state;
    double m[6], x = 3, y = -2;
    static const struct {
        const char *text;
        double x, y;
    } cases[] = {{"", 3, -2},
                 {"none", 3, -2},
                 {"translate(10)", 13, -2},
                 {"translate(10,20) scale(2)", 16, 16},
                 {"scale(2 3),translate(1 1)", 8, -3},
                 {"rotate(90)", 2, 3},
                 {"rotate( 90 , 1 1 )", 4, 3},
                 {"rotate(-180)", -3, 2},
                 {"matrix(1 2 3 4 5 6)", 2, 4},
                 {"skewX(45)", 1, -2},
                 {"skewY(45)", 3, 1},
                 {"rotate(30)rotate(60)", 2, 3}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (!bat_svg_transform(cases[i].text, m)) fail_msg("%s", cases[i].text);
        double px = m[0] * x + m[2] * y + m[4], py = m[1] * x + m[3] * y + m[5];
        if (hypot(px - cases[i].x, py - cases[i].y) > 1e-14 * 8) fail_msg("%s: %g %g", cases[i].text, px, py);
    }
    static const char *const bad[] = {"rotate",           "rotate()",  "scale(1 2 3)",
                                      "matrix(1 2 3)",    "rotate(1",  "turn(5)",
                                      "translate(1e999)", "rotate(x)", "scale(1e300) scale(1e300)",
                                      "rotate(1 2)"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        if (bat_svg_transform(bad[i], m)) fail_msg("%s should not parse", bad[i]);
        assert_true(m[0] == 1 && m[1] == 0 && m[2] == 0 && m[3] == 1 && m[4] == 0 && m[5] == 0);
    }
}

/* A 200 by 100 box in a 100 by 100 viewport at 10, 20. */
static void viewports(void **state) {
    (void)state;
    const double box[4] = {0, 0, 200, 100};
    static const struct {
        const char *ratio;
        double sx, sy, x, y;
    } cases[] = {{NULL, 0.5, 0.5, 10, 45},         {"xMidYMid meet", 0.5, 0.5, 10, 45},
                 {"xMinYMin", 0.5, 0.5, 10, 20},   {"xMaxYMax meet", 0.5, 0.5, 10, 70},
                 {"none", 0.5, 1, 10, 20},         {"xMidYMid slice", 1, 1, -40, 20},
                 {"xMinYMid slice", 1, 1, 10, 20}, {"xMaxYMid slice", 1, 1, -90, 20}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double m[6];
        bat_svg_fit(box, 10, 20, 100, 100, cases[i].ratio, m);
        const double expected[6] = {cases[i].sx, 0, 0, cases[i].sy, cases[i].x, cases[i].y};
        for (int k = 0; k < 6; k++) assert_true(fabs(m[k] - expected[k]) < 1e-12);
    }
}

static void lengths(void **state) {
    (void)state;
    static const struct {
        const char *text;
        double value;
    } cases[] = {{"5", 5},      {"5px", 5},    {" 1in ", 96}, {"2.54cm", 96}, {"25.4mm", 96},
                 {"72pt", 96},  {"6pc", 96},   {"50%", 100},  {"1em", 16},    {"101.6Q", 96},
                 {"1e1px", 10}, {"-.5", -0.5}, {"1E2", 100}};
    double value;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (!bat_svg_length(cases[i].text, 200, &value)) fail_msg("%s", cases[i].text);
        assert_true(fabs(value - cases[i].value) < 1e-12);
    }
    static const char *const bad[] = {"", "px", "5 px", "5furlong", "1e999", "NaN", "5;"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) assert_false(bat_svg_length(bad[i], 200, &value));
}

/* The element as name, value pairs. */
static const char *lookup(const void *element, const char *name) {
    for (const char *const *pair = element; pair[0]; pair += 2)
        if (strcmp(pair[0], name) == 0) return pair[1];
    return NULL;
}

static bool shape(const char *name, const char *const *pairs, bat_outline *o) {
    bat_svg_shape s = {lookup, pairs, 200, 100};
    bat_outline_clear(o);
    return bat_svg_shape_outline(&s, name, o);
}

static void shapes(void **state) {
    (void)state;
    bat_outline o = {0};
    const char *const square[] = {"x", "1", "y", "2", "width", "3", "height", "50%", NULL};
    assert_true(shape("rect", square, &o));
    const double corners[][2] = {{1, 2}, {4, 2}, {4, 52}, {1, 52}, {1, 2}};
    assert_true(o.subpath_count == 1 && o.subpaths[0].closed && o.subpaths[0].segments == 4);
    for (int i = 0; i < 5; i++)
        assert_true(o.points[6 * i] == corners[i][0] && o.points[6 * i + 1] == corners[i][1]);

    /* Only rx: ry follows; both are cut to half the sides, here to a stadium of 10 by 4. Every point has distance 2
     * from the segment (2,2)-(8,2). */
    const char *const stadium[] = {"width", "10", "height", "4", "rx", "2", NULL};
    assert_true(shape("rect", stadium, &o));
    for (int k = 0; k <= 8 * o.subpaths[0].segments; k++) {
        double p[2];
        int segment = k / 8 < o.subpaths[0].segments ? k / 8 : o.subpaths[0].segments - 1;
        at(o.points + 6 * segment, k / 8.0 - segment, p);
        assert_true(fabs(hypot(p[0] - fmin(fmax(p[0], 2), 8), p[1] - 2) - 2) < 2e-6);
    }
    const char *const circle[] = {"cx", "7", "cy", "-1", "r", "4", NULL};
    assert_true(shape("circle", circle, &o));
    assert_true(o.subpaths[0].closed);
    double turned = 0, last = 0;
    for (int k = 0; k <= 8 * o.subpaths[0].segments; k++) {
        double p[2];
        int segment = k / 8 < o.subpaths[0].segments ? k / 8 : o.subpaths[0].segments - 1;
        at(o.points + 6 * segment, k / 8.0 - segment, p);
        assert_true(fabs(hypot(p[0] - 7, p[1] + 1) - 4) < 4e-6);
        double angle = atan2(p[1] + 1, p[0] - 7);
        turned += remainder(angle - last, 6.28318530717958647692);
        last = angle;
    }
    assert_true(fabs(turned - 6.28318530717958647692) < 1e-6);
    const char *const ellipse[] = {"rx", "4", "ry", "auto", NULL};
    assert_true(shape("ellipse", ellipse, &o));
    assert_true(o.subpath_count == 1 && o.points[0] == 4);
    const char *const poly[] = {"points", " 0,0 3-3,6 0 9", NULL};
    assert_false(shape("polygon", poly, &o)); /* odd */
    assert_true(o.subpaths[0].closed && o.subpaths[0].segments == 3);
    const char *const open[] = {"points", "0 0 3 3", NULL};
    assert_true(shape("polyline", open, &o));
    assert_true(!o.subpaths[0].closed && o.subpaths[0].segments == 1);
    const char *const line[] = {"x2", "100%", "y2", "100%", NULL};
    assert_true(shape("line", line, &o));
    assert_true(o.points[6] == 200 && o.points[7] == 100);
    const char *const flat[] = {"width", "0", "height", "4", NULL}, *const negative[] = {"r", "-1", NULL};
    assert_true(shape("rect", flat, &o) && o.subpath_count == 0);
    assert_false(shape("circle", negative, &o));
    bat_outline_free(&o);
}

static void colours(void **state) {
    (void)state;
    static const struct {
        const char *text;
        uint32_t colour;
    } cases[] = {{"red", 0xff0000ff},
                 {"ReBeccaPurple", 0x663399ff},
                 {"#abc", 0xaabbccff},
                 {"#ABCD", 0xaabbccdd},
                 {"#12345678", 0x12345678},
                 {" #010203 ", 0x010203ff},
                 {"rgb(1,2,3)", 0x010203ff},
                 {"rgb(100% 0% 50%)", 0xff0080ff},
                 {"rgba(255,300,-4,.5)", 0xffff0080},
                 {"rgb(1 2 3 / 50%)", 0x01020380},
                 {"hsl(120,100%,50%)", 0x00ff00ff},
                 {"hsl(240deg 100% 25%)", 0x000080ff},
                 {"hsla(-360,0%,100%,0)", 0xffffff00},
                 {"transparent", 0},
                 {"#fff icc-color(x,1)", 0xffffffff},
                 {"aliceblue", 0xf0f8ffff},
                 {"yellowgreen", 0x9acd32ff}};
    uint32_t colour;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (!bat_svg_colour(cases[i].text, &colour)) fail_msg("%s", cases[i].text);
        if (colour != cases[i].colour) fail_msg("%s: %08x", cases[i].text, colour);
    }
    static const char *const bad[] = {
        "", "#", "#12", "#12345", "rgb(1,2)", "rgb(1,2,3", "rgb(1,2,3,4,5)", "redd", "rgb(nan,0,0)"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        if (bat_svg_colour(bad[i], &colour)) fail_msg("%s should not parse", bad[i]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(commands_agree),
        cmocka_unit_test(lines_have_handles_at_thirds),
        cmocka_unit_test(errors_stop_at_the_last_good_segment),
        cmocka_unit_test(arcs_lie_on_their_ellipse),
        cmocka_unit_test(odd_arcs),
        cmocka_unit_test(transforms),
        cmocka_unit_test(viewports),
        cmocka_unit_test(lengths),
        cmocka_unit_test(shapes),
        cmocka_unit_test(colours),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
