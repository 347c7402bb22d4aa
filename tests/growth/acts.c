#include "acts.h"

#include <batten/batten.h>

#include <stdlib.h>

#include "support/pen.h"
#include "support/pictures.h"

static void frame(bat_editor *editor) { bat_editor_frame(editor); }

static void view_moved(bat_editor *editor) {
    bat_editor_wheel(editor, 500, 400, 3, 5, 0, 2000);
    bat_editor_frame(editor);
}

static void view_far_away(bat_editor *editor) {
    for (int i = 0; i < 40; i++) bat_editor_wheel(editor, 500, 400, 0, -300, BAT_CTRL, 2000);
    bat_editor_wheel(editor, 500, 400, 10000, 10000, 0, 2000);
    bat_editor_frame(editor);
}

static void resized(bat_editor *editor) {
    bat_editor_resize(editor, 700, 500, 2);
    bat_editor_frame(editor);
}

static void hovered(bat_editor *editor) {
    pen p = pen_for(editor);
    for (int i = 0; i < 4; i++) {
        pen_event(&p, BAT_POINTER_HOVER, 300 + 10 * i, 402);
        bat_editor_frame(editor);
    }
}

static void dragged(bat_editor *editor, double x, double y, uint32_t modifiers) {
    pen p = pen_for(editor);
    p.modifiers = modifiers;
    pen_event(&p, BAT_POINTER_HOVER, x, y);
    pen_stroke(&p, pen_arch, (double[]){x, y, x + 12, y + 6, 5}, 8);
    bat_editor_frame(editor);
}
static void on_a_line(bat_editor *editor) { dragged(editor, 401, 403, 0); }
static void a_copy_of_it(bat_editor *editor) { dragged(editor, 401, 403, BAT_ALT); }
static void zoom_out(bat_editor *editor) { /* what lies about the middle is seen then */
    for (int i = 0; i < 12; i++) bat_editor_command(editor, "zoom-out");
    bat_editor_frame(editor);
}
static void beside_all(bat_editor *editor) {
    zoom_out(editor);
    dragged(editor, 3, 795, BAT_SHIFT);
}
static void over_all(bat_editor *editor) {
    pen p = pen_for(editor);
    bat_editor_command(editor, "cancel");
    bat_editor_command(editor, "tool-select");
    zoom_out(editor);
    pen_stroke(&p, pen_arch, (double[]){999, 799, -10, -10, 0}, 16);
    bat_editor_frame(editor);
}

static void with_tool(bat_editor *editor, const char *tool, double y) {
    pen p = pen_for(editor);
    bat_editor_select(editor, 0, false);
    bat_editor_command(editor, tool);
    pen_event(&p, BAT_POINTER_HOVER, 350, y);
    bat_editor_frame(editor);
    pen_line(&p, 350, y, 450, y, 8);
    bat_editor_frame(editor);
}
static void sketched(bat_editor *editor) { with_tool(editor, "tool-sketch", 400); }
static void sketched_apart(bat_editor *editor) { with_tool(editor, "tool-sketch", -3000); }
static void smoothed(bat_editor *editor) { with_tool(editor, "tool-smooth", 400); }
static void rubbed_out(bat_editor *editor) { with_tool(editor, "tool-eraser", 400); }
static void points_dragged(bat_editor *editor) { with_tool(editor, "tool-points", 400); }
static void spline_drawn(bat_editor *editor) { with_tool(editor, "tool-tangents", 400); }
static void level_dragged(bat_editor *editor) { with_tool(editor, "tool-levels", 400); }
static void zoomed(bat_editor *editor) { with_tool(editor, "tool-zoom", 400); }
static void spanned(bat_editor *editor) { with_tool(editor, "tool-span", 400); }

static void snapped(bat_editor *editor) {
    static const char *const all[] = {"snap-curves", "snap-grid", "snap-crossings"};
    for (int i = 0; i < 3; i++) bat_editor_set(editor, all[i], 1);
    dragged(editor, 401, 403, 0);
}

static void clicked(bat_editor *editor) {
    pen p = pen_for(editor);
    for (int i = 0; i < 2; i++) {
        pen_event(&p, BAT_POINTER_DOWN, 401, 401);
        pen_event(&p, BAT_POINTER_UP, 401, 401);
    }
    bat_editor_frame(editor);
}

static void keys_typed(bat_editor *editor) {
    static const char *const keys[] = {"Tab", "ArrowUp", "Enter", "Escape", "g"};
    for (int i = 0; i < 5; i++) {
        bat_editor_key(editor, keys[i], true, 0, 3000);
        bat_editor_key(editor, keys[i], false, 0, 3000);
        bat_editor_frame(editor);
    }
}

static void styled(bat_editor *editor) {
    bat_editor_set(editor, "stroke-width", 3.5);
    bat_editor_set(editor, "stroke-colour", 0x336699ff);
    bat_editor_frame(editor);
}

static void numbers(bat_editor *editor) {
    static const char *const names[] = {"x",    "y",       "width", "height",
                                        "turn", "point-x", "guide", "stroke-width"};
    for (int i = 0; i < 8; i++) (void)bat_editor_number(editor, names[i]);
}
static void number_entered(bat_editor *editor) {
    bat_editor_enter(editor, "width", "123");
    bat_editor_enter(editor, "turn", "10");
    bat_editor_frame(editor);
}

static void panels(bat_editor *editor) {
    (void)bat_editor_layers(editor);
    (void)bat_editor_actions(editor);
    (void)bat_editor_levels(editor);
    (void)bat_editor_said(editor);
    (void)bat_editor_tables(editor);
}
static void words(bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    int count = bat_document_count(document);
    (void)bat_editor_outline(editor, 0, 100);
    (void)bat_editor_outline(editor, count - 100, 100);
    (void)bat_editor_unshown(editor);
    (void)bat_editor_holds(editor);
    (void)bat_editor_outline_points(editor, bat_object_id(bat_document_at(document, 0)));
}
static void all_words(bat_editor *editor) { (void)bat_editor_outline(editor, 0, 500); }

static void by_id(bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    bat_id first = bat_object_id(bat_document_at(document, 0));
    bat_id last = bat_object_id(bat_document_at(document, bat_document_count(document) - 1));
    bat_editor_rename(editor, last, "new");
    bat_editor_set_state(editor, first, true, false);
    bat_editor_select(editor, last, true);
    bat_editor_place_layer(editor, last, first);
    bat_editor_choose(editor, last, 2);
    bat_editor_frame(editor);
}

static void copied(bat_editor *editor, bool cut) {
    char *text = NULL;
    size_t size = 0;
    if (bat_editor_copy(editor, cut, &text, &size) == BAT_OK) bat_free(text);
    bat_editor_frame(editor);
}
static void copied_only(bat_editor *editor) { copied(editor, false); }
static void cut(bat_editor *editor) { copied(editor, true); }
static void pasted(bat_editor *editor) {
    bat_document *copy = NULL;
    if (bat_document_copy(bat_editor_document(editor), &copy) != BAT_OK) abort();
    bat_editor_paste(editor, copy, true);
    bat_document_free(copy);
    bat_editor_frame(editor);
}

static void picture_added(bat_editor *editor) {
    unsigned char head[HEAD_ROOM];
    bat_editor_add_picture(editor, head, head_png(head, 300, 200), "tree");
    bat_editor_frame(editor);
}

static void written(bat_editor *editor) {
    char *text = NULL;
    size_t size = 0;
    if (bat_document_write(bat_editor_document(editor), &text, &size) == BAT_OK) bat_free(text);
    if (bat_svg_write(bat_editor_document(editor), true, &text, &size) == BAT_OK) bat_free(text);
}

static void checked(bat_editor *editor) {
    if (bat_editor_check(editor)) abort();
}
static void compacted(bat_editor *editor) { bat_editor_compact(editor); }

static void replayed(bat_editor *editor) {
    bat_editor *again = NULL;
    size_t size = 0;
    bat_problem problem;
    const char *text = bat_editor_journal(editor, &size);
    if (bat_editor_create(&again) != BAT_OK) abort();
    if (bat_editor_replay(again, text, size, true, &problem) != BAT_OK) abort();
    bat_editor_frame(again);
    bat_editor_free(again);
}

const growth_act growth_acts[] = {
    {"a frame", frame},
    {"the view moved", view_moved},
    {"the view far away", view_far_away},
    {"the window resized", resized},
    {"the pen hovers", hovered},
    {"a line dragged", on_a_line},
    {"a copy dragged", a_copy_of_it},
    {"a drag beside all", beside_all},
    {"a drag over all", over_all},
    {"a curve sketched over", sketched},
    {"a curve sketched apart", sketched_apart},
    {"smoothed", smoothed},
    {"rubbed out", rubbed_out},
    {"a point dragged", points_dragged},
    {"a spline drawn", spline_drawn},
    {"a level dragged", level_dragged},
    {"zoomed by hand", zoomed},
    {"spanned", spanned},
    {"a drag that snaps", snapped},
    {"two clicks", clicked},
    {"keys", keys_typed},
    {"styled", styled},
    {"numbers", numbers},
    {"a number entered", number_entered},
    {"panels", panels},
    {"words", words},
    {"five hundred rows of words", all_words},
    {"by id", by_id},
    {"copied", copied_only},
    {"cut", cut},
    {"pasted", pasted},
    {"a picture added", picture_added},
    {"written", written},
    {"checked", checked},
    {"compacted", compacted},
    {"replayed", replayed},
    {NULL, NULL},
};
