/* The clipboard: copies are pasted bit for bit except for position and ids; SVG of other programs; each paste is one
 * undo step; every allocation may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include "curve/curve.h"
#include "editor/editor.h"
#include "support/alloc_fail.h"
#include "support/editing.h"
#include "support/pictures.h"
#include "support/xml.h"
#include <batten/bezier.h>

static int count(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }
static const bat_object *object(const bat_editor *editor, int i) {
    return bat_document_at(bat_editor_document(editor), i);
}

static bat_document *read_svg(const char *text, bool *own) {
    bat_document *document = NULL;
    bat_problem problem = {"", ""};
    bat_svg_report report;
    if (xml_read(text, NULL, &document, &report, &problem) != BAT_OK) fail_msg("%s", problem.message);
    *own = report.native;
    return document;
}

static bat_status paste_text(bat_editor *editor, const char *text) {
    bool own;
    bat_document *document = read_svg(text, &own);
    bat_status status = bat_editor_paste(editor, document, own);
    bat_document_free(document);
    return status;
}

static char *copied(bat_editor *editor, bool cut) {
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_editor_copy(editor, cut, &text, &size), BAT_OK);
    assert_int_equal(strlen(text), size);
    return text;
}

/* Same knots; the points moved by (dx, dy), to rounding. */
static void expect_moved(const bat_object *a, const bat_object *b, double dx, double dy) {
    assert_int_equal(bat_object_kind(a), bat_object_kind(b));
    assert_int_equal(bat_object_curve_count(a), bat_object_curve_count(b));
    for (int i = 0; i < bat_object_curve_count(a); i++) {
        const bat_curve *c = bat_object_curve(a, i), *d = bat_object_curve(b, i);
        assert_int_equal(bat_curve_knot_count(c), bat_curve_knot_count(d));
        assert_memory_equal(bat_curve_knots(c), bat_curve_knots(d),
                            (size_t)bat_curve_knot_count(c) * sizeof(double));
        for (int k = 0; k < 2 * bat_point_count(c); k++)
            assert_true(fabs(bat_curve_points(d)[k] - bat_curve_points(c)[k] - (k % 2 ? dy : dx)) < 1e-9);
    }
}

static void between_windows(void **unused) {
    (void)unused;
    bat_editor *from = pen_editor(), *to = pen_editor();
    bat_editor_command(from, "select-all");
    bat_editor_command(from, "group");
    uint64_t before = digest(from), fresh = digest(to);
    char *text = copied(from, false);
    assert_true(digest(from) == before); /* copying is no step */
    assert_int_equal(paste_text(to, text), BAT_OK);
    assert_int_equal(count(to), 5);
    assert_int_equal(bat_object_kind(object(to, 2)), BAT_KIND_GROUP);
    for (int i = 1; i < 3; i++) {
        expect_moved(object(from, i), object(to, 2 + i), 10, 10);
        assert_true(bat_object_parent(object(to, 2 + i)) == bat_object_id(object(to, 2)));
    }
    assert_int_equal(to->choice.selection.count, 1);
    assert_true(bat_selection_has(&to->choice.selection, bat_object_id(object(to, 2))));
    /* Again: further off; with Shift: in place. */
    assert_int_equal(paste_text(to, text), BAT_OK);
    expect_moved(object(from, 1), object(to, 6), 20, 20);
    bat_editor_key(to, "Shift", true, BAT_SHIFT, 0);
    assert_int_equal(paste_text(to, text), BAT_OK);
    expect_moved(object(from, 1), object(to, 9), 0, 0);
    bat_editor_key(to, "Shift", false, 0, 0);
    bat_editor_command(to, "paste-in-place");
    assert_true(bat_editor_frame(to)->requests & BAT_ASK_PASTE);
    assert_int_equal(paste_text(to, text), BAT_OK);
    expect_moved(object(from, 1), object(to, 12), 0, 0);
    assert_null(bat_editor_check(to));
    replays(to, 0);
    for (int i = 0; i < 4; i++) assert_int_equal(bat_editor_command(to, "undo"), BAT_OK);
    assert_true(digest(to) == fresh);
    bat_free(text);
    bat_editor_free(from);
    bat_editor_free(to);
}

/* Cut takes away in one step; pasted again it is where it was; the next one is off by the step. */
static void cut_and_paste(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    const bat_object *kept = bat_object_retain(object(editor, 0));
    bat_editor_select(editor, bat_object_id(kept), false);
    uint64_t fresh = digest(editor);
    char *text = copied(editor, true);
    assert_int_equal(count(editor), 1);
    assert_int_equal(paste_text(editor, text), BAT_OK);
    expect_moved(kept, object(editor, 1), 0, 0);
    assert_int_equal(paste_text(editor, text), BAT_OK);
    expect_moved(kept, object(editor, 2), 10, 10);
    for (int i = 0; i < 3; i++) bat_editor_command(editor, "undo");
    assert_true(digest(editor) == fresh);
    bat_free(text);
    bat_object_release((bat_object *)kept);
    bat_editor_free(editor);
}

static void lands_in_the_active_layer(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    bat_editor_select(editor, bat_object_id(object(editor, 0)), false);
    char *text = copied(editor, false);
    bat_editor_command(editor, "layer-add");
    bat_id layer = editor->choice.layer;
    assert_int_equal(paste_text(editor, text), BAT_OK);
    assert_true(bat_object_parent(object(editor, count(editor) - 1)) == layer);
    bat_free(text);
    /* A layer is pasted as what is in it. */
    bat_editor_select(editor, layer, false);
    text = copied(editor, false);
    assert_int_equal(paste_text(editor, text), BAT_OK);
    int layers = 0;
    for (int i = 0; i < count(editor); i++) layers += bat_object_kind(object(editor, i)) == BAT_KIND_LAYER;
    assert_int_equal(layers, 1);
    assert_true(bat_object_parent(object(editor, count(editor) - 1)) == layer);
    bat_free(text);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* As Figma, Illustrator and Inkscape give it: at the pointer, with viewBox and transforms. */
static void of_other_programs(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    double box[4];
    pen_event(&p, BAT_POINTER_HOVER, 300, 250);
    assert_int_equal(
        paste_text(editor, "<svg width=\"20\" height=\"10\" viewBox=\"0 0 20 10\" fill=\"none\" "
                           "xmlns=\"http://www.w3.org/2000/svg\"><g transform=\"translate(5 5) scale(2)\">"
                           "<path d=\"M0 0H10V20H0Z\" fill=\"#D9D9D9\"/></g></svg>"),
        BAT_OK);
    bat_object_bounds(object(editor, 2), box);
    /* 20 wide, 40 high, its middle under the pointer. */
    double at[2];
    bat_view_to_document(&editor->stage.view, (double[]){300, 250}, at);
    assert_true(fabs(box[0] - (at[0] - 10)) < 1e-9 && fabs(box[3] - (at[1] + 20)) < 1e-9);
    assert_int_equal(bat_object_style(object(editor, 2))->fill, 0xd9d9d9ff);
    /* The pointer is elsewhere: in the middle of the view. */
    pen_event(&p, BAT_POINTER_LEAVE, 0, 0);
    assert_int_equal(paste_text(editor, "<svg><path d=\"M0 0H10\"/></svg>"), BAT_OK);
    bat_object_bounds(object(editor, 3), box);
    bat_view_to_document(&editor->stage.view, (double[]){500, 400}, at);
    assert_true(fabs(box[0] / 2 + box[2] / 2 - at[0]) < 1e-9 && fabs(box[1] - at[1]) < 1e-9);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* Of ours, but out of sight: in the middle. */
static void never_out_of_sight(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    double box[4], at[2];
    bat_editor_select(editor, bat_object_id(object(editor, 0)), false);
    char *text = copied(editor, false);
    bat_editor_wheel(editor, 100, 100, 5000, 0, 0, 0);
    assert_int_equal(paste_text(editor, text), BAT_OK);
    bat_object_bounds(object(editor, 2), box);
    bat_view_to_document(&editor->stage.view, (double[]){500, 400}, at);
    assert_true(fabs(box[0] / 2 + box[2] / 2 - at[0]) < 1e-6);
    bat_free(text);
    bat_editor_free(editor);
}

static void nothing_to_do(void **unused) {
    (void)unused;
    bat_editor *editor = pen_editor();
    uint64_t fresh = digest(editor);
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_editor_copy(editor, true, &text, &size), BAT_STATE);
    assert_null(text);
    assert_int_equal(bat_editor_copy(editor, false, NULL, &size), BAT_ARGUMENT);
    assert_int_equal(paste_text(editor, "<svg><g/></svg>"), BAT_STATE);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "holds no drawing"));
    assert_int_equal(bat_editor_paste(editor, NULL, false), BAT_ARGUMENT);
    assert_true(digest(editor) == fresh);
    /* Ctrl+C is the host's own; by another key the host is asked. */
    assert_false(bat_editor_key(editor, "c", true, BAT_CTRL, 0));
    assert_false(bat_editor_key(editor, "v", true, BAT_META, 0));
    assert_int_equal(bat_editor_frame(editor)->requests, 0);
    assert_int_equal(bat_editor_bind(editor, "copy", "Y"), BAT_OK);
    assert_true(bat_editor_key(editor, "y", true, 0, 0));
    assert_int_equal(bat_editor_frame(editor)->requests, BAT_ASK_COPY);
    bat_editor_free(editor);
}

static void with_pictures(void **unused) {
    (void)unused;
    bat_editor *from = pen_editor(), *to = pen_editor();
    unsigned char bytes[HEAD_ROOM];
    size_t size = head_png(bytes, 40, 30);
    assert_int_equal(bat_editor_add_picture(from, bytes, size, "p"), BAT_OK);
    char *text = copied(from, false);
    assert_int_equal(paste_text(to, text), BAT_OK);
    const bat_picture *picture = bat_object_picture(object(to, 2));
    size_t back;
    assert_non_null(picture);
    assert_memory_equal(bat_picture_bytes(picture, &back), bytes, size);
    replays(to, 0);
    bat_free(text);
    bat_editor_free(from);
    bat_editor_free(to);
}

static void failing_allocations(void **unused) {
    (void)unused;
    bool own, done = false;
    bat_editor *source = pen_editor();
    bat_editor_command(source, "select-all");
    bat_editor_command(source, "group");
    char *text = copied(source, false);
    bat_document *document = read_svg(text, &own);
    bat_editor_frame(source);
    for (int n = 1; !done; n++) { /* copying, and cutting */
        char *again = NULL;
        size_t size;
        uint64_t before = digest(source);
        long live = alloc_live();
        alloc_fail_at(n);
        bat_status status = bat_editor_copy(source, n % 2, &again, &size);
        done = !alloc_fail_reached();
        if (status == BAT_OK) {
            bat_free(again);
            if (n % 2) bat_editor_command(source, "undo");
            bat_editor_command(source, "select-all");
        } else {
            assert_int_equal(status, BAT_MEMORY);
            assert_null(again);
            assert_true(alloc_live() <= live + 2); /* the transaction keeps its room */
        }
        assert_true(digest(source) == before);
        assert_null(bat_editor_check(source));
    }
    for (int n = 1;; n++) {
        long live = alloc_live();
        bat_editor *editor = pen_editor();
        uint64_t fresh = digest(editor);
        alloc_fail_at(n);
        bat_status status = bat_editor_paste(editor, document, own);
        bool reached = alloc_fail_reached();
        if (status != BAT_OK) {
            assert_int_equal(status, BAT_MEMORY);
            assert_true(digest(editor) == fresh);
        }
        assert_null(bat_editor_check(editor));
        bat_editor_free(editor);
        assert_int_equal(alloc_live(), live);
        if (!reached) {
            assert_int_equal(status, BAT_OK);
            break;
        }
    }
    bat_document_free(document);
    bat_free(text);
    bat_editor_free(source);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(between_windows),    cmocka_unit_test(cut_and_paste),
        cmocka_unit_test(of_other_programs),  cmocka_unit_test(lands_in_the_active_layer),
        cmocka_unit_test(never_out_of_sight), cmocka_unit_test(nothing_to_do),
        cmocka_unit_test(with_pictures),      cmocka_unit_test(failing_allocations),
    };
    return cmocka_run_group_tests_name("clipboard", tests, NULL, NULL);
}
