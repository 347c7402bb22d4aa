/* Common operations of selection tests. Include after cmocka.h. */
#ifndef BATTEN_TESTS_SELECTING_H
#define BATTEN_TESTS_SELECTING_H

#include "editor/editor.h"
#include "support/editing.h"
#include <stdio.h>

static inline void drag_holding(pen *p, double x0, double y0, double x1, double y1, uint32_t modifiers) {
    p->modifiers = modifiers;
    drag(p, x0, y0, x1, y1);
    p->modifiers = 0;
}

static inline bat_editor *select_editor(void) {
    bat_editor *editor = pen_editor(); /* lines 1 (y = 200) and 2 (y = 600), x 200 to 800 */
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    return editor;
}

static inline void click(pen *p, double x, double y, uint32_t modifiers) {
    p->modifiers = modifiers;
    pen_event(p, BAT_POINTER_HOVER, x, y);
    pen_event(p, BAT_POINTER_DOWN, x, y);
    pen_event(p, BAT_POINTER_UP, x, y);
    p->modifiers = 0;
    assert_null(bat_editor_check(p->editor));
}

static inline int selected(const bat_editor *editor) { return editor->choice.selection.count; }

static inline bool has(const bat_editor *editor, bat_id id) {
    return bat_selection_has(&editor->choice.selection, id);
}

static inline void only(bat_editor *editor, bat_id a, bat_id b) {
    bat_editor_select(editor, a, false);
    if (b) bat_editor_select(editor, b, true);
}

static inline const bat_object *object(const bat_editor *editor, bat_id id) {
    return bat_document_at(editor->session.document, bat_document_find(editor->session.document, id));
}

static inline const bat_curve *curve(const bat_editor *editor, bat_id id) {
    return bat_object_curve(object(editor, id), 0);
}

/* The ids of the list, in order, as text. */
static inline const char *order(const bat_editor *editor) {
    static char text[200];
    size_t used = 0;
    text[0] = 0;
    for (int i = 0; i < bat_document_count(editor->session.document); i++)
        used += (size_t)snprintf(text + used, sizeof text - used, i ? " %d" : "%d",
                                 (int)bat_object_id(bat_document_at(editor->session.document, i)));
    return text;
}

static inline void box_of(const bat_editor *editor, bat_id id, double box[4]) {
    assert_non_null(object(editor, id));
    bat_object_bounds(object(editor, id), box);
}

static inline void expect_box(const bat_editor *editor, bat_id id, double x0, double y0, double x1,
                              double y1) {
    double box[4], expected[4] = {x0, y0, x1, y1};
    box_of(editor, id, box);
    for (int k = 0; k < 4; k++)
        if (fabs(box[k] - expected[k]) > 1e-9)
            fail_msg("box %g %g %g %g, not %g %g %g %g", box[0], box[1], box[2], box[3], x0, y0, x1, y1);
}

/* Undoes everything, redoes everything, replays: the digests agree at both ends. */
static inline void goes_back_and_replays(bat_editor *editor, uint64_t first) {
    uint64_t last = digest(editor);
    int steps = 0;
    while (bat_editor_command(editor, "undo") == BAT_OK) {
        steps++;
        assert_null(bat_editor_check(editor));
    }
    assert_true(digest(editor) == first);
    for (; steps > 0; steps--) assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    assert_true(digest(editor) == last);
    replays(editor, 0);
}

#endif
