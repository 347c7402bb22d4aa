/* Layers: what they contain, hide and lock, and where new ones are inserted. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"

static void layers_hold_hide_and_lock(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    uint64_t first = digest(editor);
    assert_int_equal(bat_editor_command(editor, "layer-add"), BAT_OK); /* 3 */
    assert_int_equal(editor->choice.layer, 3);
    bat_editor_command(editor, "tool-sketch");
    pen_line(&p, 200, 400, 800, 400, 60); /* 4, into the layer */
    assert_string_equal(order(editor), "1 2 3 4");
    assert_int_equal(bat_object_parent(object(editor, 4)), 3);
    bat_editor_command(editor, "tool-select");
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "layer-take"), BAT_OK);
    assert_string_equal(order(editor), "2 3 4 1");
    bat_editor_command(editor, "layer-add"); /* 5 */
    bat_editor_activate_layer(editor, 3);
    assert_int_equal(bat_editor_command(editor, "layer-up"), BAT_OK);
    assert_string_equal(order(editor), "2 5 3 4 1");
    assert_int_equal(bat_editor_command(editor, "layer-up"), BAT_STATE);
    bat_editor_command(editor, "layer-down");
    bat_editor_command(editor, "layer-down");
    assert_string_equal(order(editor), "3 4 1 2 5");
    assert_int_equal(bat_editor_rename(editor, 3, "T\xc3\xbcr"), BAT_OK);
    assert_int_equal(bat_editor_rename(editor, 3, "\xff"), BAT_ARGUMENT);
    assert_string_equal(
        bat_editor_layers(editor),
        "{\"layers\":[{\"id\":3,\"name\":\"T\xc3\xbcr\",\"hidden\":false,\"locked\":false,\"depth\":0,"
        "\"members\":2},{\"id\":5,\"name\":\"Layer 2\",\"hidden\":false,\"locked\":false,\"depth\":0,"
        "\"members\":0}],\"active\":3,\"loose\":1,\"pictures\":0,\"aids\":[]}");
    /* A layer's contents are taken one by one. */
    click(&p, 500, 200, 0);
    assert_true(selected(editor) == 1 && has(editor, 1));
    /* Locked: seen, not selected, not picked, not redrawn. */
    assert_int_equal(bat_editor_set_state(editor, 3, false, true), BAT_OK);
    assert_int_equal(selected(editor), 0);
    click(&p, 500, 200, 0);
    assert_int_equal(selected(editor), 0);
    bat_editor_command(editor, "select-all");
    assert_true(selected(editor) == 1 && has(editor, 2));
    assert_int_equal(bat_editor_frame(editor)->still_count, 1 + 3);
    bat_editor_command(editor, "tool-sketch");
    bat_editor_activate_layer(editor, 5);
    pen_line(&p, 300, 200, 600, 205, 10);
    assert_int_equal(bat_document_count(editor->session.document), 6); /* new, not redrawn */
    /* Hidden: not there. */
    bat_editor_set_state(editor, 3, true, false);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_int_equal(frame->still_count, 1 + 2);
    assert_true(frame->dirty[0] <= frame->dirty[2]);
    assert_null(bat_editor_check(editor));
    bat_editor_set_state(editor, 3, false, false);
    assert_int_equal(bat_editor_frame(editor)->still_count, 1 + 4);
    /* New curves do not vanish in a hidden layer. */
    bat_editor_set_state(editor, 5, true, false);
    pen_line(&p, 300, 700, 600, 705, 10);
    assert_int_equal(bat_object_parent(bat_document_at(editor->session.document, 6)), 0);
    bat_editor_activate_layer(editor, 3);
    assert_int_equal(bat_editor_command(editor, "layer-delete"), BAT_OK);
    assert_int_equal(editor->choice.layer, 0);
    assert_int_equal(bat_editor_command(editor, "layer-delete"), BAT_STATE);
    assert_int_equal(bat_editor_activate_layer(editor, 3), BAT_ARGUMENT);
    assert_int_equal(bat_document_count(editor->session.document), 4);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

/* Any layer to the place of any other: the order is as when it is taken out and put in there, whatever else lies
 * between; undo brings the old one back. */
static void layers_are_placed(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_id order[5],
        ids[4]; /* of the topmost objects in front of the loose one: layers, and a curve among them */
    for (int i = 0; i < 4; i++) {
        bat_editor_command(editor, "layer-add");
        ids[i] = editor->choice.layer;
        bat_editor_select(editor, bat_object_id(bat_document_at(editor->session.document, 0)), false);
        if (i == 1) bat_editor_command(editor, "layer-take");
        if (i == 2) bat_editor_command(editor, "order-front");
    }
    for (int i = 0, k = 0; i < bat_document_count(editor->session.document); i++)
        if (!bat_object_parent(bat_document_at(editor->session.document, i)))
            order[k++] = bat_object_id(bat_document_at(editor->session.document, i));
    uint64_t before = digest(editor);
    for (int from = 0; from < 4; from++)
        for (int to = 0; to < 4; to++) {
            bat_id expected[5], kept[5];
            int place = 0, k = 0;
            for (int i = 0; i < 5; i++) {
                if (order[i] == ids[to]) place = i;
                if (order[i] != ids[from]) kept[k++] = order[i];
            }
            for (int i = 0; i < 5; i++) expected[i] = i == place ? ids[from] : kept[i - (i > place)];
            bat_status status = bat_editor_place_layer(editor, ids[from], ids[to]);
            assert_int_equal(status, from == to ? BAT_STATE : BAT_OK);
            k = 0;
            for (int i = 0; i < bat_document_count(editor->session.document); i++) {
                const bat_object *object = bat_document_at(editor->session.document, i);
                if (!bat_object_parent(object)) assert_true(bat_object_id(object) == expected[k++]);
            }
            assert_int_equal(k, 5);
            assert_null(bat_editor_check(editor));
            if (status == BAT_OK) bat_editor_command(editor, "undo");
            assert_true(digest(editor) == before);
        }
    assert_int_equal(bat_editor_place_layer(editor, ids[0], 999), BAT_ARGUMENT);
    assert_int_equal(bat_editor_place_layer(editor, 999, ids[0]), BAT_ARGUMENT);
    bat_editor_free(editor);
}

/* Any object to the place of any other: into the group of that one and next to it, with all that it holds; refused where
 * it would be in itself, and layers stay where layers are. Undo brings the old order back. */
static void objects_are_placed(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    const bat_document *document = editor->session.document;
    pen p = pen_for(editor);
    bat_editor_command(editor, "select-all");
    bat_editor_command(editor, "group");
    bat_editor_command(editor, "tool-sketch");
    pen_line(&p, 300, 700, 600, 705, 10);
    bat_editor_command(editor, "layer-add");
    pen_line(&p, 300, 500, 600, 505, 10);
    pen_line(&p, 300, 600, 600, 605, 10);
    const uint64_t before = digest(editor);
    const int count = bat_document_count(document);
    bat_id ids[16];
    int moved = 0, refused = 0;
    assert_in_range(count, 6, 16);
    for (int i = 0; i < count; i++) ids[i] = bat_object_id(bat_document_at(document, i));
    for (int i = 0; i < count; i++)
        for (int k = 0; k < count; k++) {
            const int at = bat_document_find(document, ids[i]), to = bat_document_find(document, ids[k]);
            const int size = bat_document_end(document, at) - at;
            const bat_id parent = bat_object_parent(bat_document_at(document, to));
            const bat_status status = bat_editor_place_layer(editor, ids[i], ids[k]);
            assert_null(bat_editor_check(editor));
            assert_int_equal(bat_document_count(document), count);
            if (status != BAT_OK) {
                assert_int_equal(status, i == k ? BAT_STATE : BAT_ARGUMENT);
                assert_true(digest(editor) == before);
                refused++;
                continue;
            }
            const int now = bat_document_find(document, ids[i]), other = bat_document_find(document, ids[k]);
            assert_true(bat_object_parent(bat_document_at(document, now)) == parent);
            assert_int_equal(bat_document_end(document, now) - now, size);
            assert_true(now == bat_document_end(document, other) || other == bat_document_end(document, now));
            bat_editor_command(editor, "undo");
            assert_true(digest(editor) == before);
            moved++;
        }
    assert_true(moved > count && refused > count);
    bat_editor_free(editor);
}

/* Planes, saved views and cameras are listed, and are named and hidden as layers are. */
static void what_is_in_no_picture_has_a_name(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    bat_editor_command(editor, "orbit-up");
    assert_int_equal(bat_editor_command(editor, "view-save"), BAT_OK);    /* 3 */
    assert_int_equal(bat_editor_command(editor, "plane-facing"), BAT_OK); /* 4 */
    const uint64_t before = digest(editor);
    assert_int_equal(bat_editor_rename(editor, 3, "from \"above\""), BAT_OK);
    assert_int_equal(bat_editor_set_state(editor, 4, true, false), BAT_OK);
    const char *list = strstr(bat_editor_layers(editor), "\"aids\"");
    assert_string_equal(list, "\"aids\":[{\"id\":3,\"name\":\"from \\\"above\\\"\",\"kind\":\"view\","
                              "\"hidden\":false,\"locked\":false},{\"id\":4,\"name\":\"\",\"kind\":\"plane\","
                              "\"hidden\":true,\"locked\":false}]}");
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == before);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layers_hold_hide_and_lock),
        cmocka_unit_test(layers_are_placed),
        cmocka_unit_test(objects_are_placed),
        cmocka_unit_test(what_is_in_no_picture_has_a_name),
    };
    return cmocka_run_group_tests_name("layers", tests, NULL, NULL);
}
