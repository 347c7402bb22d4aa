/*
 * A blend and a matched end that are shown before they are made: their joints are as continuous as chosen; the drawing stays as it is
 * to the bit until they are kept, which is one step that can be undone and replayed.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"
#include <batten/blend.h>
#include <batten/paint.h>
#include <batten/panels.h>
#include <math.h>
#include <string.h>

static bat_curve *open_curve(const double points[8]) {
    bat_curve *curve;
    assert_int_equal(bat_curve_create_clamped(2, 3, 4, points, &curve), BAT_OK);
    return curve;
}

/* Two bends (1, 2), whose near ends are 1's end and 2's end, and a box (3). */
static bat_editor *bends(void) {
    const double box[8] = {100, 700, 300, 700, 300, 900, 100, 900}, knots[5] = {0, 1, 2, 3, 4};
    bat_curve *closed;
    assert_int_equal(bat_curve_create(2, 1, true, 4, box, 5, knots, &closed), BAT_OK);
    bat_curve *curves[3] = {open_curve((double[]){100, 100, 150, 220, 250, 250, 350, 200}),
                            open_curve((double[]){900, 400, 800, 300, 700, 300, 600, 400}), closed};
    bat_editor *editor = editor_with(3, curves);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    return editor;
}

static bool shows(bat_editor *editor, bat_role role) {
    return pen_live(bat_editor_frame(editor), role) != NULL;
}

static void says(bat_editor *editor, const char *words) {
    const char *readings = bat_editor_readings(editor);
    if (!strstr(readings, words)) fail_msg("%s, not %s", readings, words);
}

/* The joint of two ends is as continuous as asked, and no more. */
static void joins(const bat_curve *a, bool a_end, const bat_curve *b, bool b_end, int continuity) {
    static const double none[4] = {1e-9, 1e-9, 1e-9 / 200, 1e-7 / (200 * 200)}; /* sizes of 200 */
    double jump[4];
    assert_int_equal(bat_curve_jump(a, a_end, b, b_end, jump), BAT_OK);
    for (int k = 0; k < 4; k++) assert_int_equal(jump[k] <= none[k], k <= continuity);
}

/* Each end with its own continuity. */
static void blends_are_kept(void **state) {
    (void)state;
    for (int pair = 0; pair < 16; pair++) {
        const int continuity = pair % 4, second = pair / 4;
        bat_editor *editor = bends();
        const uint64_t first = digest(editor);
        only(editor, 1, 2);
        assert_int_equal(bat_editor_command(editor, "curve-blend"), BAT_OK);
        says(editor, "\"chosen\":2,\"amount\":0.5,\"other\":0.5,\"of\":\"blend\",\"also\":6,");
        assert_true(shows(editor, BAT_ROLE_FIT) && shows(editor, BAT_ROLE_COMB));
        assert_int_equal(bat_editor_read_as(editor, continuity), BAT_OK);
        assert_int_equal(bat_editor_read_as(editor, 4 + second), BAT_OK);
        assert_int_equal(bat_editor_refit(editor, 0.4, true), BAT_OK);
        assert_int_equal(bat_editor_refit_other(editor, 0.7, true), BAT_OK);
        assert_true(digest(editor) == first);
        assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
        assert_true(!shows(editor, BAT_ROLE_FIT) && selected(editor) == 1);
        const bat_id made = editor->choice.selection.ids[0];
        assert_true(made != 1 && made != 2);
        joins(curve(editor, 1), true, curve(editor, made), false, continuity);
        joins(curve(editor, made), true, curve(editor, 2), true, second);
        goes_back_and_replays(editor, first);
        bat_editor_free(editor);
    }
}

/* How fast a cubic's ends are left and reached: the lengths of its handles over that of its chord. */
static void handles(const bat_curve *curve, double share[2]) {
    const double *p = bat_curve_points(curve), chord = hypot(p[6] - p[0], p[7] - p[1]);
    share[0] = hypot(p[2] - p[0], p[3] - p[1]) / chord;
    share[1] = hypot(p[6] - p[4], p[7] - p[5]) / chord;
}

/* Each slider is about its own end, which bears its number in the drawing. */
static void each_end_has_its_slider(void **state) {
    (void)state;
    double usual[2], now[2];
    for (int k = 0; k < 3; k++) { /* none, the first, the second */
        bat_editor *editor = bends();
        only(editor, 1, 2);
        assert_int_equal(bat_editor_command(editor, "curve-blend"), BAT_OK);
        for (int end = 0; end < 2; end++) assert_int_equal(bat_editor_read_as(editor, 4 * end + 1), BAT_OK);
        if (k == 1) assert_int_equal(bat_editor_refit(editor, 0.75, true), BAT_OK);
        if (k == 2) assert_int_equal(bat_editor_refit_other(editor, 0.75, true), BAT_OK);
        const bat_frame *frame = bat_editor_frame(editor);
        int numbers = 0;
        for (uint32_t i = 0; i < frame->label_count; i++)
            numbers += !strcmp(frame->labels[i].text, "1") || !strcmp(frame->labels[i].text, "2");
        assert_int_equal(numbers, 2);
        assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
        handles(curve(editor, editor->choice.selection.ids[0]), k ? now : usual);
        if (k == 1) assert_true(now[0] > 1.2 * usual[0] && fabs(now[1] - usual[1]) < 1e-9);
        if (k == 2) assert_true(now[1] > 1.2 * usual[1] && fabs(now[0] - usual[0]) < 1e-9);
        bat_editor_free(editor);
    }
}

/* Two curves in space, and one in space with a planar one, meet in space; in a tilted view the comb is seen, too. */
static void curves_in_space_meet(void **state) {
    (void)state;
    const double first[12] = {100, 100, 0, 150, 220, 40, 250, 250, 90, 350, 200, 60},
                 second[12] = {900, 400, -50, 800, 300, 20, 700, 300, 120, 600, 400, 80};
    for (int flat = 0; flat < 2; flat++)
        for (int match = 0; match < 2; match++) {
            bat_curve *curves[2] = {flat ? open_curve((double[]){100, 100, 150, 220, 250, 250, 350, 200})
                                         : NULL};
            if (!flat) assert_int_equal(bat_curve_create_clamped(3, 3, 4, first, &curves[0]), BAT_OK);
            assert_int_equal(bat_curve_create_clamped(3, 3, 4, second, &curves[1]), BAT_OK);
            bat_editor *editor = editor_with(2, curves);
            const uint64_t before = digest(editor);
            assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
            only(editor, 1, 2);
            assert_int_equal(bat_editor_command(editor, "view-quarter"), BAT_OK);
            assert_int_equal(bat_editor_command(editor, match ? "curve-match" : "curve-blend"), BAT_OK);
            assert_true(shows(editor, BAT_ROLE_FIT) && shows(editor, BAT_ROLE_COMB));
            assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
            const bat_curve *a = curve(editor, match ? 1 : editor->choice.selection.ids[0]);
            joins(a, true, curve(editor, 2), true, 2);
            goes_back_and_replays(editor, before);
            bat_editor_free(editor);
        }
}

static void one_curve_meets_itself(void **state) {
    (void)state;
    bat_editor *editor = bends();
    only(editor, 1, 3);
    assert_int_equal(bat_editor_command(editor, "curve-blend"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    const bat_curve *made = curve(editor, editor->choice.selection.ids[0]);
    joins(curve(editor, 1), true, made, false, 2);
    joins(made, true, curve(editor, 1), false, 2);
    bat_editor_free(editor);
}

/* A bilinear sheet over x0 to x1 and 200 to 500, whose far edge is bent up; in space. */
static bat_object *sheet(bat_id id, double x0, double x1) {
    const double points[12] = {x0, 200, 0, x0, 500, 40, x1, 220, 60, x1, 480, 20}, knots[4] = {0, 0, 1, 1};
    const bat_style style = bat_style_defaults();
    bat_surface *surface = NULL;
    bat_object *object = NULL;
    assert_int_equal(bat_surface_create((const int[2]){1, 1}, (const bool[2]){false, false},
                                        (const size_t[2]){2, 2}, points, (const int[2]){4, 4}, knots, knots,
                                        &surface),
                     BAT_OK);
    assert_int_equal(bat_object_create_surface(id, "", &style, surface, &object), BAT_OK);
    bat_surface_free(surface);
    return object;
}

static bat_curve *across(const bat_surface *surface, double share) {
    bat_curve *line = NULL;
    assert_int_equal(bat_surface_isocurve(surface, BAT_U, share, &line), BAT_OK);
    return line;
}

/* The surface's line across at that share of v, on the blend at that of u. */
static void edges_join(const bat_surface *from, bool last, const bat_surface *made, bool end,
                       int continuity) {
    static const double none[4] = {1e-9, 1e-9, 1e-9 / 200, 1e-7 / (200 * 200)};
    for (int i = 0; i < 5; i++) {
        bat_curve *b = across(made, i / 4.0), *a = NULL;
        double jump[4];
        assert_int_equal(bat_surface_isocurve(from, BAT_V, i / 4.0, &a), BAT_OK);
        assert_int_equal(
            end ? bat_curve_jump(b, true, a, last, jump) : bat_curve_jump(a, last, b, false, jump), BAT_OK);
        for (int k = 0; k <= continuity; k++) assert_true(jump[k] <= none[k]);
        bat_curve_free(a), bat_curve_free(b);
    }
}

/* Two surfaces are joined at their nearest edges by a third, each with its own continuity; a surface and a curve, too. */
static void surfaces_are_joined(void **state) {
    (void)state;
    for (int curved = 0; curved < 2; curved++) {
        bat_document *document = NULL;
        assert_int_equal(bat_document_create(&document), BAT_OK);
        bat_document_set_page(document, (double[]){0, 0, 1000, 800});
        bat_object *objects[2] = {sheet(1, 100, 300), curved ? NULL : sheet(2, 600, 900)};
        for (int i = 0; i < 2 - curved; i++) {
            assert_int_equal(bat_document_insert(document, i, objects[i]), BAT_OK);
            bat_object_release(objects[i]);
        }
        if (curved) pen_add(document, open_curve((double[]){600, 200, 650, 300, 650, 400, 600, 500}));
        bat_editor *editor = editor_of(document);
        assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
        assert_int_equal(bat_editor_command(editor, "select-all"), BAT_OK);
        const uint64_t first = digest(editor);
        assert_int_equal(bat_editor_command(editor, "curve-blend"), BAT_OK);
        assert_true(shows(editor, BAT_ROLE_FIT) && shows(editor, BAT_ROLE_COMB));
        assert_int_equal(bat_editor_read_as(editor, 1), BAT_OK);
        assert_int_equal(bat_editor_read_as(editor, 4 + 3), BAT_OK);
        assert_int_equal(bat_editor_refit(editor, 0.6, true), BAT_OK);
        assert_true(digest(editor) == first);
        assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
        assert_true(selected(editor) == 1 && digest(editor) != first);
        const bat_surface *made = bat_object_surface(object(editor, editor->choice.selection.ids[0]));
        assert_non_null(made);
        edges_join(bat_object_surface(object(editor, 1)), true, made, false, 1);
        if (!curved) edges_join(bat_object_surface(object(editor, 2)), false, made, true, 3);
        goes_back_and_replays(editor, first);
        bat_editor_free(editor);
    }
}

/* The lower of two surfaces gets another edge. */
static void edges_are_matched(void **state) {
    (void)state;
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    for (int i = 0; i < 2; i++) {
        bat_object *added = sheet((bat_id)(i + 1), i ? 600 : 100, i ? 900 : 300);
        assert_int_equal(bat_document_insert(document, i, added), BAT_OK);
        bat_object_release(added);
    }
    bat_editor *editor = editor_of(document);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "select-all"), BAT_OK);
    const uint64_t first = digest(editor);
    assert_int_equal(bat_editor_command(editor, "curve-match"), BAT_OK);
    assert_true(shows(editor, BAT_ROLE_FIT) && shows(editor, BAT_ROLE_COMB));
    assert_int_equal(bat_editor_read_as(editor, 3), BAT_OK);
    assert_int_equal(bat_editor_refit(editor, 0.6, true), BAT_OK);
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    assert_true(digest(editor) != first && selected(editor) == 2);
    const bat_surface *made = bat_object_surface(object(editor, 1)),
                      *other = bat_object_surface(object(editor, 2));
    for (int i = 0; i < 5; i++) {
        bat_curve *a = NULL, *b = NULL;
        double jump[4];
        assert_int_equal(bat_surface_isocurve(made, BAT_V, i / 4.0, &a), BAT_OK);
        assert_int_equal(bat_surface_isocurve(other, BAT_V, i / 4.0, &b), BAT_OK);
        assert_int_equal(bat_curve_jump(a, true, b, false, jump), BAT_OK);
        assert_true(jump[0] < 1e-9 && jump[1] < 1e-9 && jump[2] < 1e-11 && jump[3] < 1e-11);
        bat_curve_free(a), bat_curve_free(b);
    }
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

static void ends_are_matched(void **state) {
    (void)state;
    bat_editor *editor = bends();
    const uint64_t first = digest(editor);
    only(editor, 1, 2);
    assert_int_equal(bat_editor_command(editor, "curve-match"), BAT_OK);
    says(editor, "\"of\":\"match\"");
    assert_int_equal(bat_editor_command(editor, "reading-next"), BAT_OK);
    says(editor, "\"chosen\":3,");
    assert_true(shows(editor, BAT_ROLE_COMB) && digest(editor) == first);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    joins(curve(editor, 1), true, curve(editor, 2), true, 3);
    double at[2];
    bat_curve_eval(curve(editor, 1), 0, 0, at);
    assert_true(at[0] == 100 && at[1] == 100);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

static void what_is_left_changes_nothing(void **state) {
    (void)state;
    bat_editor *editor = bends();
    const uint64_t first = digest(editor);
    only(editor, 1, 2);
    assert_int_equal(bat_editor_command(editor, "curve-match"), BAT_OK);
    static const double odd[] = {NAN, -0.01, 1.01};
    for (size_t i = 0; i < 3; i++) assert_int_equal(bat_editor_refit(editor, odd[i], true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_read_as(editor, 5), BAT_ARGUMENT);
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    assert_true(digest(editor) == first && !shows(editor, BAT_ROLE_FIT));
    only(editor, 1, 3); /* one open curve meets nothing; none is nothing */
    assert_int_equal(bat_editor_command(editor, "curve-match"), BAT_STATE);
    only(editor, 3, 0);
    assert_int_equal(bat_editor_command(editor, "curve-blend"), BAT_STATE);
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_frame(editor)->readings, 0);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blends_are_kept),      cmocka_unit_test(each_end_has_its_slider),
        cmocka_unit_test(curves_in_space_meet), cmocka_unit_test(one_curve_meets_itself),
        cmocka_unit_test(surfaces_are_joined),  cmocka_unit_test(edges_are_matched),
        cmocka_unit_test(ends_are_matched),     cmocka_unit_test(what_is_left_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
