/* The invariants checked after every event: each part of an editor is damaged by hand, the checker names it, and
 * reports nothing once it is repaired. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "document/object.h"
#include "editor/editor.h"
#include "support/pen.h"

static void named(bat_editor *editor, const char *wanted, const char *what) {
    const char *wrong = bat_editor_check(editor);
    if (!wrong || strcmp(wrong, wanted) != 0) fail_msg("%s: %s", what, wrong ? wrong : "nothing is found");
}

/* Damages a place by a value, and repairs it. */
#define DAMAGED(editor, place, value, wanted)                                                                \
    do {                                                                                                     \
        const __typeof__(place) kept_ = place;                                                               \
        place = value;                                                                                       \
        named(editor, wanted, #place " = " #value);                                                          \
        place = kept_;                                                                                       \
        assert_null(bat_editor_check(editor));                                                               \
    } while (0)

static bat_editor *session(void) {
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    pen_line(&p, 300, 400, 600, 400, 30);
    bat_editor_frame(editor);
    assert_null(bat_editor_check(editor));
    return editor;
}

static void of_the_view(void **state) {
    (void)state;
    bat_editor *e = session();
    bat_view *view = &e->stage.view;
    static const char zoom[] = "the zoom is out of its limits", reach[] = "the view is out of reach",
                      angle[] = "the view's angle is out of range",
                      size[] = "the window's size is out of range";
    DAMAGED(e, view->zoom, 0, zoom);
    DAMAGED(e, view->zoom, 1e300, zoom);
    DAMAGED(e, view->zoom, NAN, zoom);
    DAMAGED(e, view->x, NAN, reach);
    DAMAGED(e, view->x, -1e300, reach);
    DAMAGED(e, view->y, 1e300, reach);
    DAMAGED(e, view->angle, -180, angle);
    DAMAGED(e, view->angle, 181, angle);
    DAMAGED(e, view->cosine, 0.5, angle);
    DAMAGED(e, view->sine, NAN, angle);
    DAMAGED(e, view->width, -1, size);
    DAMAGED(e, view->width, 1e9, size);
    DAMAGED(e, view->height, -1, size);
    DAMAGED(e, view->height, NAN, size);
    DAMAGED(e, view->height, 1e9, size);
    bat_editor_free(e);
}

static void of_the_scene(void **state) {
    (void)state;
    bat_editor *e = session();
    bat_scene *scene = &e->scene;
    DAMAGED(e, scene->count, scene->count - 1, "the scene has another number of objects");
    DAMAGED(e, scene->entries[0].object, scene->entries[1].object, "the scene shows another object");
    assert_true(scene->entries[0].item.path_count > 0);
    DAMAGED(e, scene->entries[0].path, NULL, "an item has no path");
    /* What is due for the next frame is not looked at. */
    const int count = scene->count;
    scene->stale = true, scene->count = 0;
    assert_null(bat_editor_check(e));
    scene->stale = false, scene->count = count;
    bat_editor_free(e);
}

static void of_contacts(void **state) {
    (void)state;
    bat_editor *e = session();
    bat_contacts *contacts = &e->input.contacts;
    for (uint32_t i = 0; i < 3; i++)
        contacts->list[i] = (bat_contact){.id = i, .device = BAT_DEVICE_TOUCH, .duty = BAT_DUTY_NAVIGATE};
    contacts->count = 2;
    assert_null(bat_editor_check(e));
    DAMAGED(e, contacts->count, 3, "more than two contacts navigate");
    DAMAGED(e, contacts->list[1].id, 0, "a contact is there twice");
    contacts->list[0].duty = BAT_DUTY_TOOL;
    assert_null(bat_editor_check(e));
    DAMAGED(e, contacts->list[1].duty, BAT_DUTY_TOOL, "two contacts drive the tool");
    contacts->list[1].id = 0;
    contacts->list[1].device = BAT_DEVICE_PEN; /* devices number theirs apart */
    assert_null(bat_editor_check(e));
    contacts->count = 0;
    bat_editor_free(e);
}

static void of_the_session(void **state) {
    (void)state;
    bat_editor *e = session();
    bat_session *s = &e->session;
    static const char history[] = "the history is out of step",
                      journal[] = "the journal does not end with a line";
    DAMAGED(e, s->history.done, -1, history);
    DAMAGED(e, s->history.done, s->history.count + 1, history);
    DAMAGED(e, s->history.count, BAT_HISTORY_ROOM + 1, history);
    DAMAGED(e, s->journal.size, 0, journal);
    DAMAGED(e, s->journal.size, s->journal.size - 1, journal);
    DAMAGED(e, s->transaction.open, true, "a transaction is open and nobody holds it");
    DAMAGED(e, e->settings.values[BAT_PROPERTY_TOLERANCE], -1, "a property is out of its range");
    DAMAGED(e, e->settings.values[BAT_PROPERTY_TOLERANCE], 1e9, "a property is out of its range");
    bat_editor_select(e, 1, false);
    bat_document *document = s->document;
    bat_document *none = NULL;
    assert_int_equal(bat_document_create(&none), BAT_OK);
    s->document = none;
    e->scene.stale = true;
    named(e, "the selection has objects that are not in the document", "another document");
    s->document = document;
    e->scene.stale = false;
    assert_null(bat_editor_check(e));
    bat_document_free(none);
    bat_editor_free(e);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(of_the_view), cmocka_unit_test(of_the_scene),
                                       cmocka_unit_test(of_contacts), cmocka_unit_test(of_the_session)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
