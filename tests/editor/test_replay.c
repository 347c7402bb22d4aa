/* Replay: scripted sessions run, faulty journals are refused with the number of the faulty line, checks catch
 * differences. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include "support/editing.h"
#include <batten/base.h>
#include <batten/document.h>
#include <batten/editor.h>

static bat_status replay(bat_editor *editor, const char *text, bat_problem *problem) {
    return bat_editor_replay(editor, text, strlen(text), true, problem);
}

/* A session written by hand: raw events. */
static const char scripted[] =
    "{\"journal\":\"batten\",\"version\":1,\"name\":\"by hand\"}\n"
    "\n"
    "{\"resize\":[800,600,1]}\n"
    "{\"set\":\"tolerance\",\"value\":2}\n"
    "{\"pointer\":\"down\",\"device\":\"pen\",\"id\":1,\"buttons\":1,\"x\":100,\"y\":300,\"time\":0}\n"
    "{\"pointer\":\"move\",\"device\":\"pen\",\"id\":1,\"buttons\":1,\"x\":150,\"y\":280,\"time\":20}\n"
    "{\"pointer\":\"move\",\"device\":\"pen\",\"id\":1,\"buttons\":1,\"x\":220,\"y\":270,\"time\":40}\n"
    "{\"pointer\":\"move\",\"device\":\"pen\",\"id\":1,\"buttons\":1,\"x\":300,\"y\":275,\"time\":60}\n"
    "{\"frame\":true}\n"
    "{\"pointer\":\"move\",\"device\":\"pen\",\"id\":1,\"buttons\":1,\"x\":380,\"y\":300,\"time\":80}\n"
    "{\"pointer\":\"up\",\"device\":\"pen\",\"id\":1,\"x\":400,\"y\":310,\"time\":90}\n"
    "{\"key\":\"z\",\"modifiers\":2}\n"
    "{\"command\":\"redo\"}\n"
    "{\"wheel\":[400,300,0,-20],\"modifiers\":2}\n";

static void scripted_session(void **state) {
    (void)state;
    bat_editor *editor = NULL, *again = NULL;
    bat_problem problem = {"", ""};
    double tolerance = 0;
    bat_editor_create(&editor);
    assert_int_equal(replay(editor, scripted, &problem), BAT_OK);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 1);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_string_equal(frame->name, "by hand");
    assert_true(frame->view[2] > 1 && frame->can_undo && !frame->can_redo);
    bat_editor_get(editor, "tolerance", &tolerance);
    assert_true(tolerance == 2);
    /* What the engine made of it is a journal of edits: the stroke, undo, redo. */
    bat_editor_create(&again);
    assert_int_equal(replay(again, bat_editor_journal(editor, NULL), &problem), BAT_OK);
    assert_true(digest(again) == digest(editor));
    bat_editor_free(again);
    bat_editor_free(editor);
}

static void wrong_journals(void **state) {
    (void)state;
#define HEAD "{\"journal\":\"batten\",\"version\":1}\n"
#define VIEW "\"view\":[0,0,1]"
#define STROKE "\"stroke\":{\"points\":[[0,0],[50,9],[99,0]]}"
#define NEW HEAD "{\"do\":\"sketch-new\",\"object\":1," VIEW
#define SEVERAL HEAD "{\"do\":\"sketch-several\",\"object\":1,\"curve\":0," VIEW
    const struct {
        const char *text, *place;
        bat_status status;
    } cases[] = {
        {"", "line 1", BAT_SYNTAX},
        {"not json", "line 1", BAT_SYNTAX},
        {"{\"journal\":\"other\",\"version\":1}", "line 1", BAT_SYNTAX},
        {"{\"journal\":\"batten\",\"version\":2}", "line 1", BAT_UNSUPPORTED},
        {"{\"journal\":\"batten\",\"version\":1,\"digest\":\"0000000000000000\"}", "line 1", BAT_STATE},
        {HEAD "{\"dance\":1}", "line 2", BAT_UNSUPPORTED},
        {HEAD "\n{\"do\":\"undo\"}", "line 3", BAT_STATE},
        {HEAD "{\"do\":\"fly\"}", "line 2", BAT_UNSUPPORTED},
        {HEAD "{\"do\":\"sketch-redraw\",\"object\":5,\"curve\":0," VIEW "," STROKE "}", "line 2",
         BAT_ARGUMENT},
        {HEAD "{\"do\":\"sketch-new\",\"object\":0," VIEW "," STROKE "}", "line 2", BAT_ARGUMENT},
        {HEAD "{\"do\":\"sketch-new\",\"object\":1.5," VIEW "," STROKE "}", "line 2", BAT_ARGUMENT},
        {HEAD "{\"do\":\"sketch-new\",\"object\":1," STROKE "}", "line 2", BAT_SYNTAX},
        {HEAD "{\"do\":\"sketch-new\",\"object\":1,\"view\":[0,0,0]," STROKE "}", "line 2", BAT_SYNTAX},
        {HEAD "{\"do\":\"sketch-new\",\"object\":1," VIEW "}", "line 2", BAT_COUNT},
        {HEAD "{\"do\":\"sketch-new\",\"object\":1," VIEW ",\"stroke\":{\"points\":[[0,0],[1]]}}", "line 2",
         BAT_SYNTAX},
        {HEAD "{\"do\":\"sketch-new\",\"object\":1," VIEW
              ",\"stroke\":{\"points\":[[0,0],[9,9]],\"time\":[5,4]}}",
         "line 2", BAT_SYNTAX},
        {HEAD "{\"do\":\"sketch-new\",\"object\":1," VIEW
              ",\"stroke\":{\"points\":[[0,0],[9,9],[9,0]],\"time\":[5,4]}}",
         "line 2", BAT_COUNT},
        {HEAD "{\"do\":\"sketch-new\",\"object\":1," VIEW ",\"stroke\":{\"points\":[[0,0],[1,0]]}}", "line 2",
         BAT_DOT},
        {HEAD "{\"set\":\"tolerance\",\"value\":99}", "line 2", BAT_ARGUMENT},
        {HEAD "{\"set\":\"colour of the sky\",\"value\":1}", "line 2", BAT_UNSUPPORTED},
        {HEAD "{\"command\":\"fly\"}", "line 2", BAT_UNSUPPORTED},
        {HEAD "{\"pointer\":\"jump\"}", "line 2", BAT_UNSUPPORTED},
        {HEAD "{\"digest\":\"0123456789abcdef\"}", "line 2", BAT_STATE},
        {HEAD "{\"digest\":\"0123\"}", "line 2", BAT_STATE},
        {"\n \t\r\n \n", "line 1", BAT_SYNTAX},
        {"{\"journal\":\"batten\"}", "line 1", BAT_ARGUMENT},
        {"{\"journal\":\"batten\",\"version\":1,\"document\":{\"a \\\" }\":1}}", "line 1", BAT_SYNTAX},
        {HEAD "{\"pointer\":1}", "line 2", BAT_UNSUPPORTED},
        {HEAD "{\"pointer\":\"down\",\"device\":\"tail\"}", "line 2", BAT_UNSUPPORTED},
        {HEAD "{\"axis\":[0,0,2,0]}", "line 2", BAT_NUMBER},
        {HEAD "{\"axis\":[0,0,\"1\",0]}", "line 2", BAT_NUMBER},
        {HEAD "{\"axis\":[1e300,0,1,0]}", "line 2", BAT_NUMBER},
        {HEAD "{\"enter\":\"the colour of the sky\",\"text\":\"5\"}", "line 2", BAT_UNSUPPORTED},
        {HEAD "{\"picture\":\"none\"}", "line 2", BAT_SYNTAX},
        {HEAD "{\"do\":\"change\"}", "line 2", BAT_SYNTAX},
        {HEAD "{\"do\":\"change\",\"changes\":[{}]}", "line 2", BAT_SYNTAX},
        {HEAD "{\"do\":\"change\",\"changes\":[{\"at\":0.5}]}", "line 2", BAT_SYNTAX},
        {HEAD "{\"do\":\"change\",\"changes\":[{\"at\":0,\"remove\":1}]}", "line 2", BAT_ARGUMENT},
        {HEAD "{\"do\":\"change\",\"changes\":[{\"at\":0,\"insert\":{}}]}", "line 2", BAT_SYNTAX},
        {HEAD "{\"do\":\"change\",\"changes\":[{\"at\":9,\"insert\":{\"kind\":\"group\",\"id\":1}}]}",
         "line 2", BAT_ARGUMENT},
        {HEAD "{\"do\":\"change\",\"changes\":[{\"at\":0,\"replace\":{\"kind\":\"group\",\"id\":1}}]}",
         "line 2", BAT_ARGUMENT},
        {NEW ",\"stroke\":{\"points\":[[0,0],[9,9],[9,0]],\"tilt\":[[1,1],[2,2]]}}", "line 2", BAT_COUNT},
        {NEW ",\"stroke\":{\"points\":[[0,0],[9,9]],\"tilt\":[[1,1],[2]]}}", "line 2", BAT_SYNTAX},
        {NEW ",\"stroke\":{\"points\":[[0,0],[9,9]],\"pressure\":[0.5,2]}}", "line 2", BAT_SYNTAX},
        {NEW ",\"stroke\":{\"points\":[[0,0],[9,9]],\"pressure\":[0.5,\"a\"]}}", "line 2", BAT_SYNTAX},
        {NEW ",\"stroke\":{\"points\":[[0,0],[9e9,9]]}}", "line 2", BAT_SYNTAX},
        {NEW ",\"start\":[1],\"stroke\":{\"points\":[[0,0],[9,9]]}}", "line 2", BAT_SYNTAX},
        {NEW ",\"mirror\":[1,2,3]," STROKE "}", "line 2", BAT_SYNTAX},
        {NEW ",\"mirror\":[1,2,3,4]," STROKE "}", "line 2", BAT_ARGUMENT},
        {NEW ",\"mirror\":[1,2,3,1e300]," STROKE "}", "line 2", BAT_SYNTAX},
        {NEW ",\"ground\":{\"plane\":[0,0,0,1,0,0,0,1]}," STROKE "}", "line 2", BAT_SYNTAX},
        {NEW ",\"ground\":{\"plane\":[0,0,0,1,0,0,0,1,\"0\"]}," STROKE "}", "line 2", BAT_SYNTAX},
        {NEW ",\"ground\":{\"plane\":[0,0,0,1,0,0,0,1,0,1,2,3,4,5,6,7,8,9,9,9,9,9]}," STROKE "}", "line 2",
         BAT_SYNTAX},
        {NEW ",\"ground\":{\"plane\":[0,0,0,1,0,0,0,1,0]},\"start\":[1,2]," STROKE "}", "line 2", BAT_SYNTAX},
        {NEW ",\"ground\":{\"lake\":[]}," STROKE "}", "line 2", BAT_SYNTAX},
        {HEAD "{\"do\":\"sketch-new\",\"object\":1,\"view\":[0,0,1,270]," STROKE "}", "line 2", BAT_SYNTAX},
        {HEAD "{\"do\":\"sketch-new\",\"object\":1,\"view\":[0,0]," STROKE "}", "line 2", BAT_SYNTAX},
        {SEVERAL ",\"parts\":[]," STROKE "}", "line 2", BAT_COUNT},
        {SEVERAL "," STROKE "}", "line 2", BAT_COUNT},
        {SEVERAL ",\"parts\":[0,0,0,0,0,0,0]," STROKE "}", "line 2", BAT_COUNT},
        {SEVERAL ",\"parts\":[0]," STROKE "}", "line 2", BAT_ARGUMENT},
        {SEVERAL ",\"parts\":[{\"object\":1,\"curve\":0,\"sense\":1,\"end\":[1]}]," STROKE "}", "line 2",
         BAT_SYNTAX},
        {SEVERAL ",\"parts\":[{\"object\":1,\"curve\":0,\"sense\":1,\"ends\":[1]}]," STROKE "}", "line 2",
         BAT_SYNTAX},
        {SEVERAL ",\"parts\":[{\"object\":1,\"curve\":0},{\"object\":1,\"curve\":0}]," STROKE "}", "line 2",
         BAT_ARGUMENT},
        {HEAD "{\"do\":\"sketch-level\",\"object\":1,\"curve\":0,\"level\":0," VIEW "," STROKE "}", "line 2",
         BAT_ARGUMENT},
    };
    int wrong = 0;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_editor *editor = NULL;
        bat_problem problem = {"", ""};
        bat_editor_create(&editor);
        bat_status status = replay(editor, cases[i].text, &problem);
        if (status != cases[i].status || strcmp(problem.place, cases[i].place) || !problem.message[0])
            wrong++, print_message("%s: status %d, %s: %s\n", cases[i].text, status, problem.place,
                                   problem.message);
        assert_null(bat_editor_check(editor));
        assert_int_equal(bat_document_count(bat_editor_document(editor)), 0);
        bat_editor_free(editor);
    }
    assert_int_equal(wrong, 0);
}

/* A journal that was tampered with does not pass its own digests. */
static void digests_catch_a_changed_stroke(void **state) {
    (void)state;
    bat_editor *editor = pen_editor(), *again = NULL;
    pen p = pen_for(editor);
    pen_line(&p, 350, 200, 650, 200, 40);
    size_t size = 0;
    const char *text = bat_editor_journal(editor, &size);
    char *copy = malloc(size + 1);
    memcpy(copy, text, size + 1);
    char *at = strstr(strstr(copy, "\"points\":[[350,200],"), "],[") + 3;
    assert_non_null(at);
    at[0] = at[0] == '9' ? '8' : (char)(at[0] + 1);
    bat_problem problem = {"", ""};
    bat_editor_create(&again);
    assert_int_equal(bat_editor_replay(again, copy, size, true, &problem), BAT_STATE);
    assert_string_equal(problem.place, "line 2");
    free(copy);
    bat_editor_free(again);
    bat_editor_free(editor);
}

/* What the pen felt is in the journal: pressure, tilt, time, and the pixel and tolerance of the stroke. */
static void the_pen_is_recorded(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    bat_editor_set(editor, "tolerance", 2);
    bat_editor_command(editor, "zoom-in");
    bat_editor_command(editor, "zoom-in");
    pen_line(&p, 350, 100, 650, 120, 40);
    const char *text = bat_editor_journal(editor, NULL);
    const char *parts[] = {"\"pressure\":[0.", "\"time\":[0,4,8,", "\"tilt\":[[20,-5],", "\"pixel\":0.",
                           "\"tolerance\":"};
    for (int i = 0; i < 5; i++) assert_non_null(strstr(text, parts[i]));
    double zoom = bat_editor_frame(editor)->view[2], pixel = 0, tolerance = 0;
    assert_int_equal(sscanf(strstr(text, "\"pixel\":"), "\"pixel\":%lf", &pixel), 1);
    assert_int_equal(sscanf(strstr(text, "\"tolerance\":"), "\"tolerance\":%lf", &tolerance), 1);
    assert_true(pixel == 1 / zoom && tolerance == 2 / zoom);
    bat_editor_free(editor);
}

/* The example of docs/journal.md does what the page says of it. */
static void the_documented_example(void **state) {
    (void)state;
    static char page[32768];
    FILE *file = fopen("docs/journal.md", "rb");
    assert_non_null(file);
    size_t size = fread(page, 1, sizeof page - 1, file);
    fclose(file);
    page[size] = 0;
    char *from = strstr(strstr(page, "## A whole one"), "{\"journal\""), *to = strstr(from, "```");
    assert_non_null(to);
    bat_editor *editor = NULL;
    bat_problem problem = {"", ""};
    bat_editor_create(&editor);
    if (bat_editor_replay(editor, from, (size_t)(to - from), true, &problem) != BAT_OK)
        fail_msg("%s: %s", problem.place, problem.message);
    const char *journal = bat_editor_journal(editor, NULL);
    const char *steps[] = {"\"do\":\"sketch-new\"", "\"do\":\"sketch-redraw\"", "\"do\":\"undo\"",
                           "\"do\":\"redo\""};
    for (int i = 0; i < 4; i++) {
        journal = strstr(journal, steps[i]);
        assert_non_null(journal);
    }
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 1);
    bat_editor_free(editor);
}

enum { DRAWN = 5, LINES = 2 * DRAWN + 1, LINE_ROOM = 100000 };

/* The journal's lines, one by one, without number `left`; their line breaks are not given. Returns those refused. */
static int play_without(bat_editor *editor, const char *text, int left) {
    int refused = 0, number = 0;
    for (const char *end; (end = strchr(text, '\n')); text = end + 1, number++) {
        bat_problem problem = {"", ""};
        if (number == 0)
            assert_int_equal(bat_editor_replay(editor, text, (size_t)(end - text), false, &problem), BAT_OK);
        else if (number != left)
            refused += bat_editor_replay_line(editor, text, (size_t)(end - text), &problem) != BAT_OK;
    }
    assert_int_equal(number, LINES);
    check(editor);
    return refused;
}

/* Line by line a journal gives the same drawing. Without one line, all others that do not need it still run: objects are
 * found by their ids though they lie elsewhere in the list than the journal says. */
static void lines_may_be_left_out(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    for (int i = 0; i < DRAWN; i++) pen_line(&p, 350, 100 + 80 * i, 650, 100 + 80 * i, 40);
    for (int i = 0; i < DRAWN; i++) { /* each is chosen and moved: a change, whole */
        bat_editor_command(editor, "tool-select");
        const bat_document *document = bat_editor_document(editor);
        const int at = bat_document_count(document) - DRAWN + i;
        assert_int_equal(bat_editor_select(editor, bat_object_id(bat_document_at(document, at)), false),
                         BAT_OK);
        bat_editor_command(editor, "nudge-right");
    }
    static char text[LINE_ROOM];
    size_t size = 0;
    const char *journal = bat_editor_journal(editor, &size);
    assert_true(size < LINE_ROOM);
    memcpy(text, journal, size + 1);
    const int count = bat_document_count(bat_editor_document(editor));
    for (int left = LINES; left > 0; left--) {
        bat_editor *again = NULL;
        assert_int_equal(bat_editor_create(&again), BAT_OK);
        const bool drawn = left <= DRAWN; /* its move needs it */
        assert_int_equal(play_without(again, text, left), drawn);
        assert_int_equal(bat_document_count(bat_editor_document(again)), count - drawn);
        if (left == LINES) assert_true(digest(again) == digest(editor));
        bat_editor_free(again);
    }
    bat_problem problem = {"", ""};
    assert_int_equal(bat_editor_replay_line(NULL, text, size, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_editor_replay_line(editor, "{", 1, &problem), BAT_SYNTAX);
    assert_true(problem.message[0] != 0);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_may_be_left_out), cmocka_unit_test(scripted_session),
        cmocka_unit_test(wrong_journals),        cmocka_unit_test(digests_catch_a_changed_stroke),
        cmocka_unit_test(the_pen_is_recorded),   cmocka_unit_test(the_documented_example),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
