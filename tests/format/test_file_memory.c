/* label: slow. Every reader and every writer, on the drawings, journals and seeds of this repository: each call that
 * allocates sees its allocations fail. The status says so, nothing comes out, and nothing leaks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <glob.h>
#include <cmocka.h>
#include "support/alloc_paths.h"
#include "support/editing.h"
#include "support/xml.h"
#include "format/formats.h"
#include <batten/bezier.h>
#include <batten/format.h>

typedef struct file {
    const char *name;
    char *text;
    size_t size;
} file;

/* Opens, uses and closes all again. The last status; *said: what the reader said. */
typedef bat_status work(const file *from, bat_problem *said);

static bat_status write_document(const bat_document *document) {
    char *text = NULL;
    size_t size;
    bat_status status = bat_document_write(document, &text, &size);
    if (status == BAT_OK) bat_free(text);
    text = NULL;
    if (status == BAT_OK || status == BAT_COUNT) status = bat_svg_write(document, true, &text, &size);
    if (status == BAT_OK) bat_free(text), text = NULL, status = bat_svg_write(document, false, &text, &size);
    if (status == BAT_OK) bat_free(text);
    return status;
}

/* Written, and put in its own place. */
static bat_status as_glif(const file *from, bat_problem *said) {
    bat_document *document = NULL;
    bat_svg_reader *reader;
    char *text = NULL;
    size_t size;
    bat_status status = bat_svg_reader_create(NULL, &reader);
    if (status != BAT_OK) return status;
    if (!xml_feed(reader, from->text)) {
        bat_svg_reader_free(reader);
        return alloc_hit ? BAT_MEMORY : BAT_SYNTAX;
    }
    status = bat_svg_reader_finish(reader, &document, NULL, said);
    assert_true((status == BAT_OK) == (document != NULL));
    if (status == BAT_OK) status = bat_glif_write(document, true, &text, &size);
    if (status == BAT_OK)
        bat_free(text),
            status = bat_glif_replace(from->text, from->size, document, false, &text, &size, NULL);
    if (status == BAT_OK) bat_free(text);
    bat_document_free(document);
    return status;
}

static bat_status as_svg(const file *from, bat_problem *said) {
    bat_svg_options options;
    bat_document *document = NULL;
    bat_svg_report report;
    bat_svg_options_init_merging(&options, sizeof options);
    bat_status status = BAT_OK;
    for (int merging = 0; merging < 2 && status == BAT_OK; merging++) {
        bat_svg_reader *reader;
        status = bat_svg_reader_create(merging ? &options : NULL, &reader);
        if (status != BAT_OK) return status;
        if (!xml_feed(reader, from->text)) {
            bat_svg_reader_free(reader);
            return alloc_hit ? BAT_MEMORY : BAT_SYNTAX; /* the test's parser had no memory */
        }
        status = bat_svg_reader_finish(reader, &document, &report, said);
        assert_true((status == BAT_OK) == (document != NULL));
        if (status == BAT_OK) status = write_document(document);
        bat_document_free(document);
        document = NULL;
    }
    return status;
}

static bat_status through(const char *name, const char *to, const file *from, bat_problem *said) {
    const bat_reading how = {.xml = NULL};
    const bat_format *format = bat_format_named(name);
    bat_document *document = NULL;
    bat_svg_report report = {0};
    char *text = NULL;
    size_t size;
    bat_status status = format->read(&how, from->text, from->size, &document, &report, said);
    assert_true((status == BAT_OK) == (document != NULL));
    if (status == BAT_OK) status = bat_format_named(to)->write(document, &text, &size, said);
    if (status == BAT_OK) bat_free(text);
    bat_document_free(document);
    return status;
}
static bat_status as_obj(const file *from, bat_problem *said) { return through("obj", "obj", from, said); }
static bat_status as_dxf(const file *from, bat_problem *said) { return through("dxf", "dxf", from, said); }
static bat_status as_gcode(const file *from, bat_problem *said) {
    return through("dxf", "gcode", from, said);
}
static bat_status as_csv(const file *from, bat_problem *said) { return through("csv", "csv", from, said); }
static bat_status as_geojson(const file *from, bat_problem *said) {
    return through("geojson", "geojson", from, said);
}
static bat_status as_mesh(const file *from, bat_problem *said) {
    return through(bat_format_called(from->name)->name, "stl", from, said);
}
static bat_status as_native(const file *from, bat_problem *said) {
    return through("batten", "batten", from, said);
}

static bat_status as_curve(const file *from, bat_problem *said) {
    bat_curve *curve = NULL;
    char *text = NULL;
    size_t size;
    bat_status status = bat_curve_read(from->text, from->size, &curve, said);
    assert_true((status == BAT_OK) == (curve != NULL));
    if (status == BAT_OK) status = bat_curve_write(curve, &text, &size);
    if (status == BAT_OK) bat_free(text);
    bat_curve_free(curve);
    return status;
}

static bat_status as_shape(const file *from, bat_problem *said) {
    bat_shape *shape = NULL;
    char *text = NULL;
    size_t size;
    bat_status status = bat_shape_read(from->text, from->size, &shape, said);
    assert_true((status == BAT_OK) == (shape != NULL));
    if (status == BAT_OK) status = bat_shape_write(shape, &text, &size);
    if (status == BAT_OK) bat_free(text);
    bat_shape_free(shape);
    return status;
}

static bat_status as_surface(const file *from, bat_problem *said) {
    bat_surface *surface = NULL;
    char *text = NULL;
    size_t size;
    bat_status status = bat_surface_read(from->text, from->size, &surface, said);
    assert_true((status == BAT_OK) == (surface != NULL));
    if (status == BAT_OK) status = bat_surface_write(surface, &text, &size);
    if (status == BAT_OK) bat_free(text);
    bat_surface_free(surface);
    return status;
}

static bat_status as_spline(const file *from, bat_problem *said) {
    bat_spline spline;
    void *block = NULL;
    bat_status status = bat_spline_read(from->text, from->size, &spline, &block, said);
    if (status == BAT_OK) bat_free(block);
    return status;
}

static bat_status as_stroke(const file *from, bat_problem *said) {
    bat_stroke stroke;
    void *block = NULL;
    bat_status status = bat_stroke_read(from->text, from->size, &stroke, &block, said);
    if (status == BAT_OK) bat_free(block);
    return status;
}

static bat_status as_points(const file *from, bat_problem *said) {
    int dimension;
    size_t count;
    double *points = NULL;
    bat_status status = bat_points_read(from->text, from->size, &dimension, &count, &points, said);
    if (status == BAT_OK) bat_free(points);
    return status;
}

static bat_status as_journal(const file *from, bat_problem *said) {
    bat_editor *editor = NULL;
    bat_status status = bat_editor_create(&editor);
    if (status == BAT_OK) {
        bat_editor_resize(editor, 1280, 800, 1);
        status = bat_editor_replay(editor, from->text, from->size, true, said);
        check(editor);
        bat_editor_frame(editor);
    }
    bat_editor_free(editor);
    return status;
}

static bool load(const char *name, file *out) {
    FILE *from = fopen(name, "rb");
    if (!from) return false;
    fseek(from, 0, SEEK_END);
    *out = (file){name, NULL, (size_t)ftell(from)};
    rewind(from);
    out->text = calloc(out->size + 1, 1);
    const bool good = fread(out->text, 1, out->size, from) == out->size;
    fclose(from);
    return good;
}

/* As with memory; and when it runs out, the status says that or nothing has failed. */
static void fail_each(const file *from, work *perform) {
    bat_problem said = {"", ""};
    const long held = alloc_live();
    const bat_status wanted = perform(from, &said);
    for (bool again = true; again;) {
        said = (bat_problem){"", ""};
        alloc_fail_new(false);
        const bat_status status = perform(from, &said);
        again = alloc_fail_reached();
        if (status != wanted && !(again && status == BAT_MEMORY))
            fail_msg("%s: %s, %s; wanted: %s", from->name, bat_status_message(status), said.message,
                     bat_status_message(wanted));
        if (alloc_live() != held) fail_msg("%s: a leak", from->name);
    }
}

/* binary: also files with zeros in them. */
static void each_of(const char *pattern, bool binary, work *perform) {
    glob_t found;
    assert_int_equal(glob(pattern, 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        file from;
        assert_true(load(found.gl_pathv[i], &from));
        if (binary || !memchr(from.text, 0, from.size)) fail_each(&from, perform);
        free(from.text);
    }
    globfree(&found);
}

static void each(const char *pattern, work *perform) { each_of(pattern, false, perform); }

static void drawings(void **state) {
    (void)state;
    each("docs/pictures/*.svg", as_svg);
    each("examples/*.svg", as_svg);
    each("tests/gestures/starter/drawings/*.svg", as_svg);
    each("web/icons/*.svg", as_svg);
    each("fuzz/corpus/svg/*", as_svg);
    each("fuzz/corpus/obj/*", as_obj);
    each_of("fuzz/corpus/shells/*", true, as_mesh);
    each("fuzz/corpus/dxf/*", as_dxf);
    each("fuzz/corpus/dxf/*", as_gcode);
    each("fuzz/corpus/glif/*", as_glif);
    each("fuzz/corpus/json/csv*", as_csv);
    each("fuzz/corpus/json/geojson*", as_geojson);
    each("fuzz/corpus/json/*", as_native);
}

static void values(void **state) {
    (void)state;
    static work *const readers[] = {as_curve, as_shape, as_surface, as_spline, as_stroke, as_points};
    for (int i = 0; i < 6; i++) {
        each("fuzz/corpus/json/*", readers[i]);
        each("fuzz/corpus/shape/*", readers[i]);
        each("fuzz/corpus/surface/*", readers[i]);
        each("fuzz/corpus/spline/*", readers[i]);
        each("examples/*.csv", readers[i]);
    }
}

static void journals(void **state) {
    (void)state;
    each("tests/journals/*.journal", as_journal);
    each("examples/silhouette/*.journal", as_journal);
    each("fuzz/corpus/journal/*", as_journal);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(drawings), cmocka_unit_test(values),
                                       cmocka_unit_test(journals)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
