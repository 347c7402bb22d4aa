/* Every reader on texts of n things, and calls whose work has a bound whatever they are given.
 * Usage: growth_files [case [n]]; with GROWTH_SHOW in the environment it shows what it has counted. */
#include <batten/batten.h>

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "growth.h"
#include "format/svg/write/feed.h"
#include "support/pen.h"
#include "support/xml.h"
#include "text/text.h"

static const double MOST = 1.15;

/* ---- texts of n things ---- */

static void put(bat_text *text, const char *format, ...) {
    char line[400];
    va_list list;
    va_start(list, format);
    vsnprintf(line, sizeof line, format, list);
    va_end(list);
    bat_text_string(text, line);
}

static void repeat(bat_text *text, const char *what, int n) {
    for (int i = 0; i < n; i++) bat_text_string(text, what);
}

static void numbers(bat_text *text, int n, double from, double step) {
    for (int i = 0; i < n; i++) put(text, "%s%.17g", i ? "," : "", from + step * i);
}

static void points(bat_text *text, int n) {
    put(text, "[");
    for (int i = 0; i < n; i++) put(text, "%s[%.17g,%.17g]", i ? "," : "", 3.1 * i, 9 * sin(i));
    put(text, "]");
}

static void curve(bat_text *text, int n) {
    put(text, "{\"degree\":3,\"closed\":true,\"knots\":[");
    numbers(text, n + 1, 0, 0.7);
    put(text, "],\"points\":");
    points(text, n);
    put(text, "}");
}
static void stroke(bat_text *text, int n) {
    put(text, "{\"points\":");
    points(text, n);
    put(text, ",\"pressure\":[");
    numbers(text, n, 0.1, 0);
    put(text, "],\"time\":[");
    numbers(text, n, 0, 4.25);
    put(text, "]}");
}
static void table(bat_text *text, int n) {
    put(text, "x,y,pressure,time\n");
    for (int i = 0; i < n; i++) put(text, "%.17g,%.17g,0.5,%d\n", 3.1 * i, 9 * sin(i), 4 * i);
}
static void spline(bat_text *text, int n) {
    put(text, "{\"points\":");
    points(text, n);
    put(text, ",\"tangents\":[");
    for (int i = 0; i < n; i++) put(text, "%s%s", i ? "," : "", i % 2 ? "null" : "[1,0.3]");
    put(text, "]}");
}
static void shape(bat_text *text, int n) {
    put(text, "{\"base\":");
    curve(text, n);
    put(text, ",\"levels\":[{\"knots\":[");
    numbers(text, n + 1, 0, 0.7);
    put(text, "],\"details\":[");
    for (int i = 0; i < n; i++) put(text, "%s[0,%.17g,0]", i ? "," : "", sin(i));
    put(text, "]}]}");
}
static void edits(bat_text *text, int n) {
    put(text, "[");
    for (int i = 0; i < n; i++)
        put(text, "%s{\"type\":\"move\",\"level\":%d,\"index\":%d,\"delta\":[0.1,0.2]}", i ? "," : "", i % 2,
            i % 40);
    put(text, "]");
}
static void members(bat_text *text, int n) {
    put(text, "{\"degree\":3");
    for (int i = 0; i < n; i++) put(text, ",\"member%d\":{\"a\":[1,\"\\u00e4\"]}", i);
    put(text, "}");
}
static void deep(bat_text *text, int n) {
    repeat(text, "[", n);
    repeat(text, "]", n);
}
static void digits(bat_text *text, int n) {
    put(text, "[");
    repeat(text, "7", n);
    put(text, ".");
    repeat(text, "3", n);
    put(text, "e-%d]", n);
}
static void letters(bat_text *text, int n) {
    put(text, "{\"degree\":\"");
    repeat(text, "\\u00e4\\n", n);
    put(text, "\"}");
}

static void svg_begin(bat_text *text) {
    put(text, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1000 1000'>");
}
static void svg_end(bat_text *text) { put(text, "</svg>"); }

static void groups(bat_text *text, int n) {
    svg_begin(text);
    for (int i = 0; i < n; i++) put(text, "<g id='g%d'><path d='M0,%d L10.5,20'/></g>", i, i % 100);
    svg_end(text);
}
static void groups_in_one(bat_text *text, int n) {
    svg_begin(text);
    put(text, "<g>");
    for (int i = 0; i < n; i++) put(text, "<g><path d='M0,%d L10.5,20'/></g>", i % 100);
    put(text, "</g>");
    svg_end(text);
}
static void nested(bat_text *text, int n) {
    svg_begin(text);
    repeat(text, "<g opacity='0.9'>", n);
    put(text, "<path d='M0,0 L10,20'/>");
    repeat(text, "</g>", n);
    svg_end(text);
}
static void lines(bat_text *text, int n) {
    svg_begin(text);
    put(text, "<path d='M0,0");
    for (int i = 0; i < n; i++) put(text, "L%d.5,%d", i, i % 7);
    put(text, "'/>");
    svg_end(text);
}
static void smooth(bat_text *text, int n) {
    svg_begin(text);
    put(text, "<path stroke='red' d='M0,0C1,1,2,1,3,0");
    for (int i = 1; i < n; i++)
        put(text, "S%d,%d,%d,%.17g", 3 * i + 2, i % 2 ? -1 : 1, 3 * i + 3, 0.1 * sin(i));
    put(text, "'/>");
    svg_end(text);
}
static void subpaths(bat_text *text, int n) {
    svg_begin(text);
    put(text, "<path d='");
    for (int i = 0; i < n; i++) put(text, "M%d,%dh8v8z", i % 99, i / 99);
    put(text, "'/>");
    svg_end(text);
}
static void arcs(bat_text *text, int n) {
    svg_begin(text);
    put(text, "<path d='M0,0");
    for (int i = 0; i < n; i++) put(text, "a5,4 %d 1 %d 3,1", i % 90, i % 2);
    put(text, "'/>");
    svg_end(text);
}
static void uses(bat_text *text, int n) {
    svg_begin(text);
    put(text, "<defs>");
    for (int i = 0; i < n; i++) put(text, "<path id='p%d' d='M0,0L1,%d'/>", i, i);
    put(text, "</defs>");
    for (int i = 0; i < n; i++) put(text, "<use href='#p%d' x='%d'/>", n - 1 - i, i);
    svg_end(text);
}
static void chain(bat_text *text, int n) { /* each the next */
    svg_begin(text);
    for (int i = 0; i < n; i++)
        put(text, "<linearGradient id='a%d' href='#a%d'><stop stop-color='red'/></linearGradient>", i, i + 1);
    for (int i = 0; i < n; i++) put(text, "<rect width='3' height='3' fill='url(#a%d)'/>", i);
    svg_end(text);
}
static void sheet(bat_text *text, int n) {
    svg_begin(text);
    put(text, "<style>");
    for (int i = 0; i < n; i++) put(text, ".c%d{fill:#%06x;stroke:red}", i, i);
    put(text, "</style>");
    for (int i = 0; i < n; i++) put(text, "<circle class='c%d' r='5'/>", i);
    svg_end(text);
}
static void declared(bat_text *text, int n) {
    svg_begin(text);
    put(text, "<path d='M0,0L1,1' style='");
    for (int i = 0; i < n; i++) put(text, "fill:#%06x;", i);
    put(text, "'/>");
    svg_end(text);
}
static void transformed(bat_text *text, int n) {
    svg_begin(text);
    put(text, "<path d='M0,0L1,1' transform='");
    for (int i = 0; i < n; i++) put(text, "rotate(%d 3 4) ", i);
    put(text, "'/>");
    svg_end(text);
}
static void words(bat_text *text, int n) {
    svg_begin(text);
    for (int i = 0; i < n; i++)
        put(text, "<title>t%d</title><text x='1'>a<tspan>b</tspan></text><!-- c -->", i);
    svg_end(text);
}
static void foreign(bat_text *text, int n) {
    svg_begin(text);
    for (int i = 0; i < n; i++) put(text, "<a%d:b x='%d'/><path d='M0,0L1,2' c:d%d='e'/>", i, i, i);
    svg_end(text);
}

static void foreign_lines(bat_text *text, int n) {
    svg_begin(text);
    put(text, "<style>path{stroke:red}rect{fill:none}</style>");
    for (int i = 0; i < n; i++)
        put(text, "<text>%d</text><rect width='%d' height='2' stroke='blue'/>", i, i + 1);
    svg_end(text);
}

static void native(bat_text *text, int n, bool grouped) {
    bat_document *document = NULL;
    bat_object *object = NULL;
    char *written = NULL;
    size_t size = 0;
    if (bat_document_create(&document) != BAT_OK) abort();
    for (int i = 0; i < n; i++) {
        bat_id parent = 0;
        if (grouped) {
            parent = bat_document_new_id(document);
            if (bat_object_create_group(parent, "group", false, &object) != BAT_OK) abort();
            bat_document_insert(document, bat_document_count(document), object);
            bat_object_release(object);
        }
        bat_id id = pen_add(document, pen_curve(i + 0.1234567, i % 50, 7, 20, 5));
        bat_object *placed = NULL;
        int at = bat_document_find(document, id);
        if (bat_object_with_parent(bat_document_at(document, at), parent, &placed) != BAT_OK) abort();
        if (bat_document_replace(document, at, placed) != BAT_OK) abort();
        bat_object_release(placed);
    }
    if (bat_document_write(document, &written, &size) != BAT_OK) abort();
    bat_text_add(text, written, size);
    bat_free(written);
    bat_document_free(document);
}
static void native_lines(bat_text *text, int n) { native(text, n, false); }
static void native_groups(bat_text *text, int n) { native(text, n, true); }

/* n vertices, faces of them, and a B-spline of n points. */
static void obj(bat_text *text, int n) {
    for (int i = 0; i < n; i++) put(text, "v %.17g %d %.17g\n", 0.7 * i, i % 7, sin(i));
    for (int i = 2; i < n; i++) put(text, "f %d/1 %d/2 -1\n", i - 1, i);
    put(text, "cstype bspline\ndeg 3\ncurv 0 1");
    for (int i = 0; i < n; i++) put(text, " %d", i + 1);
    put(text, "\nparm u");
    for (int i = 0; i < n + 4; i++) put(text, " %d", i < 4 ? 0 : i < n ? i - 3 : n - 3);
    put(text, "\nend\n");
}
/* n straight curves, each with vertices of its own. */
static void obj_curves(bat_text *text, int n) {
    put(text, "cstype bspline\ndeg 1\n");
    for (int i = 0; i < n; i++)
        put(text, "o part\nv 0 %d 0\nv 1 0 %d\ncurv 0 1 -2 -1\nparm u 0 0 1 1\nend\n", i, i);
}
/* One surface of n by 4 points and n curves, as the library writes them. */
static void model(bat_text *text, int n, bat_status (*write)(const bat_model *, char **, size_t *)) {
    bat_text obj_text = {0};
    bat_model made;
    char *bytes;
    size_t size;
    obj_curves(&obj_text, n);
    for (int i = 0; i < 4 * n; i++) put(&obj_text, "v %d %d %.17g\n", i % n, i / n, sin(i));
    put(&obj_text, "deg 3 3\nsurf 0 %d 0 1", n - 3);
    for (int i = 0; i < 4 * n; i++) put(&obj_text, " %d", i - 4 * n);
    put(&obj_text, "\nparm u");
    for (int i = 0; i < n + 4; i++) put(&obj_text, " %d", i < 4 ? 0 : i < n ? i - 3 : n - 3);
    put(&obj_text, "\nparm v 0 0 0 0 1 1 1 1\nend\n");
    if (bat_obj_read(obj_text.data, obj_text.size, &made, NULL) != BAT_OK) abort();
    if (write(&made, &bytes, &size) != BAT_OK) abort();
    bat_text_add(text, bytes, size);
    bat_free(bytes);
    bat_model_clear(&made);
    bat_text_free(&obj_text);
}
static void iges(bat_text *text, int n) { model(text, n, bat_iges_write); }
static void step(bat_text *text, int n) { model(text, n, bat_step_write); }

/* n strokes: each a line of its own, one over the other, or all over one curve. */
static void session(bat_text *text, int n, double height) {
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    size_t size = 0;
    for (int i = 0; i < n; i++) {
        double y = height > 0 ? 210 + height * i / n : 200;
        pen_stroke(&p, pen_arch, (double[]){300 + i % 7, y, 500 + i % 5, y, i % 2 ? 8 : -8}, 24);
        p.time += 1000;
    }
    const char *journal = bat_editor_journal(editor, &size);
    bat_text_add(text, journal, size);
    bat_editor_free(editor);
}
static void strokes_apart(bat_text *text, int n) { session(text, n, 40.0 * n); }
static void strokes_over(bat_text *text, int n) { session(text, n, 0); }
static void nudges(bat_text *text, int n) {
    bat_editor *editor = pen_editor();
    size_t size = 0;
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    for (int i = 0; i < n; i++) bat_editor_command(editor, i % 3 ? "nudge-left" : "duplicate");
    const char *journal = bat_editor_journal(editor, &size);
    bat_text_add(text, journal, size);
    bat_editor_free(editor);
}

/* ---- readers ---- */

static void read_curve(const char *text, size_t size) {
    bat_curve *made = NULL;
    (void)bat_curve_read(text, size, &made, NULL);
    bat_curve_free(made);
}
static void read_stroke(const char *text, size_t size) {
    bat_stroke made;
    void *block = NULL;
    if (bat_stroke_read(text, size, &made, &block, NULL) != BAT_OK) abort();
    bat_free(block);
}
static void read_points(const char *text, size_t size) {
    int dimension;
    size_t count;
    double *points = NULL;
    if (bat_points_read(text, size, &dimension, &count, &points, NULL) != BAT_OK) abort();
    bat_free(points);
}
static void read_spline(const char *text, size_t size) {
    bat_spline made;
    void *block = NULL;
    if (bat_spline_read(text, size, &made, &block, NULL) != BAT_OK) abort();
    bat_free(block);
}
static void read_shape(const char *text, size_t size) {
    bat_shape *made = NULL;
    if (bat_shape_read(text, size, &made, NULL) != BAT_OK) abort();
    bat_shape_free(made);
}
static void read_edits(const char *text, size_t size) {
    bat_text base = {0};
    bat_shape *made = NULL;
    shape(&base, 40);
    if (bat_shape_read(base.data, base.size, &made, NULL) != BAT_OK) abort();
    if (bat_shape_edit(made, text, size, NULL) != BAT_OK) abort();
    bat_text_free(&base);
    bat_shape_free(made);
}
static void read_document(const char *text, size_t size) {
    bat_document *made = NULL;
    if (bat_document_read(text, size, &made, NULL) != BAT_OK) abort();
    bat_document_free(made);
}
static void read_svg(const char *text, size_t size) {
    bat_document *made = NULL;
    bat_svg_report report;
    bat_svg_options options[] = {bat_svg_defaults(), bat_svg_merging()};
    (void)size;
    for (int i = 0; i < 2; i++) {
        made = NULL;
        (void)xml_read(text, &options[i], &made, &report, NULL);
        bat_document_free(made);
    }
}
/* Keeps the file, edits each of its shapes (moved, painted, removed, or copied), and writes it with the native document. */
static void edit_kept(const char *text, size_t size) {
    bat_svg_reader *reader;
    bat_document *made = NULL;
    char *written;
    const double rows[6] = {1, 0, 2, 0, 1, 3};
    if (bat_svg_reader_create(NULL, &reader) != BAT_OK ||
        bat_svg_reader_source(reader, text, size) != BAT_OK || bat_svg_feed(text, size, reader) != BAT_OK ||
        bat_svg_reader_finish(reader, &made, NULL, NULL) != BAT_OK)
        abort();
    for (int i = bat_document_count(made) - 1; i >= 0; i--) {
        const bat_object *object = bat_document_at(made, i);
        bat_style style = *bat_object_style(object);
        bat_object *edited = NULL;
        bat_curve *curve = NULL;
        if (!bat_object_is_drawn(object)) continue;
        style.width += 1;
        if (i % 4 == 0) bat_document_remove(made, i);
        if (i % 4 == 1) bat_object_with_style(object, &style, &edited);
        if (i % 4 == 2 && bat_curve_transform(bat_object_curve(object, 0), rows, &curve) == BAT_OK)
            bat_object_with_curve(object, 0, curve, &edited);
        if (edited) bat_document_replace(made, i, edited);
        if (i % 4 == 3 && bat_object_with_id(object, bat_document_new_id(made), &edited) == BAT_OK)
            bat_document_insert(made, i + 1, edited);
        bat_object_release(edited);
    }
    if (bat_svg_write(made, true, &written, &size) != BAT_OK) abort();
    bat_free(written);
    bat_document_free(made);
}
static void read_model(const char *text, size_t size,
                       bat_status (*read)(const char *, size_t, bat_model *, bat_problem *)) {
    bat_model made;
    if (read(text, size, &made, NULL) != BAT_OK) abort();
    bat_model_clear(&made);
}
static void read_obj(const char *text, size_t size) { read_model(text, size, bat_obj_read); }
static void read_iges(const char *text, size_t size) { read_model(text, size, bat_iges_read); }
static void read_step(const char *text, size_t size) { read_model(text, size, bat_step_read); }
static void read_journal(const char *text, size_t size) {
    bat_editor *editor = NULL;
    if (bat_editor_create(&editor) != BAT_OK) abort();
    if (bat_editor_replay(editor, text, size, true, NULL) != BAT_OK) abort();
    bat_editor_free(editor);
}

typedef struct kind {
    const char *name;
    void (*make)(bat_text *text, int n);
    void (*read)(const char *text, size_t size);
    int n; /* the middle size */
} kind;

static const kind kinds[] = {
    {"a curve of n points", curve, read_curve, 800},
    {"a stroke of n samples", stroke, read_stroke, 800},
    {"a stroke of n samples as CSV", table, read_stroke, 800},
    {"n points", stroke, read_points, 800},
    {"n points as columns", table, read_points, 800},
    {"a spline of n points", spline, read_spline, 400},
    {"a shape of n points", shape, read_shape, 400},
    {"n edits of a shape", edits, read_edits, 100},
    {"n members that nobody knows", members, read_curve, 800},
    {"n brackets", deep, read_curve, 800},
    {"a number of n digits", digits, read_curve, 800},
    {"a word of n letters", letters, read_curve, 800},
    {"a document of n lines", native_lines, read_document, 200},
    {"a document of n groups", native_groups, read_document, 200},
    {"OBJ of n vertices", obj, read_obj, 400},
    {"OBJ of n curves", obj_curves, read_obj, 200},
    {"IGES of n entities", iges, read_iges, 200},
    {"STEP of n entities", step, read_step, 200},
    {"n groups", groups, read_svg, 400},
    {"n groups in one", groups_in_one, read_svg, 400},
    {"n groups in each other", nested, read_svg, 40},
    {"a path of n lines", lines, read_svg, 400},
    {"a smooth path of n segments", smooth, read_svg, 400},
    {"a path of n subpaths", subpaths, read_svg, 200},
    {"a path of n arcs", arcs, read_svg, 200},
    {"n uses", uses, read_svg, 400},
    {"n gradients in a row", chain, read_svg, 100},
    {"n rules of style", sheet, read_svg, 400},
    {"n properties of style", declared, read_svg, 800},
    {"n transforms", transformed, read_svg, 800},
    {"n texts", words, read_svg, 400},
    {"n foreign elements", foreign, read_svg, 400},
    {"n edits of a file that is kept", foreign_lines, edit_kept, 400},
    {"n edits of copies in a file that is kept", uses, edit_kept, 200},
    {"a journal of n strokes beside each other", strokes_apart, read_journal, 32},
    {"a journal of n strokes over each other", strokes_over, read_journal, 128}, /* up to 32 converge */
    {"a journal of n steps", nudges, read_journal, 16},
};

static bool judge_kind(const kind *k, int n) {
    uint64_t work[GROWTH_SIZES];
    int size = n / 4;
    for (int i = 0; i < GROWTH_SIZES; i++, size *= 4) {
        bat_text text = {0};
        char *data = NULL;
        size_t bytes = 0;
        k->make(&text, size);
        if (bat_text_finish(&text, &data, &bytes) != BAT_OK) abort();
        uint64_t before = growth_work;
        k->read(data, bytes);
        work[i] = growth_work - before;
        bat_free(data);
    }
    if (getenv("GROWTH_SHOW"))
        printf("%s: n^%.2f %llu %llu %llu\n", k->name, growth_exponent(work), (unsigned long long)work[0],
               (unsigned long long)work[1], (unsigned long long)work[2]);
    return growth_judge("reading", k->name, work, n, MOST);
}

/* ---- calls whose work has a bound ---- */

static uint64_t next_random(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return *state >> 33;
}

/* Each `use` of the last level stands for 10^levels shapes. */
static void bomb(int levels) {
    bat_text text = {0};
    char *data = NULL;
    size_t size = 0;
    svg_begin(&text);
    put(&text, "<defs><g id='l0'><path d='M0,0L1,1' stroke='red'/></g>");
    for (int i = 1; i <= levels; i++) {
        put(&text, "<g id='l%d'>", i);
        for (int k = 0; k < 10; k++) put(&text, "<use href='#l%d'/>", i - 1);
        put(&text, "</g>");
    }
    put(&text, "</defs><use href='#l%d'/>", levels);
    svg_end(&text);
    bat_document *made = NULL;
    bat_svg_report report;
    if (bat_text_finish(&text, &data, &size) != BAT_OK) abort();
    (void)xml_read(data, NULL, &made, &report, NULL);
    bat_document_free(made);
    bat_free(data);
}
static void bomb_of_8(unsigned seed) {
    (void)seed;
    bomb(8);
}
static void bomb_of_40(unsigned seed) {
    (void)seed;
    bomb(40);
}

/* A curve of few points that have nothing to do with each other: any bits, or sizes far apart. */
static bat_curve *odd_curve(uint64_t *state) {
    double points[24], knots[20], t = 0;
    int degree = 1 + (int)(next_random(state) % 7), n = degree + 1 + (int)(next_random(state) % 4);
    bool any_bits = next_random(state) % 2;
    for (int i = 0; i < 2 * n; i++) {
        uint64_t bits = next_random(state) << 33 ^ next_random(state) << 10;
        double value = ldexp((double)(next_random(state) % 2000) - 1000, -(int)(next_random(state) % 1060));
        if (any_bits) memcpy(&value, &bits, sizeof value);
        points[i] = fabs(value) < 1e90 ? value : 0;
    }
    for (int i = 0; i < n + degree + 1; i++) {
        knots[i] = t;
        if (i >= degree && i < n) t += next_random(state) % 3 ? ldexp(1, -(int)(next_random(state) % 40)) : 1;
    }
    bat_curve *made = NULL;
    return bat_curve_create(2, degree, false, (size_t)n, points, n + degree + 1, knots, &made) == BAT_OK
               ? made
               : NULL;
}
static void measure(unsigned seed) {
    uint64_t state = seed;
    bat_curve *odd = odd_curve(&state);
    if (!odd) return;
    double domain[2], u[8];
    bat_near near, all[8];
    size_t count;
    bat_curve_domain(odd, domain);
    const double point[2] = {bat_curve_points(odd)[0] * 3, 1e-3};
    (void)bat_curve_nearest(odd, point, &near);
    (void)bat_curve_nearest_all(odd, point, INFINITY, 8, all, &count);
    double length = bat_curve_length(odd, domain[0], domain[1], 1e-9);
    (void)bat_curve_at_length(odd, domain[0], length / 2, 1e-9);
    (void)bat_curve_inflections(odd, 8, u);
    bat_curve_free(odd);
}

/* A stroke of noise, and a tolerance that no curve of few knots meets; every fourth one is long. */
static void sketch(unsigned seed) {
    enum { SAMPLES = 5000 };
    static double x[2 * SAMPLES];
    uint64_t state = seed;
    const int count = seed % 4 ? 400 : SAMPLES;
    for (int i = 0; i < count; i++) {
        x[2 * i] = 200 + 600.0 * i / count;
        x[2 * i + 1] = 200 + 0.01 * (double)(next_random(&state) % (seed % 2 ? 2000 : 200));
    }
    bat_stroke samples = {.dimension = 2, .count = (size_t)count, .points = x};
    bat_sketch_options options = bat_sketch_defaults();
    options.tolerance = seed % 3 ? 1e-3 : 0.1;
    bat_curve *base = pen_curve(200, 200, 60, 0, 11), *made = NULL;
    bat_status status = bat_sketch(base, &samples, &options, &made, NULL);
    if (status == BAT_OK || status == BAT_TOLERANCE) bat_curve_free(made);
    made = NULL;
    status = bat_sketch_new(&samples, false, &options, &made, NULL);
    if (status == BAT_OK || status == BAT_TOLERANCE) bat_curve_free(made);
    bat_curve_free(base);
}

/* Straight legs with random turns, some thousand corners, as long as they like: more knots to begin with than can be
 * solved for often. */
static void scribble(unsigned seed) {
    enum { SAMPLES = 12000 };
    static double x[2 * SAMPLES];
    uint64_t state = seed + 1;
    const int each = 2 + (int)(seed % 3) * 3; /* samples of a leg */
    const double size = seed % 2 ? 8 : 50;
    double to[2] = {500, 400}, from[2] = {500, 400};
    for (int i = 0; i < SAMPLES; i++) {
        for (int k = 0; k < 2 && i % each == 0; k++) {
            from[k] = to[k];
            to[k] += size * (1e-3 * (double)(next_random(&state) % 2000) - 1);
        }
        for (int k = 0; k < 2; k++)
            x[2 * i + k] = from[k] + (double)(i % each + 1) / each * (to[k] - from[k]);
    }
    bat_stroke samples = {.dimension = 2, .count = SAMPLES, .points = x};
    bat_sketch_options options = bat_sketch_defaults();
    options.tolerance = 1e-3;
    bat_curve *made = NULL;
    if (bat_sketch_new(&samples, false, &options, &made, NULL) != BAT_TOLERANCE) abort();
    bat_curve_free(made);
}

/* One sample far beyond the others: the curve runs there, and nearest points on it are long sought. */
static void jump(unsigned seed) {
    const double far = seed % 2 ? 1.75e98 : 1e40;
    const double x[] = {-9, -9, -18, -18, -24, -16, -33, -18, -39, far};
    bat_stroke samples = {.dimension = 2, .count = 5, .points = x};
    bat_sketch_options options = bat_sketch_defaults();
    options.tolerance = 3, options.pixel = seed / 2 % 2 ? 125 : 1;
    bat_curve *made = NULL;
    (void)bat_sketch_new(&samples, false, &options, &made, NULL);
    bat_curve_free(made);
}

typedef struct bound {
    const char *name;
    void (*perform)(unsigned seed);
    unsigned seeds;
    double most; /* millions of blocks */
} bound;

static const bound bounds[] = {
    {"a use of 10^8 shapes", bomb_of_8, 1, 1200},
    {"a use of 10^40 shapes", bomb_of_40, 1, 1200},
    {"odd curves measured", measure, 3000, 1},
    {"a stroke that no tolerance can meet", sketch, 12, 60},
    {"a scribble of thousands of corners", scribble, 12, 45},
    {"a stroke with a sample far away", jump, 4, 80},
};

static bool judge_bound(const bound *b) {
    uint64_t most = 0;
    for (unsigned seed = 0; seed < b->seeds; seed++) {
        uint64_t before = growth_work;
        b->perform(seed);
        if (growth_work - before > most) most = growth_work - before;
    }
    if (getenv("GROWTH_SHOW")) printf("%s: %.3f million\n", b->name, (double)most / 1e6);
    if ((double)most <= 1e6 * b->most) return false;
    printf("%s: %.3f million blocks of work, %g are allowed\n", b->name, (double)most / 1e6, b->most);
    return true;
}

int main(int count, char **arguments) {
    int faults = 0, judged = 0;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        if (count > 1 && strcmp(arguments[1], kinds[i].name) != 0) continue;
        faults += judge_kind(&kinds[i], count > 2 ? (int)strtol(arguments[2], NULL, 10) : kinds[i].n);
        judged++;
    }
    for (size_t i = 0; i < sizeof bounds / sizeof *bounds; i++) {
        if (count > 1 && strcmp(arguments[1], bounds[i].name) != 0) continue;
        faults += judge_bound(&bounds[i]);
        judged++;
    }
    printf("%d readings, %d faults\n", judged, faults);
    return faults > 0 || judged == 0;
}
