/* label: slow. Every meaning of a stroke: each call that allocates sees its allocations fail. The editor stays sound,
 * undo restores the earlier drawing, and nothing leaks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include "support/alloc_paths.h"
#include "support/editing.h"

/* What a hand does, a line each:
 * draw x0 y0 x1 y1 bulge, round x y radius, zigzag x y step height, tremble x y: strokes; hold x0 y0 x1 y1 bulge: one
 * that rests before it is lifted; taps x y count; command name; set property number; keys modifiers; read reading; refit
 * amount. Everything before the word "then" has the memory that it needs. */
typedef struct act {
    const char *name, *script;
} act;

static const act acts[] = {
    {"a new line", "draw 100 700 400 650 30"},
    {"a new line between others", "draw 240 302 260 498 0"},
    {"a small ring", "round 700 700 9"},
    {"a ring", "round 700 600 80"},
    {"corners", "zigzag 100 600 40 60"},
    {"over a part", "draw 150 300 330 300 12"},
    {"over a part, backwards and beside it", "draw 330 318 150 318 8"},
    {"over all of it", "draw 96 300 384 300 20"},
    {"a dab", "draw 200 296 220 296 3"},
    {"beyond the end", "draw 360 300 392 360 10"},
    {"over a gap", "draw 300 300 480 300 10"},
    {"from end to end", "draw 380 300 400 300 2"},
    {"over a joint", "draw 240 500 560 500 14"},
    {"a ring redrawn in part", "draw 800 200 840 330 -24"},
    {"a ring redrawn whole", "round 800 300 108"},
    {"an open curve closed", "draw 700 500 900 500 -40"},
    {"an outline with handles", "draw 120 118 330 120 12"},
    {"a curve of a group", "draw 420 100 560 100 9"},
    {"only new", "command meaning-next;then;draw 150 300 330 300 12"},
    {"only redrawn", "command meaning-next;command meaning-next;then;draw 150 300 330 300 12"},
    {"a line that was held", "hold 100 700 400 650 4"},
    {"an arc that was held", "hold 100 700 300 700 60"},
    {"another reading", "draw 150 300 330 300 12;then;read 1"},
    {"new, and joined after all", "draw 300 302 480 298 6;then;read 1;read 2"},
    {"refitted", "draw 150 300 330 300 12;then;refit 0;refit 1"},
    {"refitted, new", "draw 100 700 400 650 30;then;refit 0.9"},
    {"an earlier one refitted", "draw 100 700 400 650 30;draw 700 700 900 650 20;command tool-select;taps "
                                "250 645 1;then;refit 0;refit 1"},
    {"again over the same", "draw 150 300 330 300 12;then;draw 152 303 328 303 14;draw 158 300 335 301 13"},
    {"one of several read alone, and all of them again",
     "draw 600 700 800 700 12;draw 602 703 798 703 14;then;read 0;read 2;refit 1"},
    {"smoothed", "keys 4;draw 150 300 330 300 2"},
    {"rubbed out within", "command tool-eraser;then;draw 220 300 260 300 0"},
    {"rubbed out, a ring", "command tool-eraser;then;draw 880 240 900 330 0"},
    {"smoothed by the brush", "command tool-smooth;then;draw 110 300 370 300 0"},
    {"a curve pulled", "command tool-points;taps 200 300 1;then;draw 200 300 210 330 0"},
    {"a smooth node pulled", "command tool-points;taps 200 100 1;then;draw 200 100 215 130 0"},
    {"a corner made, and smooth again",
     "command tool-points;taps 200 300 1;command knot-next;then;command corner-make;command corner-smooth"},
    {"a point put in and deleted",
     "command tool-points;taps 200 300 1;then;command point-add;command point-delete"},
    {"a spline",
     "command tool-tangents;then;taps 100 700 1;taps 200 640 1;draw 300 700 330 680 0;taps 300 700 2"},
    {"a spline changed",
     "command tool-tangents;taps 100 700 1;taps 200 640 1;taps 300 700 2;then;draw 200 640 210 600 0;"
     "command point-add;command point-delete;command point-default"},
    {"a line", "command tool-line;then;draw 100 700 300 600 0;taps 400 700 1;command cancel"},
    {"a handful dragged",
     "command tool-select;command select-all;then;draw 200 300 230 340 0;keys 4;draw 230 340 260 340 0"},
    {"taken apart", "command tool-levels;taps 150 300 1;then;command take-apart;command accept"},
    {"a level dragged",
     "command tool-levels;taps 150 300 1;command take-apart;command accept;then;draw 240 300 250 340 0"},
    {"a level redrawn",
     "command tool-levels;taps 150 300 1;command take-apart;command accept;command tool-sketch;then;"
     "draw 150 300 330 300 12;refit 0.8"},
    {"a level redrawn, then kept flat", "command tool-levels;taps 150 300 1;command take-apart;command "
                                        "accept;then;command level-add;command levels-flatten"},
    {"on both sides", "command symmetry;then;draw 100 700 400 650 30;draw 150 300 330 300 12"},
    {"over both halves of a curve that is its own image", "command symmetry;then;draw 660 420 940 420 -30"},
    {"across the axis", "command symmetry;then;draw 380 650 620 640 25;command undo;command redo"},
    {"along the axis", "command symmetry;then;draw 500 560 501 700 1"},
    {"an image joined, extended and rubbed out", "command symmetry;draw 100 700 400 650 30;then;draw 390 652 "
                                                 "500 640 5;command tool-eraser;draw 200 690 260 680 0"},
    {"points of an image moved",
     "command symmetry;draw 100 700 400 650 30;command tool-points;taps 250 645 1;then;"
     "draw 250 645 250 600 0;command point-add;command point-delete"},
    {"images arranged",
     "command symmetry;draw 100 700 400 650 30;command tool-select;then;command select-all;"
     "draw 200 300 230 340 0;command duplicate;command delete"},
    {"a mirror image of a spline",
     "command symmetry;command tool-tangents;then;taps 100 700 1;taps 200 640 1;"
     "draw 300 700 330 680 0;taps 300 700 2;draw 200 640 210 600 0"},
    {"with corners kept", "set keep-corners 1;then;zigzag 100 600 40 60;draw 150 300 330 300 12"},
    {"a level redrawn freely",
     "command tool-levels;taps 150 300 1;command take-apart;command accept;command tool-sketch;"
     "set level-sketch 1;then;draw 150 300 330 300 12;set level-sketch 2;draw 150 300 330 300 -12"},
    {"accepted although it misses",
     "set tolerance 0.1;set stroke-meaning 1;tremble 140 494;then;command accept"},
    {"a spline closed",
     "command tool-tangents;taps 100 700 1;taps 200 640 1;taps 300 700 1;then;taps 100 700 1"},
    {"a spline taken away", "command tool-tangents;taps 100 700 1;taps 200 640 2;then;command point-delete;"
                            "command point-delete"},
    {"rubbed out on both sides",
     "command symmetry;draw 100 700 400 650 30;command tool-eraser;then;draw 250 630 260 700 0"},
    {"rubbed out of what is its own image",
     "command symmetry;draw 380 650 620 640 25;command tool-eraser;then;draw 560 600 570 700 0"},
    {"simplified and calmed",
     "command tool-select;command select-all;then;command curve-simplify;command calm"},
    {"an offset that is chosen and kept",
     "command tool-select;command select-all;then;command curve-offset;set offset-distance 3;"
     "command reading-next;command accept"},
    {"a blend that is chosen and kept",
     "command tool-select;taps 150 300 1;then;command curve-blend;command reading-next;refit 0.4;"
     "command accept"},
};

static void add_ring(bat_document *document) {
    double points[16], knots[9];
    for (int i = 0; i < 8; i++)
        points[2 * i] = 800 + 110 * cos(i * 0.7853), points[2 * i + 1] = 300 + 110 * sin(i * 0.7853);
    for (int i = 0; i < 9; i++) knots[i] = i;
    bat_curve *ring = NULL;
    bat_curve_create(2, 3, true, 8, points, 9, knots, &ring);
    pen_add(document, ring);
}

/* Two cubics with a smooth node between them, as other programs write them. */
static void add_outline(bat_document *document) {
    const double points[] = {100, 120, 130, 90, 170, 90, 200, 100, 230, 110, 300, 160, 340, 120};
    bat_curve *outline = NULL;
    bat_curve_from_bezier(2, 3, false, 2, points, 0.1, 0, &outline, NULL);
    pen_add(document, outline);
}

static bat_editor *page(void) {
    bat_document *document = NULL;
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    pen_add(document, pen_curve(100, 300, 40, 0, 8)); /* to 380: a gap before the next */
    pen_add(document, pen_curve(400, 300, 40, 0, 6));
    pen_add(document, pen_curve(200, 500, 40, 0, 6)); /* to 400, where the next begins */
    pen_add(document, pen_curve(400, 500, 40, 0, 6));
    pen_add(document, pen_curve(700, 500, 28.5, 60, 8)); /* nearly round */
    pen_add(document, pen_curve(400, 100, 30, 0, 7));
    add_ring(document);
    add_outline(document);
    return editor_of(document);
}

/* x y radius */
static void round_path(double t, const double *n, double out[2]) {
    out[0] = n[0] + n[2] * cos(6.3 * t), out[1] = n[1] + n[2] * sin(6.3 * t);
}

/* x y step height */
static void zigzag_path(double t, const double *n, double out[2]) {
    const double at = 6 * t, foot = floor(at / 2) * 2;
    out[0] = n[0] + at * n[2];
    out[1] = n[1] - n[3] * (1 - fabs(at - foot - 1));
}

/* x y: trembling that no curve follows within a tenth of a pixel */
static void tremble_path(double t, const double *n, double out[2]) {
    uint32_t noise = (uint32_t)(150 * t + 1) * 1664525;
    noise ^= noise >> 13, noise *= 1013904223;
    out[0] = n[0] + 450 * t + (noise >> 24) / 20.0;
    out[1] = n[1] + (noise >> 16 & 255) / 20.0;
}

static void draw(pen *p, pen_path *path, const double *n, bool rests) {
    double at[2];
    p->time += 400;
    path(0, n, at);
    pen_event(p, BAT_POINTER_HOVER, at[0], at[1]);
    pen_begin(p, path, n, 40);
    path(1, n, at);
    if (rests) {
        p->time += 600;
        pen_event(p, BAT_POINTER_MOVE, at[0], at[1]);
        bat_editor_frame(p->editor);
        pen_event(p, BAT_POINTER_MOVE, at[0] + 9, at[1] + 5);
    }
    pen_event(p, BAT_POINTER_UP, at[0], at[1]);
    bat_editor_frame(p->editor);
}

static void taps(pen *p, const double *n) {
    p->time += 2000;
    for (int i = 0; i < (int)n[2]; i++) {
        pen_event(p, BAT_POINTER_HOVER, n[0], n[1]);
        pen_event(p, BAT_POINTER_DOWN, n[0], n[1]);
        pen_event(p, BAT_POINTER_UP, n[0], n[1]);
        bat_editor_frame(p->editor);
    }
}

static void perform(pen *p, const char *word, const char *rest) {
    double n[5] = {0}, value = 0;
    char name[64] = "";
    sscanf(rest, "%lf %lf %lf %lf %lf", n, n + 1, n + 2, n + 3, n + 4);
    sscanf(rest, "%63[a-z0-9-] %lf", name, &value);
    if (!strcmp(word, "draw"))
        draw(p, pen_arch, n, false);
    else if (!strcmp(word, "hold"))
        draw(p, pen_arch, n, true);
    else if (!strcmp(word, "round"))
        draw(p, round_path, n, false);
    else if (!strcmp(word, "tremble"))
        pen_stroke(p, tremble_path, n, 150);
    else if (!strcmp(word, "zigzag"))
        draw(p, zigzag_path, n, false);
    else if (!strcmp(word, "taps"))
        taps(p, n);
    else if (!strcmp(word, "command"))
        bat_editor_command(p->editor, name);
    else if (!strcmp(word, "set"))
        bat_editor_set(p->editor, name, value);
    else if (!strcmp(word, "keys"))
        p->modifiers = (uint32_t)n[0];
    else if (!strcmp(word, "read"))
        bat_editor_readings(p->editor), bat_editor_read_as(p->editor, (int)n[0]);
    else if (!strcmp(word, "refit"))
        bat_editor_refit(p->editor, n[0], false), bat_editor_refit(p->editor, n[0], true);
    else
        fail_msg("%s: no such act", word);
    bat_editor_frame(p->editor);
}

/* Plays the script on a fresh page. short_of_memory: from "then" on, or from the start when there is none. before: the
 * drawing at that time. */
static bat_editor *play(const char *script, bool short_of_memory, uint64_t *before) {
    bat_editor *editor = page();
    pen p = pen_for(editor);
    *before = digest(editor);
    if (short_of_memory && !strstr(script, "then;")) alloc_fail_new(false);
    while (*script) {
        const size_t length = strcspn(script, ";");
        char line[128], word[16] = "";
        snprintf(line, sizeof line, "%.*s", (int)length, script);
        sscanf(line, "%15s", word);
        if (strcmp(word, "then") != 0) {
            perform(&p, word, line + strlen(word) + (line[strlen(word)] != 0));
        } else {
            *before = digest(editor);
            if (short_of_memory) alloc_fail_new(false);
        }
        script += length + (script[length] != 0);
    }
    return editor;
}

static void memory_may_end_in_any_act(void **state) {
    (void)state;
    int failed = 0;
    for (size_t i = 0; i < sizeof acts / sizeof acts[0]; i++) {
        const long held = alloc_live();
        uint64_t before;
        bat_editor *editor = play(acts[i].script, false, &before);
        const uint64_t after = digest(editor);
        if (after == before) fail_msg("%s changes nothing", acts[i].name);
        bat_editor_free(editor);
        for (bool again = true; again; failed++) {
            editor = play(acts[i].script, true, &before);
            again = alloc_fail_reached();
            const char *wrong = bat_editor_check(editor);
            if (wrong) fail_msg("%s: %s", acts[i].name, wrong);
            if (!again) assert_true(digest(editor) == after);
            bat_editor_frame(editor);
            replays(editor, (uint64_t)i);
            while (bat_editor_command(editor, "undo") == BAT_OK) check(editor);
            bat_editor *fresh = page();
            assert_true(digest(editor) == digest(fresh));
            bat_editor_free(fresh);
            bat_editor_free(editor);
        }
        if (alloc_live() != held) fail_msg("%s: a leak", acts[i].name);
    }
    assert_true(failed > (FEWER ? 300 : 1000));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(memory_may_end_in_any_act)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
