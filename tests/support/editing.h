/* Common operations of editor tests: open a document, drag, tap, check invariants. Include after cmocka.h. */
#ifndef BATTEN_TESTS_EDITING_H
#define BATTEN_TESTS_EDITING_H

#include "document/document.h"
#include "format/seen/seen.h"
#include "support/pen.h"

static inline uint64_t digest(const bat_editor *editor) {
    return bat_document_digest(bat_editor_document(editor));
}

static inline void check(const bat_editor *editor) {
    const char *wrong = bat_editor_check(editor);
    if (wrong) fail_msg("%s", wrong);
}

/* An editor in a window of 1000 x 800 px at zoom 1, whose page lies on the floor; takes ownership of the document. */
static inline bat_editor *editor_of(bat_document *document) {
    bat_editor *editor = NULL;
    assert_int_equal(bat_editor_create(&editor), BAT_OK);
    bat_editor_resize(editor, 1000, 800, 1);
    if (bat_seen_in_space(document)) bat_document_set_stand(document, BAT_STAND_FLOOR);
    assert_int_equal(bat_editor_open(editor, document, "test"), BAT_OK);
    bat_editor_command(editor, "zoom-100");
    return editor;
}

/* An editor with the curves on a page as large as the window; takes ownership of them. */
static inline bat_editor *editor_with(int count, bat_curve **curves) {
    bat_document *document = NULL;
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    for (int i = 0; i < count; i++) pen_add(document, curves[i]);
    return editor_of(document);
}

static inline pen mouse(bat_editor *editor) {
    pen p = pen_for(editor);
    p.device = BAT_DEVICE_MOUSE;
    return p;
}

/* The pen approaches a second later, so that two taps are no double tap, goes down, and draws a straight line in eight
 * steps, one frame each. */
static inline void drag_to(pen *p, double x0, double y0, double x1, double y1) {
    p->time += 1000;
    pen_event(p, BAT_POINTER_HOVER, x0, y0);
    bat_editor_frame(p->editor);
    pen_event(p, BAT_POINTER_DOWN, x0, y0);
    for (int i = 1; i <= 8; i++) {
        pen_event(p, BAT_POINTER_MOVE, x0 + (x1 - x0) * i / 8, y0 + (y1 - y0) * i / 8);
        bat_editor_frame(p->editor);
        check(p->editor);
    }
}

/* As drag_to, then the pen is lifted. */
static inline void drag(pen *p, double x0, double y0, double x1, double y1) {
    drag_to(p, x0, y0, x1, y1);
    pen_event(p, BAT_POINTER_UP, x1, y1);
    bat_editor_frame(p->editor);
    check(p->editor);
}

static inline void tap(pen *p, double x, double y) {
    p->time += 1000;
    pen_event(p, BAT_POINTER_HOVER, x, y);
    bat_editor_frame(p->editor);
    pen_event(p, BAT_POINTER_DOWN, x, y);
    check(p->editor);
    bat_editor_frame(p->editor);
    pen_event(p, BAT_POINTER_UP, x, y);
    bat_editor_frame(p->editor);
    check(p->editor);
}

/* An editor that has replayed the other's journal and has the same document. session: named in the failure message. */
static inline bat_editor *replay_of(const bat_editor *editor, uint64_t session) {
    bat_editor *again = NULL;
    bat_problem problem = {"", ""};
    size_t size = 0;
    const char *journal = bat_editor_journal(editor, &size);
    assert_int_equal(bat_editor_create(&again), BAT_OK);
    if (bat_editor_replay(again, journal, size, true, &problem) != BAT_OK)
        fail_msg("session %d: %s: %s", (int)session, problem.place, problem.message);
    assert_true(digest(again) == digest(editor));
    return again;
}

static inline void replays(const bat_editor *editor, uint64_t session) {
    bat_editor_free(replay_of(editor, session));
}

/* Checks that the journal reproduces the document, undo leads to the first one and redo to the last. Returns the number
 * of steps. */
static inline int round_trip(bat_editor *editor, uint64_t first) {
    uint64_t last = digest(editor);
    int steps = 0;
    check(editor);
    replays(editor, 0);
    for (; bat_editor_command(editor, "undo") == BAT_OK; steps++) check(editor);
    assert_true(digest(editor) == first);
    while (bat_editor_command(editor, "redo") == BAT_OK) check(editor);
    assert_true(digest(editor) == last);
    return steps;
}

#endif
