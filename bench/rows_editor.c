/* The editor's response times: an event, a frame, a stroke, an undo, in documents with many curves. */
#include "../tests/support/pen.h"
#include "bench.h"
#include "strokes.h"

typedef struct session {
    bat_editor *editor;
    pen pen;
    int samples, turn;
} session;

/* A page of 1000 x 800 with `curves` short cubics in rows of 40, shown at scale 1. */
static session *open_session(int curves, int samples) {
    session *s = calloc(1, sizeof *s);
    bat_document *document = NULL;
    if (!s || bat_document_create(&document) != BAT_OK || bat_editor_create(&s->editor) != BAT_OK) abort();
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    for (int i = 0; i < curves; i++)
        pen_add(document, pen_curve(20 + i % 40 * 23.5, 20 + i / 40 * (760.0 / (curves / 40 + 1)), 2, 4, 10));
    bat_editor_resize(s->editor, 1000, 800, 1);
    if (bat_editor_open(s->editor, document, "bench") != BAT_OK) abort();
    bat_editor_command(s->editor, "zoom-100");
    bat_editor_frame(s->editor);
    s->pen = pen_for(s->editor);
    s->samples = samples;
    return s;
}

static void *begin_1000(int variant) { return open_session(1000, variant); }
static void *begin_5000(int variant) { return open_session(5000, variant); }

static void end_session(void *context) {
    session *s = context;
    bat_editor_free(s->editor);
    free(s);
}

static void run_hover(void *context) {
    session *s = context;
    s->turn = (s->turn + 37) % 900;
    pen_event(&s->pen, BAT_POINTER_HOVER, 50 + s->turn, 40 + s->turn * 0.8);
    bat_editor_frame(s->editor);
}

/* Draws across the page with a tremor, with a frame after every `every` samples (0: none). The pen stays down. */
static void draw(session *s, int every) {
    uint64_t state = 3;
    for (int i = 0; i < s->samples; i++) {
        double t = (double)i / (s->samples - 1), x = 30 + 940 * t;
        double y = 400 + 150 * sin(9 * t) + 0.3 * stroke_noise(&state);
        pen_event(&s->pen, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, x, y);
        if (every && i % every == every - 1) bat_editor_frame(s->editor);
    }
}

enum { EVENTS_A_FRAME = 4 }; /* a pen at 240 Hz, a screen at 60 Hz */

static void run_frames(void *context) {
    session *s = context;
    draw(s, EVENTS_A_FRAME);
    bat_editor_command(s->editor, "cancel");
    pen_event(&s->pen, BAT_POINTER_UP, 0, 0);
}

static void run_events(void *context) {
    session *s = context;
    draw(s, 0);
    bat_editor_command(s->editor, "cancel");
    pen_event(&s->pen, BAT_POINTER_UP, 0, 0);
}

static void run_commit(void *context) {
    session *s = context;
    draw(s, 0);
    pen_event(&s->pen, BAT_POINTER_UP, 970, 400 + 150 * sin(9));
    bat_editor_frame(s->editor);
    bat_editor_command(s->editor, "cancel");
    bat_editor_command(s->editor, "undo");
}

static void *begin_undo(int variant) {
    session *s = open_session(variant, 60);
    draw(s, 0);
    pen_event(&s->pen, BAT_POINTER_UP, 970, 400 + 150 * sin(9));
    return s;
}

static void run_undo(void *context) {
    session *s = context;
    if (bat_editor_command(s->editor, "undo") != BAT_OK) abort();
    bat_editor_frame(s->editor);
    if (bat_editor_command(s->editor, "redo") != BAT_OK) abort();
    bat_editor_frame(s->editor);
}

/* One curve, or all (-1), under the pen of the select tool. */
static void *begin_move(int variant) {
    session *s = open_session(1000, 0);
    bat_editor_command(s->editor, "tool-select");
    if (variant < 0)
        bat_editor_command(s->editor, "select-all");
    else
        bat_editor_select(s->editor, 1, 0);
    bat_editor_frame(s->editor);
    pen_event(&s->pen, BAT_POINTER_DOWN, 20, 20);
    return s;
}

/* A frame with what the open inspector asks in it. */
static void run_move(void *context) {
    static const char *const numbers[] = {"x", "y", "width", "height", "turn"};
    session *s = context;
    s->turn = (s->turn + 7) % 90;
    pen_event(&s->pen, BAT_POINTER_MOVE, 30 + s->turn, 30 + s->turn * 0.8);
    bat_editor_frame(s->editor);
    for (int i = 0; i < 5; i++) bat_editor_number(s->editor, numbers[i]);
}

static void *begin_chosen(int variant) {
    session *s = open_session(1000, 0);
    bat_editor_command(s->editor, "tool-select");
    bat_editor_command(s->editor, variant < 0 ? "select-all" : "deselect");
    bat_editor_frame(s->editor);
    return s;
}

/* What it asks after a step, or when something else is selected: all sections open, 30 objects in view. */
static void run_inspector(void *context) {
    session *s = context;
    const char *told[] = {bat_editor_actions(s->editor), bat_editor_mixed(s->editor),
                          bat_editor_layers(s->editor), bat_editor_outline(s->editor, 0, 30),
                          bat_editor_colours(s->editor)};
    for (int i = 0; i < 5; i++)
        if (!told[i]) abort();
}

const bench_row bench_rows_editor[] = {
    {"hover and frame, 1000 curves", "us", 1e6, 1, 0, begin_1000, run_hover, end_session, 0},
    {"hover and frame, 5000 curves", "us", 1e6, 1, 0, begin_5000, run_hover, end_session, 0},
    {"pen event, 1000 curves", "ns", 1e9, 2400, 2400, begin_1000, run_events, end_session, 0},
    {"frame while drawing, 240 samples", "us", 1e6, 240 / EVENTS_A_FRAME, 240, begin_1000, run_frames,
     end_session, 0},
    {"frame while drawing, 2400 samples", "us", 1e6, 2400 / EVENTS_A_FRAME, 2400, begin_1000, run_frames,
     end_session, 0},
    {"stroke to commit and undo, 240", "us", 1e6, 1, 240, begin_1000, run_commit, end_session, 0},
    {"stroke to commit and undo, 2400", "us", 1e6, 1, 2400, begin_1000, run_commit, end_session, 0},
    {"undo and frame, 1000 curves", "us", 1e6, 2, 1000, begin_undo, run_undo, end_session, 0},
    {"move one of 1000, frame, inspector", "us", 1e6, 1, 1, begin_move, run_move, end_session, 0},
    {"move all of 1000, frame, inspector", "us", 1e6, 1, -1, begin_move, run_move, end_session, 0},
    {"inspector asks anew, none of 1000", "us", 1e6, 1, 1, begin_chosen, run_inspector, end_session, 0},
    {"inspector asks anew, all of 1000", "us", 1e6, 1, -1, begin_chosen, run_inspector, end_session, 0},
    {0},
};
