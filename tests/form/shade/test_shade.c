/* Pictures of surfaces: a sphere's disc, depth, light, stripes and curvature by closed forms; what is cut off by the eye;
 * what lies behind; the same bits each time. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "form/shade/shade.h"
#include "support/alloc_fail.h"
#include "support/round.h"

enum { SIZE = 120 };

/* From 5 in front of a sphere of radius 1, which covers 80 of 120 pixels in parallel projection. */
static bat_viewpoint view_of_sphere(double fov) {
    return (bat_viewpoint){
        .eye = {3, -4, 0}, .up = {0, 0, 1}, .size = {SIZE, SIZE}, .fov = fov, .height = fov > 0 ? 0 : 3};
}

static bat_shading *shade(const bat_viewpoint *view, bat_surface *surface, bat_look look) {
    const bat_shaded one = {.surface = surface};
    bat_shading *out = NULL;
    assert_int_equal(bat_shade(view, 1, &one, look, &out), BAT_OK);
    assert_true(out->width == (int)view->size[0] && out->height == (int)view->size[1]);
    return out;
}

static double area_of(const bat_shading *s) {
    double sum = 0;
    for (int k = 0; k < s->width * s->height; k++) sum += s->rgba[4 * k + 3] / 255.0;
    return sum;
}

static double middle_depth(const bat_shading *s) {
    const size_t row = (size_t)(BAT_SHADE_SIDE * s->height / 2), width = (size_t)(BAT_SHADE_SIDE * s->width);
    return (double)s->depth[row * width + width / 2];
}

static void a_disc(void **state) {
    (void)state;
    bat_surface *sphere = round_sphere();
    for (int k = 0; k < 2; k++) {
        const bat_viewpoint view = view_of_sphere(k ? 40 : 0);
        bat_shading *s = shade(&view, sphere, BAT_LOOK_SHADED);
        /* in perspective the outline is where rays touch: at the angle whose sine is 1/5 */
        const double focus = SIZE / 2.0 / tan(20 * round_pi / 180);
        const double radius = k ? focus * tan(asin(0.2)) : 40;
        assert_true(fabs(area_of(s) / (round_pi * radius * radius) - 1) < 0.002);
        assert_true(fabs(middle_depth(s) - 4) < 1e-3);
        for (int y = 0; y < SIZE; y++) /* no gap in the disc, nothing beside it */
            for (int x = 0; x < SIZE; x++) {
                const double far = hypot(x + 0.5 - SIZE / 2.0, y + 0.5 - SIZE / 2.0);
                const int alpha = s->rgba[4 * (y * SIZE + x) + 3];
                assert_true(far > radius - 1 || alpha == 255);
                assert_true(far < radius + 1 || alpha == 0);
            }
        bat_shading_free(s);
    }
    bat_surface_free(sphere);
}

#define BAT_TINT(name, red, green, blue) static const double name[3] = {red, green, blue};
#define BAT_SHADE(name, value) static const double name = value;
#include "form/shade/light.def"

/* Facing the eye in the middle: the sum of light.def for the normal (0, 0, 1). */
static void matte_light(void **state) {
    (void)state;
    double light = AMBIENT;
#define BAT_LIGHT(name, x, y, z, strength) light += (strength)*fmax(0, ((z) + WRAP) / (1 + WRAP));
#include "form/shade/light.def"
    bat_surface *sphere = round_sphere();
    const bat_viewpoint view = view_of_sphere(0);
    bat_shading *s = shade(&view, sphere, BAT_LOOK_SHADED);
    const uint8_t *pixel = s->rgba + 4 * (SIZE / 2 * SIZE + SIZE / 2);
    for (int c = 0; c < 3; c++) assert_true(fabs(pixel[c] - 255 * fmin(CLAY[c] * light, 1)) < 2);
    (void)BACK, (void)STRIPE_DARK, (void)STRIPE_LIGHT, (void)COLD, (void)NEUTRAL, (void)WARM, (void)SOFT;
    bat_shading_free(s);
    bat_surface_free(sphere);
}

/* Along the middle column of a sphere, the angle of the reflected ray from up goes from 90 degrees to 180, to 0 and back to
 * 90: at 80 degrees of latitude it has crossed the edges of 7 stripes, 18, and 7. */
static void stripes(void **state) {
    (void)state;
    assert_true(STRIPES == 18);
    bat_surface *sphere = round_sphere();
    bat_viewpoint view = view_of_sphere(0);
    view.size[0] = view.size[1] = 600;
    bat_shading *s = shade(&view, sphere, BAT_LOOK_ZEBRA);
    int edges = 0, before = -1;
    for (int y = 300 - 196; y <= 300 + 196; y++) {
        const int light = s->rgba[4 * (y * 600 + 300)] > 127;
        edges += before >= 0 && light != before;
        before = light;
    }
    assert_int_equal(edges, 32);
    bat_shading_free(s);
    bat_surface_free(sphere);
}

static void curvature(void **state) {
    (void)state;
    bat_surface *sphere = round_sphere(), *tube = round_tube(2);
    const bat_viewpoint view = view_of_sphere(0);
    bat_shading *s = shade(&view, sphere, BAT_LOOK_GAUSS);
    assert_true(fabs(s->range - 1) < 0.02);
    const uint8_t *pixel = s->rgba + 4 * (SIZE / 2 * SIZE + SIZE / 2);
    assert_true(pixel[0] > pixel[1] + 40 && pixel[0] > pixel[2] + 40); /* warm */
    bat_shading_free(s);
    s = shade(&view, tube, BAT_LOOK_MEAN); /* bends away from its normal, which points outwards */
    assert_true(fabs(s->range - 0.5) < 0.01);
    pixel = s->rgba + 4 * (SIZE / 3 * SIZE + SIZE / 2);
    assert_true(pixel[2] > pixel[0] + 40); /* cold */
    bat_shading_free(s);
    bat_surface_free(sphere), bat_surface_free(tube);
}

/* From inside, all that is seen is the inside; behind the eye nothing is. */
static void cut_off_by_the_eye(void **state) {
    (void)state;
    bat_surface *sphere = round_sphere();
    bat_viewpoint view = {.eye = {0.5, 0, 0}, .up = {0, 0, 1}, .size = {60, 40}, .fov = 70};
    bat_shading *s = shade(&view, sphere, BAT_LOOK_SHADED);
    assert_true(area_of(s) == 60 * 40);
    assert_true(fabs(middle_depth(s) - 1.5) < 1e-3);
    bat_shading_free(s);
    view.eye[0] = 2, view.target[0] = 3; /* away from it */
    s = shade(&view, sphere, BAT_LOOK_SHADED);
    assert_true(area_of(s) == 0 && isinf(middle_depth(s)));
    bat_shading_free(s);
    view = view_of_sphere(0);
    view.eye[0] = 0.03, view.eye[1] = -0.04; /* parallel: the half behind the plane of the eye is cut off */
    s = shade(&view, sphere, BAT_LOOK_SHADED);
    assert_true(fabs(middle_depth(s) - 1.05) < 1e-3);
    bat_shading_free(s);
    bat_surface_free(sphere);
}

static void what_is_hidden(void **state) {
    (void)state;
    bat_surface *sphere = round_sphere();
    const bat_viewpoint view = view_of_sphere(0);
    bat_shading *s = shade(&view, sphere, BAT_LOOK_LINES);
    const double middle[2] = {60, 60}, beside[2] = {60, 105}, outside[2] = {-5, 1e9};
    assert_true(bat_shading_hides(s, middle, 5, 0.01));
    assert_false(bat_shading_hides(s, middle, 4.005, 0.01));
    assert_false(bat_shading_hides(s, middle, 3, 0.01));
    assert_false(bat_shading_hides(s, beside, 100, 0.01));
    assert_false(bat_shading_hides(s, outside, 100, 0.01));
    bat_shading_free(s);
    bat_surface_free(sphere);
}

static void the_same_bits(void **state) {
    (void)state;
    bat_surface *torus = round_torus(2);
    const bat_viewpoint view = {.eye = {3, -4, 5}, .up = {0, 0, 1}, .size = {50, 70}, .fov = 50};
    bat_shading *a = shade(&view, torus, BAT_LOOK_ZEBRA), *b = shade(&view, torus, BAT_LOOK_ZEBRA);
    assert_memory_equal(a->rgba, b->rgba, 4 * 50 * 70);
    assert_memory_equal(a->depth, b->depth, 9 * 50 * 70 * sizeof(float));
    bat_shading_free(a), bat_shading_free(b);
    bat_surface_free(torus);
}

static void what_is_refused(void **state) {
    (void)state;
    bat_viewpoint view = view_of_sphere(0);
    bat_shading *s = NULL;
    assert_int_equal(bat_shade(&view, 0, NULL, BAT_LOOK_SHADED, &s), BAT_OK);
    assert_true(area_of(s) == 0);
    bat_shading_free(s);
    s = NULL;
    view.size[0] = 10.5;
    assert_int_equal(bat_shade(&view, 0, NULL, BAT_LOOK_SHADED, &s), BAT_ARGUMENT);
    view.size[0] = view.size[1] = 1e5;
    assert_int_equal(bat_shade(&view, 0, NULL, BAT_LOOK_SHADED, &s), BAT_COUNT);
    view.size[0] = NAN;
    assert_int_equal(bat_shade(&view, 0, NULL, BAT_LOOK_SHADED, &s), BAT_NUMBER);
    view = view_of_sphere(0);
    assert_int_equal(bat_shade(&view, 1, NULL, BAT_LOOK_SHADED, &s), BAT_ARGUMENT);
    assert_int_equal(bat_shade(&view, 0, NULL, BAT_LOOK_COUNT, &s), BAT_ARGUMENT);
    assert_int_equal(bat_shade(&view, 0, NULL, BAT_LOOK_SHADED, NULL), BAT_ARGUMENT);
    assert_null(s);
    bat_shading_free(NULL);
}

static void failing_allocations(void **state) {
    (void)state;
    bat_surface *tube = round_tube(1);
    const bat_viewpoint view = {.eye = {0.5, 0, 0.5}, .up = {0, 0, 1}, .size = {20, 20}, .fov = 120};
    const bat_shaded one = {.surface = tube, .colour = 0xff0000ff};
    const long before = alloc_live();
    for (long n = 1;; n++) {
        bat_shading *s = NULL;
        alloc_fail_at(n);
        const bat_status status = bat_shade(&view, 1, &one, BAT_LOOK_GAUSS, &s);
        const bool reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        bat_shading_free(s);
        assert_int_equal(alloc_live(), before);
        if (!reached) break;
    }
    bat_surface_free(tube);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_disc),
        cmocka_unit_test(matte_light),
        cmocka_unit_test(stripes),
        cmocka_unit_test(curvature),
        cmocka_unit_test(cut_off_by_the_eye),
        cmocka_unit_test(what_is_hidden),
        cmocka_unit_test(the_same_bits),
        cmocka_unit_test(what_is_refused),
        cmocka_unit_test(failing_allocations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
