/* What does not look as it does in the file is named, object by object, as long as the object is there: in the list, in
 * the outline, and again after the drawing was written, or its journal replayed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "document/document.h"
#include "document/source.h"
#include "editor/editor.h"
#include "format/svg/write/feed.h"
#include "support/alloc_fail.h"
#include <batten/format.h>
#include <batten/panels.h>

static const char ART[] =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 90 90'>"
    "<path id='plain' d='M0 0L50 50' stroke='#000' style='stroke-dasharray:1 2'/>"
    "<path id='broken' d='M0 0L50 50' style='transform:rotateX(9deg)' stroke='#000' stroke-dasharray='1 "
    "five'/>"
    "<g style='mix-blend-mode:multiply'><path id='alone' d='M0 9L50 9' stroke='#000'/></g>"
    "<g id='two' style='mix-blend-mode:multiply'><path id='in' d='M0 19L50 9' stroke='#000'/>"
    "<path d='M0 29L50 9' stroke='#000'/></g>"
    "<defs><path id='p' d='M5 5h9' stroke='#000' stroke-dasharray='five'/></defs>"
    "<use id='copy' href='#p'/><use href='#p' x='9'/>"
    "<g style='mix-blend-mode:screen'><rect width='9' height='9' filter='url(#f)'/></g>"
    "<filter id='f'><feGaussianBlur stdDeviation='2'/></filter></svg>";

static bat_document *opened(const char *text) {
    const bat_svg_options options = bat_svg_merging();
    bat_svg_reader *reader;
    bat_document *document = NULL;
    assert_int_equal(bat_svg_reader_create(&options, &reader), BAT_OK);
    assert_int_equal(bat_svg_reader_source(reader, text, strlen(text)), BAT_OK);
    assert_int_equal(bat_svg_feed(text, strlen(text), reader), BAT_OK);
    assert_int_equal(bat_svg_reader_finish(reader, &document, NULL, NULL), BAT_OK);
    return document;
}

static bat_editor *editing(bat_document *document) {
    bat_editor *editor = NULL;
    assert_int_equal(bat_editor_create(&editor), BAT_OK);
    assert_int_equal(bat_editor_open(editor, document, "art.svg"), BAT_OK);
    return editor;
}

static void has(const char *text, const char *part) {
    if (!text || !strstr(text, part)) fail_msg("%s lacks %s", text ? text : "(nothing)", part);
}

static int occurrences(const char *text, const char *part) {
    int count = 0;
    for (; (text = strstr(text, part)); text += strlen(part)) count++;
    return count;
}

static void each_object_is_named(void **state) {
    (void)state;
    bat_editor *editor = editing(opened(ART));
    const char *list = bat_editor_unshown(editor);
    has(list, "\"words\":\"broken, curve\",\"lost\":[\"dashes\",\"broken\"]");
    has(list, "\"words\":\"alone, curve\",\"lost\":[\"blends\"]"); /* its group was not needed */
    has(list, "\"words\":\"two, group\",\"lost\":[\"blends\"]");
    assert_int_equal(occurrences(list, "\"lost\":[\"dashes\"]"), 2); /* the copies */
    assert_null(strstr(list, "plain"));
    assert_null(strstr(list, "\"in")); /* it is the group that has it */
    has(list, "\"total\":5}");
    const char *outline = bat_editor_outline(editor, 0, 100);
    has(outline, "looks different here");
    assert_int_equal(occurrences(outline, "looks different here"), 5);
    bat_editor_free(editor);
}

static bat_id called(const bat_document *document, const char *name) {
    for (int i = 0; i < bat_document_count(document); i++)
        if (strcmp(bat_object_name(bat_document_at(document, i)), name) == 0)
            return bat_object_id(bat_document_at(document, i));
    fail_msg("%s is not there", name);
    return 0;
}

static void it_goes_with_the_object(void **state) {
    (void)state;
    bat_editor *editor = editing(opened(ART));
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    assert_int_equal(bat_editor_select(editor, called(bat_editor_document(editor), "broken"), false), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "duplicate"),
                     BAT_OK); /* the copy is no element of the file */
    has(bat_editor_unshown(editor), "\"total\":5}");
    assert_int_equal(bat_editor_select(editor, called(bat_editor_document(editor), "broken"), false), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "delete"), BAT_OK);
    has(bat_editor_unshown(editor), "\"total\":4}");
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    has(bat_editor_unshown(editor), "\"total\":5}");
    bat_editor_free(editor);
}

static void it_is_written(void **state) {
    (void)state;
    bat_document *first = opened(ART), *again = NULL;
    char *text, *twice;
    size_t size;
    assert_int_equal(bat_document_write(first, &text, &size), BAT_OK);
    has(text, "\"lost\":[\"blends\"]");
    assert_int_equal(bat_document_read(text, size, &again, NULL), BAT_OK);
    for (int i = 0; i < bat_document_count(first); i++) {
        const bat_id id = bat_object_id(bat_document_at(first, i));
        assert_int_equal(bat_source_lost(bat_document_origin(first), id),
                         bat_source_lost(bat_document_origin(again), id));
    }
    assert_int_equal(bat_document_write(again, &twice, &size), BAT_OK);
    assert_string_equal(text, twice);
    free(text);
    free(twice);
    bat_document_free(again);
    /* As SVG with the native document: the same again. */
    assert_int_equal(bat_svg_write(first, true, &text, &size), BAT_OK);
    bat_editor *editor = editing(opened(text));
    has(bat_editor_unshown(editor), "\"total\":5}");
    bat_editor_free(editor);
    free(text);
    bat_document_free(first);
}

static void there_may_be_none(void **state) {
    (void)state;
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_editor *editor = editing(document);
    assert_string_equal(bat_editor_unshown(editor), "{\"rows\":[],\"total\":0}");
    assert_int_equal(bat_source_lost(NULL, 1), 0);
    bat_editor_free(editor);
    editor = editing(
        opened("<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0L5 5' stroke='red'/></svg>"));
    assert_string_equal(bat_editor_unshown(editor), "{\"rows\":[],\"total\":0}");
    bat_editor_free(editor);
}

static void what_a_drawing_holds_is_counted(void **state) {
    (void)state;
    bat_editor *editor = editing(opened("<svg xmlns='http://www.w3.org/2000/svg' width='40' height='30'><g>"
                                        "<path d='M0 0L5 5' stroke='red'/><text>a</text></g>"
                                        "<path d='M0 9L5 5' stroke='red'/></svg>"));
    assert_string_equal(bat_editor_holds(editor),
                        "{\"kinds\":[{\"words\":\"group\",\"count\":1},{\"words\":\"curve\",\"count\":2},"
                        "{\"words\":\"foreign content\",\"count\":1}],\"page\":[\"40 px\",\"30 px\"]}");
    bat_editor_free(editor);
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    editor = editing(document);
    assert_string_equal(bat_editor_holds(editor), "{\"kinds\":[],\"page\":[\"\",\"\"]}");
    alloc_fail_at(1);
    assert_null(bat_editor_holds(editor));
    alloc_fail_at(0);
    bat_editor_free(editor);
}

/* How many objects look otherwise than in the file; the frame says it, and nothing else is said. */
static void only_what_is_seen_counts(void **state) {
    (void)state;
#define LINE "<path d='M0 0L50 50' stroke='#000'"
    static const struct {
        const char *content;
        unsigned lost;
    } rows[] = {
        {"<metadata><rdf:RDF xmlns:rdf='r'><a/></rdf:RDF></metadata>" LINE "/>", 0},
        {"<sodipodi:namedview><inkscape:grid/></sodipodi:namedview>" LINE
         " inkscape:connector-curvature='0'/>",
         0},
        {"<title>t</title><desc>d</desc>" LINE "><title>t</title></path>", 0},
        {"<defs><linearGradient id='l'/><filter id='f'/><clipPath id='c'/><path id='p'/></defs><symbol/>" LINE
         "/>",
         0},
        {LINE " data-x='1' serif:id='a' frobnicate='1' role='img' aria-label='x'/>", 0},
        {"<g/><g><g/></g>" LINE "/>", 0},
        {LINE "/><g display='none'>" LINE
              " stroke-dasharray='1 x' style='mix-blend-mode:multiply'/><text>a</text>"
              "<image href='a.png' width='5' height='5'/></g>",
         0},
        {LINE "/>" LINE " visibility='hidden'/><rect width='5' height='5' fill='none'/>", 0},
        {"<script>1</script><a href='http://x'>" LINE " onclick='a()'/></a>", 0},
        {"<style>path{stroke:red}</style>" LINE "/>", 0},
        {"<switch>" LINE "/><text/></switch><use href='#u'/><path id='u' d='M0 0h9' stroke='red'/>", 0},
        {LINE
         " style='-inkscape-stroke:none;font-family:x;isolation:isolate;stroke-linejoin:arcs;paint-key:x'/>",
         0},
        {LINE " shape-rendering='geometricPrecision' image-rendering='optimizeQuality'/>", 0},
        {"<blob/><sodipodi:guide/>" LINE "/>", 0},
        /* seen */
        {LINE " stroke-dasharray='1 x'/>" LINE " stroke-dasharray='1 x'/>", 2},
        {"<metadata><x/></metadata>" LINE "/><g style='mix-blend-mode:multiply'>" LINE "/>" LINE "/></g>", 1},
        {LINE " shape-rendering='crispEdges'/>", 1},
        {LINE " style='stroke:oklch(1 2 3)'/>", 1},
        {LINE " style='rotate:30deg'/>", 0},
        {LINE " style='rotate:x 30deg'/>", 1},
        {LINE "><animate attributeName='d'/></path>" LINE "/>", 1},
        {"<image href='a.png' width='5' height='5'/>" LINE "/>", 1},
        {"<path d='M0 0L50 50 L' stroke='#000'/><use href='#no'/>" LINE " transform='turn(9)'/>", 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[2000];
        bat_svg_report report;
        bat_svg_reader *reader;
        bat_document *document = NULL;
        snprintf(text, sizeof text,
                 "<svg xmlns='http://www.w3.org/2000/svg' width='210mm' height='297mm' viewBox='0 0 210 "
                 "297'>%s</svg>",
                 rows[i].content);
        assert_int_equal(bat_svg_reader_create(NULL, &reader), BAT_OK);
        assert_int_equal(bat_svg_reader_source(reader, text, strlen(text)), BAT_OK);
        assert_int_equal(bat_svg_feed(text, strlen(text), reader), BAT_OK);
        assert_int_equal(bat_svg_reader_finish(reader, &document, &report, NULL), BAT_OK);
        bat_editor *editor = editing(document);
        assert_int_equal(bat_editor_set_losses(editor, &report.lost), BAT_OK);
        if (bat_editor_frame(editor)->lost != rows[i].lost)
            fail_msg("%s: %u", rows[i].content, (unsigned)bat_editor_frame(editor)->lost);
        bat_editor_free(editor);
    }
#undef LINE
}

static void memory_may_run_out(void **state) {
    (void)state;
    bat_editor *editor = editing(opened(ART));
    int failed = 0;
    for (int n = 1; n < 100; n++) {
        alloc_fail_at(n);
        const char *list = bat_editor_unshown(editor);
        const bool reached = alloc_fail_reached();
        alloc_fail_at(0);
        assert_int_equal(list == NULL, reached);
        if (!reached) break;
        failed++;
    }
    assert_in_range(failed, 1, 99);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_object_is_named),
        cmocka_unit_test(it_goes_with_the_object),
        cmocka_unit_test(it_is_written),
        cmocka_unit_test(there_may_be_none),
        cmocka_unit_test(only_what_is_seen_counts),
        cmocka_unit_test(memory_may_run_out),
        cmocka_unit_test(what_a_drawing_holds_is_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
