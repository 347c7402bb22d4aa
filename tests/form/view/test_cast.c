/* Strokes cast into space: points of a canvas that a view can see come back; the fates, checked against their
 * definitions; continuity along a stroke; bad data. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include "base/vec.h"
#include "support/random_surface.h"
#include "support/views.h"

static const double origin[3] = {0, 0, 0}, limit = 0.0871557427476581736; /* sine of 5 degrees */

static vec random_unit_vec(random_source *r) {
    const double x = random_between(r, -1, 1), y = random_between(r, -1, 1), z = random_between(r, -1, 1);
    return vec_unit((vec){x, y, z});
}

static bat_cast_point cast_one(const bat_viewpoint *view, const bat_canvas *canvas, const double pixel[2]) {
    bat_cast_point out;
    size_t landed = 9;
    const bat_stroke stroke = {.dimension = 2, .count = 1, .points = pixel};
    assert_int_equal(bat_cast(view, &stroke, canvas, &out, &landed), BAT_OK);
    assert_int_equal(landed, out.fate == BAT_CAST_LANDED);
    return out;
}

static vec ray_of(const bat_viewpoint *view, const double pixel[2], vec *from) {
    double a[3], b[3];
    assert_int_equal(bat_viewpoint_ray(view, pixel, a, b), BAT_OK);
    *from = vec_load(a, 3);
    return vec_load(b, 3);
}

static void on_planes(void **state) {
    (void)state;
    random_source r = {21};
    int fates[5] = {0};
    for (int number = 0; number < 600; number++) {
        const bat_viewpoint view = some_view(&r, number, origin, 50);
        bat_canvas canvas = {.curve = NULL};
        const vec normal = random_unit_vec(&r);
        double pixel[2];
        vec_store(vec_scale(normal, random_between(&r, 0.1, 10)), canvas.normal);
        for (int c = 0; c < 3; c++) canvas.origin[c] = random_between(&r, -60, 60);
        for (int d = 0; d < 2; d++) pixel[d] = random_between(&r, 0, 1) * view.size[d];
        const bat_cast_point got = cast_one(&view, &canvas, pixel);
        vec from;
        const vec along = ray_of(&view, pixel, &from);
        const double towards = vec_dot(along, normal);
        const double far = vec_dot(vec_sub(vec_load(canvas.origin, 3), from), normal) / towards;
        assert_int_equal(got.fate, fabs(towards) < limit ? BAT_CAST_EDGE_ON
                                   : far < 0             ? BAT_CAST_BEHIND
                                                         : BAT_CAST_LANDED);
        fates[got.fate]++;
        if (got.fate != BAT_CAST_LANDED) continue;
        const vec at = vec_load(got.point, 3);
        assert_true(fabs(got.distance - far) < 1e-9 * far);
        assert_true(fabs(vec_dot(vec_sub(at, vec_load(canvas.origin, 3)), normal)) < 1e-9);
        double back[2];
        assert_int_equal(bat_viewpoint_project(&view, got.point, back, NULL), BAT_OK);
        assert_true(fabs(back[0] - pixel[0]) < 1e-6 && fabs(back[1] - pixel[1]) < 1e-6);
    }
    assert_true(fates[BAT_CAST_LANDED] > 200 && fates[BAT_CAST_EDGE_ON] > 20 && fates[BAT_CAST_BEHIND] > 20);
}

/* A place on the ruled surface, and whether it may be kept, by the definitions. */
static bool may_keep(const bat_viewpoint *view, const bat_curve *curve, vec d, double s, double h,
                     double pixel[2]) {
    double jet[6], at[3];
    bat_curve_eval(curve, s, 1, jet);
    vec_store(vec_add(vec_load(jet, 3), vec_scale(d, h)), at);
    if (bat_viewpoint_project(view, at, pixel, NULL) != BAT_OK) return false;
    vec from;
    const vec along = ray_of(view, pixel, &from);
    if (vec_dot(vec_sub(vec_load(at, 3), from), along) < 0) return false;
    const double sine = fabs(vec_dot(vec_cross(vec_unit(vec_load(jet + 3, 3)), d), along));
    return sine >= limit * 1.0001 && fabs(h) <= 4 * bat_curve_size(curve);
}

/* The sample lands on the surface, on its ray, and, when it is the only one, at the place itself. Never at a place with
 * a greater |h| than that. */
static void on_ruled_surfaces(void **state) {
    (void)state;
    random_source r = {22};
    int places = 0, same = 0;
    for (int number = 0; number < 1500; number++) {
        bat_curve *curve = random_curve(&r, 1 + number % 7, 3, number % 3, random_int(&r, 0, 8));
        const vec d = random_unit_vec(&r);
        bat_canvas canvas = {.curve = curve};
        double domain[2], pixel[2], at[3];
        vec_store(vec_scale(d, 3), canvas.along);
        bat_curve_domain(curve, domain);
        const double size = bat_curve_size(curve);
        const bat_viewpoint view = some_view(&r, number, origin, 6 * size);
        const double s = random_between(&r, domain[0], domain[1]), h = size * random_between(&r, -1, 1);
        if (may_keep(&view, curve, d, s, h, pixel)) {
            const bat_cast_point got = cast_one(&view, &canvas, pixel);
            assert_int_equal(got.fate, BAT_CAST_LANDED);
            bat_curve_eval(curve, got.own[0], 0, at);
            const vec on = vec_add(vec_load(at, 3), vec_scale(d, got.own[1]));
            assert_true(vec_norm(vec_sub(on, vec_load(got.point, 3))) < 1e-12 * size);
            double back[2];
            assert_int_equal(bat_viewpoint_project(&view, got.point, back, NULL), BAT_OK);
            assert_true(fabs(back[0] - pixel[0]) < 1e-6 && fabs(back[1] - pixel[1]) < 1e-6);
            assert_true(fabs(got.own[1]) <= fabs(h) + 1e-7 * size);
            places++, same += fabs(got.own[1] - h) < 1e-7 * size;
        }
        bat_curve_free(curve);
    }
    assert_true(places > 900 && same > places / 2);
}

/* A U seen from the side, ruled upwards: each ray meets both legs. A stroke that begins on one stays there. */
static void a_stroke_stays_on_its_leg(void **state) {
    (void)state;
    const double points[] = {0, 0, 0, 10, 0, 0, 10, 6, 0, 0, 6, 0}, knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    bat_canvas canvas = {.along = {0, 0, 1}};
    assert_int_equal(bat_curve_create(3, 3, false, 4, points, 8, knots, &canvas.curve), BAT_OK);
    const bat_viewpoint view = {
        .eye = {3, -50, 20}, .target = {3, 0, 0}, .up = {0, 0, 1}, .size = {600, 400}, .height = 20};
    enum { COUNT = 40 };
    for (int leg = 0; leg < 2; leg++) {
        double pixels[2 * COUNT];
        bat_cast_point out[COUNT];
        for (int i = 0; i < COUNT; i++) {
            double at[3];
            const double s = 0.02 + 0.4 * i / (COUNT - 1);
            bat_curve_eval(canvas.curve, leg ? 1 - s : s, 0, at);
            at[2] += i * 0.08; /* climbs, so that |h| comes to be greater than on the other leg */
            assert_int_equal(bat_viewpoint_project(&view, at, pixels + 2 * i, NULL), BAT_OK);
        }
        size_t landed;
        const bat_stroke stroke = {.dimension = 2, .count = COUNT, .points = pixels};
        assert_int_equal(bat_cast(&view, &stroke, &canvas, out, &landed), BAT_OK);
        for (int i = 0; i < COUNT; i++) {
            const double s = 0.02 + 0.4 * i / (COUNT - 1);
            if (s > 0.38) continue; /* near the bend both legs are seen from their edge */
            assert_int_equal(out[i].fate, BAT_CAST_LANDED);
            assert_true(fabs(out[i].own[0] - (leg ? 1 - s : s)) < 1e-9 &&
                        fabs(out[i].own[1] - 0.08 * i) < 1e-9);
        }
    }
    bat_curve_free(canvas.curve);
}

static void fates_on_ruled_surfaces(void **state) {
    (void)state;
    const double line[] = {-1, 0, 1, 0}, knots[] = {0, 0, 1, 1}; /* two numbers: z = 0 */
    bat_canvas canvas = {.along = {0, 0, 1}};
    assert_int_equal(bat_curve_create(2, 1, false, 2, line, 4, knots, &canvas.curve), BAT_OK);
    bat_viewpoint view = {.eye = {0, -9, 0}, .up = {0, 0, 1}, .size = {100, 100}, .height = 20};
    const struct {
        double pixel[2];
        bat_cast_fate fate;
    } cases[] = {
        {{50, 50}, BAT_CAST_LANDED}, {{45, 11}, BAT_CAST_LANDED},   {{45, 9}, BAT_CAST_FAR},
        {{55, 91}, BAT_CAST_FAR},    {{44.9, 50}, BAT_CAST_MISSED}, {{55, 50}, BAT_CAST_LANDED},
        {{45, 50}, BAT_CAST_LANDED}, {{55.1, 0}, BAT_CAST_MISSED},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_int_equal(cast_one(&view, &canvas, cases[i].pixel).fate, cases[i].fate);
    const double middle[2] = {50, 50};
    view.target[1] = -99; /* looks away */
    assert_int_equal(cast_one(&view, &canvas, middle).fate, BAT_CAST_BEHIND);
    view = (bat_viewpoint){
        .eye = {-9, 0.5, 0}, .target = {0, 0.5, 0}, .up = {0, 0, 1}, .size = {100, 100}, .height = 20};
    assert_int_equal(cast_one(&view, &canvas, middle).fate, BAT_CAST_MISSED); /* along the line, past it */
    view.eye[1] = 0.2, view.target[1] = -0.2 / 9;                             /* meets it under 1.4 degrees */
    assert_int_equal(cast_one(&view, &canvas, middle).fate, BAT_CAST_EDGE_ON);
    view = (bat_viewpoint){
        .eye = {5, 5, 9}, .target = {5, 5, 0}, .up = {0, 1, 0}, .size = {100, 100}, .height = 20};
    assert_int_equal(cast_one(&view, &canvas, middle).fate, BAT_CAST_EDGE_ON); /* along the ruling */
    bat_curve_free(canvas.curve);
}

/* The nearest hit, or edge-on there; what lies behind the eye is named. */
static void on_surfaces(void **state) {
    (void)state;
    random_source r = {24};
    int fates[5] = {0};
    for (int number = 0; number < 120; number++) {
        const int degree[2] = {2 + number % 3, 2 + number / 3 % 3},
                  kind[2] = {number % 2 * 2, number / 2 % 2 * 2};
        bat_surface *surface = random_surface(&r, degree, kind, (const int[2]){3, 3});
        bat_viewpoint view = some_view(&r, number, origin, 60);
        for (int c = 0; c < 3 && number % 5 == 0; c++) view.target[c] += 2 * (view.eye[c] - view.target[c]);
        const bat_canvas canvas = {.surface = surface};
        for (int k = 0; k < 8; k++) {
            double pixel[2], a[3], b[3], normal[3];
            for (int d = 0; d < 2; d++) pixel[d] = view.size[d] * random_between(&r, 0.3, 0.7);
            const bat_cast_point got = cast_one(&view, &canvas, pixel);
            bat_surface_point hit[32];
            size_t count = 0, behind = 0;
            assert_int_equal(bat_viewpoint_ray(&view, pixel, a, b), BAT_OK);
            assert_int_equal(bat_surface_hits(surface, a, b, 32, hit, &count), BAT_OK);
            fates[got.fate]++;
            if (count == 0) {
                for (int c = 0; c < 3; c++) b[c] = -b[c];
                assert_int_equal(bat_surface_hits(surface, a, b, 0, NULL, &behind), BAT_OK);
                assert_int_equal(got.fate, behind ? BAT_CAST_BEHIND : BAT_CAST_MISSED);
                continue;
            }
            assert_int_equal(bat_surface_normal(surface, hit[0].u, hit[0].v, normal), BAT_OK);
            const double sine = fabs(vec_dot(vec_load(normal, 3), vec_load(b, 3)));
            assert_int_equal(got.fate, sine < limit ? BAT_CAST_EDGE_ON : BAT_CAST_LANDED);
            if (got.fate == BAT_CAST_LANDED)
                assert_true(got.distance == hit[0].distance && got.own[0] == hit[0].u &&
                            got.own[1] == hit[0].v);
        }
        bat_surface_free(surface);
    }
    assert_true(fates[BAT_CAST_LANDED] > 150 && fates[BAT_CAST_MISSED] > 50 && fates[BAT_CAST_BEHIND] > 30);
}

/* A flat square, seen at 4 and at 6 degrees. */
static void a_sheet_seen_from_its_edge(void **state) {
    (void)state;
    const double flat[] = {-1, -1, 0, -1, 1, 0, 1, -1, 0, 1, 1, 0}, knots[] = {0, 0, 1, 1},
                 middle[2] = {50, 50};
    bat_canvas canvas = {.curve = NULL};
    assert_int_equal(bat_surface_create((const int[2]){1, 1}, (const bool[2]){false, false},
                                        (const size_t[2]){2, 2}, flat, (const int[2]){4, 4}, knots, knots,
                                        &canvas.surface),
                     BAT_OK);
    for (int degrees = 4; degrees <= 6; degrees += 2) {
        const double angle = degrees * BAT_PI / 180;
        const bat_viewpoint view = {
            .eye = {0, -9 * cos(angle), 9 * sin(angle)}, .up = {0, 0, 1}, .size = {100, 100}, .fov = 30};
        assert_int_equal(cast_one(&view, &canvas, middle).fate,
                         degrees == 4 ? BAT_CAST_EDGE_ON : BAT_CAST_LANDED);
    }
    bat_surface_free(canvas.surface);
}

static void bad_data(void **state) {
    (void)state;
    const double pixels[] = {1, 2, 3, NAN}, space[] = {1, 2, 3};
    const bat_viewpoint view = {.eye = {0, -9, 0}, .up = {0, 0, 1}, .size = {100, 100}, .height = 20};
    bat_viewpoint none = view;
    none.height = 0;
    bat_canvas plane = {.normal = {0, 1, 0}}, flat = plane, lost = plane;
    flat.normal[1] = 0, lost.origin[2] = NAN;
    bat_cast_point out[2];
    size_t landed = 7;
    const bat_stroke good = {.dimension = 2, .count = 1, .points = pixels},
                     wild = {.dimension = 2, .count = 2, .points = pixels},
                     deep = {.dimension = 3, .count = 1, .points = space}, empty = {.dimension = 2};
    assert_int_equal(bat_cast(&none, &good, &plane, out, &landed), BAT_ARGUMENT);
    assert_int_equal(bat_cast(&view, &wild, &plane, out, &landed), BAT_NUMBER);
    assert_int_equal(bat_cast(&view, &deep, &plane, out, &landed), BAT_DIMENSION);
    assert_int_equal(bat_cast(&view, &good, &flat, out, &landed), BAT_ARGUMENT);
    assert_int_equal(bat_cast(&view, &good, &lost, out, &landed), BAT_NUMBER);
    assert_int_equal(bat_cast(&view, &good, &plane, NULL, &landed), BAT_ARGUMENT);
    assert_int_equal(landed, 7);
    assert_int_equal(bat_cast(&view, &empty, &plane, NULL, &landed), BAT_OK);
    assert_int_equal(landed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_planes),
        cmocka_unit_test(on_ruled_surfaces),
        cmocka_unit_test(on_surfaces),
        cmocka_unit_test(a_stroke_stays_on_its_leg),
        cmocka_unit_test(a_sheet_seen_from_its_edge),
        cmocka_unit_test(bad_data),
        cmocka_unit_test(fates_on_ruled_surfaces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
