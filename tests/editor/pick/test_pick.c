/* Picking against brute force over dense samples; ends; which of several equally near objects is in front. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/pick/pick.h"
#include "support/pen.h"
#include "support/xml.h"
#include <batten/format.h>
#include <string.h>

enum { CURVES = 60, SAMPLES = 2000 };

static double uniform(uint64_t *seed) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) / 9007199254740992.0;
}

static double dense_distance(const bat_curve *curve, const double point[2]) {
    static double u[SAMPLES], at[2 * SAMPLES];
    double best = INFINITY;
    bat_curve_spread(curve, SAMPLES, u);
    bat_curve_eval_many(curve, SAMPLES, u, 0, at);
    for (int i = 0; i < SAMPLES; i++)
        best = fmin(best, hypot(at[2 * i] - point[0], at[2 * i + 1] - point[1]));
    return best;
}

static void against_brute_force(void **state) {
    (void)state;
    uint64_t seed = 7;
    bat_document *document = NULL;
    bat_scene scene;
    bat_document_create(&document);
    for (int i = 0; i < CURVES; i++) {
        double x = 1000 * uniform(&seed), y = 800 * uniform(&seed), step = 5 + 15 * uniform(&seed);
        pen_add(document, pen_curve(x, y, step, 60 * uniform(&seed), 6 + i % 5));
    }
    bat_scene_init(&scene);
    assert_int_equal(bat_scene_sync(&scene, document, 1), BAT_OK);
    int found = 0;
    for (int i = 0; i < 300; i++) {
        double point[2] = {1200 * uniform(&seed), 900 * uniform(&seed)}, within = 30 * uniform(&seed),
               best = INFINITY;
        for (int j = 0; j < CURVES; j++)
            best = fmin(best, dense_distance(bat_object_curve(bat_document_at(document, j), 0), point));
        bat_pick pick = bat_pick_nearest(&scene, point, within);
        if (fabs(best - within) < 0.05) continue; /* the samples cannot tell */
        assert_int_equal(pick.object != 0, best < within);
        if (!pick.object) continue;
        found++;
        assert_true(pick.near.distance <= best + 1e-9 && pick.near.distance > best - 0.05);
        assert_true(bat_object_id(bat_document_at(document, pick.index)) == pick.object);
        double away = hypot(pick.near.point[0] - point[0], pick.near.point[1] - point[1]);
        assert_true(fabs(away - pick.near.distance) < 1e-9);
    }
    assert_true(found > 30);
    bat_scene_free(&scene);
    bat_document_free(document);
}

static void front_and_ends(void **state) {
    (void)state;
    bat_document *document = NULL;
    bat_scene scene;
    bat_document_create(&document);
    bat_id back = pen_add(document, pen_curve(0, 0, 10, 0, 11)),
           front = pen_add(document, pen_curve(0, 0, 10, 0, 11));
    bat_scene_init(&scene);
    assert_int_equal(bat_scene_sync(&scene, document, 1), BAT_OK);
    assert_true(bat_pick_nearest(&scene, (double[]){50, 1}, 5).object == front);
    assert_true(bat_pick_nearest(&scene, (double[]){50, 6}, 5).object == 0);
    bat_pick end = bat_pick_end(&scene, (double[]){101, 1}, 5, front, 0);
    assert_true(end.object == back && end.near.u == 8 && fabs(end.near.distance - sqrt(2)) < 1e-12);
    assert_true(bat_pick_end(&scene, (double[]){50, 0}, 5, 0, 0).object == 0);
    bat_scene_free(&scene);
    bat_document_free(document);
}

/* What a click finds is what is seen there: by the names of the things, in a file whose clips say which they are. */
static void what_is_cut_away_is_not_picked(void **state) {
    (void)state;
    static const char file[] =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>"
        "<clipPath id='left'><rect width='50' height='100'/></clipPath>"
        "<clipPath id='ring'><path clip-rule='evenodd' d='M0 0H100V100H0zM20 20H80V80H20z'/></clipPath>"
        "<rect id='ground' width='100' height='100'/>"
        "<g id='a' clip-path='url(#left)'><g id='b' clip-path='url(#ring)'>"
        "<rect id='top' width='100' height='100'/><path id='line' d='M0 60H100' stroke='red' "
        "stroke-width='9'/></g>"
        "<circle id='dot' cx='45' cy='90' r='9'/></g></svg>";
    static const struct {
        double x, y, within;
        const char *name, *outlined; /* in outline mode nothing is cut away, and nothing filled */
    } cases[] = {{10, 10, 1, "top", ""},       {75, 10, 1, "ground", ""},     {30, 30, 1, "ground", ""},
                 {10, 60, 1, "line", "line"},  {30, 60, 1, "ground", "line"}, {90, 60, 1, "ground", "line"},
                 {45, 90, 1, "dot", ""},       {52, 90, 1, "ground", ""},     {17, 66, 9, "line", "line"},
                 {54, 90, 1, "ground", "dot"}, {10, 10, 30, "top", "top"}};
    bat_document *document = NULL;
    bat_svg_report report;
    bat_problem problem;
    bat_scene scene;
    const bat_isolation all = {0};
    assert_int_equal(xml_read(file, NULL, &document, &report, &problem), BAT_OK);
    bat_scene_init(&scene);
    for (int outline = 0; outline < 2; outline++) {
        bat_scene_look(&scene, outline, &all);
        assert_int_equal(bat_scene_sync(&scene, document, (uint64_t)outline + 1), BAT_OK);
        for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
            const double point[2] = {cases[i].x, cases[i].y};
            const int found = bat_pick_object(&scene, point, cases[i].within);
            const char *name = found < 0 ? "" : bat_object_name(bat_document_at(document, found));
            const char *expected = outline ? cases[i].outlined : cases[i].name;
            if (strcmp(name, expected) != 0)
                fail_msg("%g %g: %s, expected %s", cases[i].x, cases[i].y, name, expected);
        }
    }
    bat_scene_free(&scene);
    bat_document_free(document);
}

/* A stroke that swells from a fifth of its width to five times as much, and one beside it of the style's width. */
static void what_a_swelling_stroke_covers_is_picked(void **state) {
    (void)state;
    static const bat_width_stop stops[] = {{0, 0.2}, {1, 5}};
    static const struct {
        double x, y;
        int found;
    } cases[] = {{90, 20, 0}, {90, 60, -1}, {10, 7, -1},  {10, 0.5, 0}, {10, 1.8, 0},
                 {50, 12, 0}, {50, 30, -1}, {50, 106, 1}, {50, 112, -1}};
    bat_document *document = NULL;
    bat_object *swelling = NULL;
    bat_scene scene;
    bat_document_create(&document);
    bat_style style = bat_style_defaults();
    style.stroked = true, style.filled = false, style.width = 16;
    for (int i = 0; i < 2; i++) {
        const double points[4] = {0, 100.0 * i, 100, 100.0 * i};
        bat_curve *line = NULL;
        bat_object *object = NULL;
        assert_int_equal(bat_curve_create_clamped(2, 1, 2, points, &line), BAT_OK);
        assert_int_equal(bat_object_create_path(bat_document_new_id(document), "", &style, 1, &line, &object),
                         BAT_OK);
        if (i == 0) {
            const bat_paint paint = {.width_count = 2, .widths = stops};
            assert_int_equal(bat_object_with_paint(object, &paint, &swelling), BAT_OK);
            bat_object_release(object);
            object = swelling;
        }
        assert_int_equal(bat_document_insert(document, i, object), BAT_OK);
        bat_object_release(object);
    }
    bat_scene_init(&scene);
    assert_int_equal(bat_scene_sync(&scene, document, 1), BAT_OK);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double point[2] = {cases[i].x, cases[i].y};
        const int found = bat_pick_object(&scene, point, 2);
        if (found != cases[i].found) fail_msg("%g %g: %d", point[0], point[1], found);
    }
    bat_scene_free(&scene);
    bat_document_free(document);
}

/* A change rebuilds what it changes: other items keep their versions, and the dirty box covers it. */
static void scene_keeps_what_stays(void **state) {
    (void)state;
    bat_document *document = NULL;
    bat_scene scene;
    bat_document_create(&document);
    for (int i = 0; i < 20; i++) pen_add(document, pen_curve(0, 50 * i, 10, 0, 11));
    bat_scene_init(&scene);
    assert_int_equal(bat_scene_sync(&scene, document, 1), BAT_OK);
    uint32_t versions[20];
    for (int i = 0; i < 20; i++) versions[i] = scene.items[i].version;
    bat_box_clear(scene.dirty);
    bat_object *moved = NULL;
    assert_int_equal(
        bat_object_with_curve(bat_document_at(document, 7), 0, pen_curve(200, 350, 10, 0, 11), &moved),
        BAT_OK);
    bat_document_replace(document, 7, moved);
    bat_object_release(moved);
    assert_int_equal(bat_scene_sync(&scene, document, 2), BAT_OK);
    for (int i = 0; i < 20; i++) assert_int_equal(scene.items[i].version == versions[i], i != 7);
    assert_true(scene.dirty[0] <= 0 && scene.dirty[2] >= 300 && scene.dirty[1] > 300 && scene.dirty[3] < 400);

    bat_document_remove(document, 3);
    assert_int_equal(bat_scene_sync(&scene, document, 3), BAT_OK);
    assert_int_equal(scene.item_count, 19);
    for (int i = 0; i < 19; i++)
        if (i != 6) assert_int_equal(scene.items[i].version, versions[i < 3 ? i : i + 1]);
    bat_scene_free(&scene);
    bat_document_free(document);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(against_brute_force),
        cmocka_unit_test(front_and_ends),
        cmocka_unit_test(what_is_cut_away_is_not_picked),
        cmocka_unit_test(what_a_swelling_stroke_covers_is_picked),
        cmocka_unit_test(scene_keeps_what_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
