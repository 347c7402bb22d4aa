/* label: slow. Valid texts of every kind, each word replaced in turn by each of many others: refused with a reason and
 * no result, or read into something sound. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "format/formats.h"
#include "support/random_curve.h"
#include "support/rounds.h"
#include "support/spoil.h"
#include "support/wild.h"
#include <batten/batten.h>

static const char *const values[] = {"null",       "-1",      "0.5",   "1e300",   "1e90",    "1e9",
                                     "4294967296", "true",    "\"x\"", "\"\"",    "[]",      "{}",
                                     "[null]",     "[[0,0]]", "[1,2]", "[1,2,3]", "[-1,-1]", "[1e90,1e90]"};
enum { VALUES = sizeof values / sizeof *values };

/* Says whether it was taken, after looking at what came of it. */
typedef bool reader(const char *text, bat_problem *problem);

static bool read_curve(const char *text, bat_problem *problem) {
    bat_curve *made = NULL;
    bat_status status = bat_curve_read(text, strlen(text), &made, problem);
    assert_true((made != NULL) == (status == BAT_OK));
    if (made) {
        char *first = NULL, *second = NULL;
        bat_curve *copy = NULL;
        size_t size = 0;
        assert_int_equal(bat_curve_write(made, &first, &size), BAT_OK);
        assert_int_equal(bat_curve_read(first, size, &copy, NULL), BAT_OK);
        assert_int_equal(bat_curve_write(copy, &second, &size), BAT_OK);
        assert_string_equal(first, second);
        bat_curve_free(copy);
        bat_free(first);
        bat_free(second);
    }
    bat_curve_free(made);
    return status == BAT_OK;
}

static bool read_stroke(const char *text, bat_problem *problem) {
    bat_stroke made = {0};
    void *block = NULL;
    bat_status status = bat_stroke_read(text, strlen(text), &made, &block, problem);
    assert_true((block != NULL) == (status == BAT_OK));
    for (size_t i = 0; block && i < made.count * (size_t)made.dimension; i++)
        assert_true(isfinite(made.points[i]));
    bat_free(block);
    return status == BAT_OK;
}

static bool read_spline(const char *text, bat_problem *problem) {
    bat_spline made = {0};
    void *block = NULL;
    bat_status status = bat_spline_read(text, strlen(text), &made, &block, problem);
    assert_true((block != NULL) == (status == BAT_OK));
    if (block) {
        bat_curve *curve = NULL;
        if (bat_tangents(&made, NULL, NULL, NULL, NULL, &curve) == BAT_OK) bat_curve_free(curve);
    }
    bat_free(block);
    return status == BAT_OK;
}

static bool read_shape(const char *text, bat_problem *problem) {
    bat_shape *made = NULL;
    bat_status status = bat_shape_read(text, strlen(text), &made, problem);
    assert_true((made != NULL) == (status == BAT_OK));
    bat_shape_free(made);
    return status == BAT_OK;
}

static bool read_view(const char *text, bat_problem *problem) {
    bat_viewpoint made;
    bat_status status = bat_viewpoint_read(text, strlen(text), &made, problem);
    if (status == BAT_OK) assert_int_equal(bat_viewpoint_check(&made, NULL), BAT_OK);
    return status == BAT_OK;
}

static bool read_canvas(const char *text, bat_problem *problem) {
    bat_canvas made = {.curve = NULL};
    bat_status status = bat_canvas_read(text, strlen(text), &made, problem);
    assert_true(status == BAT_OK || (!made.curve && !made.surface));
    bat_canvas_clear(&made);
    return status == BAT_OK;
}

static bool read_camera(const char *text, bat_problem *problem) {
    bat_camera *camera = NULL;
    const bat_status status = bat_camera_read(text, strlen(text), &camera, problem);
    assert_true((camera != NULL) == (status == BAT_OK));
    if (camera) {
        bat_camera_pose pose;
        bat_camera_at_time(camera, 0.3 * bat_camera_duration(camera), &pose);
        for (int k = 0; k < 3; k++) assert_true(isfinite(pose.position[k]) && isfinite(pose.rotation[k]));
    }
    bat_camera_free(camera);
    return status == BAT_OK;
}

static bool read_sweep(const char *text, bat_problem *problem) {
    bat_sweep_source made = {.path = NULL};
    bat_status status = bat_sweep_read(text, strlen(text), &made, problem);
    assert_true((made.path != NULL) == (status == BAT_OK) && (made.profile != NULL) == (status == BAT_OK));
    if (status == BAT_OK) {
        bat_sweep *sweep = NULL;
        assert_int_equal(bat_function_check(&made.options.twist, NULL), BAT_OK);
        assert_int_equal(bat_function_check(&made.options.scale, NULL), BAT_OK);
        if (bat_sweep_create(made.path, made.profile, &made.options, &sweep) == BAT_OK) {
            bat_sweep_point at;
            bat_sweep_at(sweep, 0.3, 0.3, &at);
            for (int k = 0; k < 3; k++) assert_true(isfinite(at.point[k]) && isfinite(at.normal[k]));
        }
        bat_sweep_free(sweep);
    }
    bat_sweep_source_clear(&made);
    return status == BAT_OK;
}

static bool read_edits(const char *text, bat_problem *problem) {
    static const char flat[] = "{\"base\":{\"degree\":3,\"closed\":false,\"knots\":[0,0,0,0,1,2,2,2,2],"
                               "\"points\":[[0,0],[30,60],[90,60],"
                               "[150,10],[180,0]]},\"levels\":[{\"knots\":[0,0,0,0,0.5,1,2,2,2,2],"
                               "\"details\":[[0,1,0],[1,0,0],[0,2,0],"
                               "[0,1,0],[0,0,0],[0,0,0]]}]}";
    bat_shape *made = NULL;
    assert_int_equal(bat_shape_read(flat, sizeof flat - 1, &made, NULL), BAT_OK);
    bat_status status = bat_shape_edit(made, text, strlen(text), problem);
    bat_shape_free(made);
    return status == BAT_OK;
}

static bool sound(bat_document *document, bat_status status) {
    assert_true((document != NULL) == (status == BAT_OK));
    if (document) assert_null(bat_document_check(document));
    bat_document_free(document);
    return status == BAT_OK;
}

static bool read_document(const char *text, bat_problem *problem) {
    bat_document *made = NULL;
    bat_status status = bat_document_read(text, strlen(text), &made, problem);
    return sound(made, status);
}

static bool read_svg(const char *text, bat_problem *problem) {
    bat_document *made = NULL;
    bat_svg_report report;
    bat_status status = xml_read(text, NULL, &made, &report, problem);
    return sound(made, status);
}

static bool read_obj(const char *text, bat_problem *problem) {
    bat_document *made = NULL;
    bat_svg_report report;
    bat_reading how = {0};
    const bat_format *format = bat_format_named("obj");
    bat_status status = format->read(&how, text, strlen(text), &made, &report, problem);
    return sound(made, status);
}

static bool read_journal(const char *text, bat_problem *problem) {
    bat_editor *editor = NULL;
    assert_int_equal(bat_editor_create(&editor), BAT_OK);
    bat_status status = bat_editor_replay(editor, text, strlen(text), false, problem);
    const char *wrong = bat_editor_check(editor);
    if (wrong) fail_msg("%s", wrong);
    bat_editor_free(editor);
    return status == BAT_OK;
}

static void spoil_word(spoil_words *words, const char *good, int n, const char *by, reader *read) {
    bat_problem problem = {"", ""};
    char *text = spoil(words, good, n, by);
    if (!read(text, &problem) && !problem.message[0]) fail_msg("refused without a reason: %s", text);
    free(text);
}

static void spoil_all(spoil_words *words, const char *good, const char *const *by, int count, reader *read) {
    bat_problem problem = {"", ""};
    if (!read(good, &problem)) fail_msg("%s: %s\n%s", problem.place, problem.message, good);
    int most = spoil_count(words, good);
    for (int n = 0; n < most; n++)
        for (int i = FEWER ? n % 3 : 0; i < count; i += FEWER ? 3 : 1)
            spoil_word(words, good, n, by[i], read);
}

static void values_of_json(void **state) {
    (void)state;
    static const struct {
        const char *text;
        reader *read;
    } good[] = {
        {"{\"degree\":2,\"closed\":false,\"knots\":[0,0,0,1,1,1],\"points\":[[0,0,1],[1,2,1],[3,0,2]]}",
         read_curve},
        {"{\"degree\":2,\"closed\":true,\"knots\":[0,1,2,3],\"points\":[[0,0],[1,2],[3,0]]}", read_curve},
        {"{\"points\":[[0,0],[1,2],[3,0]],\"pressure\":[0.5,1,0],\"time\":[0,4,8]}", read_stroke},
        {"{\"points\":[[0,0],[1,2],[3,0]],\"tangents\":[null,[1,0],[1,-1]],\"closed\":false,\"tension\":[[1,"
         "1],null,"
         "[2,0.5]],\"mode\":\"paper\",\"missing\":\"uniform\"}",
         read_spline},
        {"{\"base\":{\"degree\":1,\"closed\":false,\"knots\":[0,0,1,2,2],\"points\":[[0,0,0],[1,2,1],[3,0,0]]"
         "},"
         "\"levels\":[{\"knots\":[0,0,1,2,2],\"details\":[[0,1,0],[1,0,0],[0,0,1]],\"gain\":0.5,\"muted\":"
         "true}],"
         "\"frame\":\"fixed\",\"nodes\":\"argmax\",\"propagation\":\"plain\",\"first\":{\"t\":[1,0,0],\"s\":["
         "0,1,0]}}",
         read_shape},
        {"{\"eye\":[0,0,9],\"target\":[0,0,0],\"up\":[0,1,0],\"size\":[80,60],\"fov\":40}", read_view},
        {"{\"eye\":[0,0,9],\"target\":[1,0,0],\"up\":[0,1,0],\"size\":[80,60],\"height\":3}", read_view},
        {"{\"curve\":{\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[0,0],[1,1]]},\"along\":[0,0,1]}",
         read_canvas},
        {"{\"plane\":{\"origin\":[0,0,1],\"normal\":[0,1,1]}}", read_canvas},
        {"{\"path\":{\"degree\":2,\"knots\":[0,0,0,1,1,1],\"points\":[[0,0,0],[0,3,1],[4,3,0]]},\"profile\":{"
         "\"degree\":1,\"closed\":false,\"knots\":[0,0,1,1],\"points\":[[-1,0],[1,0]]},\"frame\":\"frenet\","
         "\"first\":{\"s\":[1,0,0]},\"twist\":{\"degree\":2,\"knots\":[0,0,0,1,1,1],\"values\":[0,2,0]},"
         "\"scale\":0.5}",
         read_sweep},
        {"{\"path\":{\"degree\":2,\"closed\":true,\"knots\":[0,1,2,3,4],\"points\":[[0,0,9],[4,0,9],[4,4,9],["
         "0,4,8]]},\"orientation\":{\"mode\":\"free\",\"base\":{\"degree\":1,\"closed\":true,\"knots\":[0,1,"
         "2,3],\"points\":[[0,0,0,1],[0,0,1,1],[0,0,1,-0.5]]},\"levels\":[{\"knots\":[0,2,3,5],\"details\":[["
         "0,0,0.1],[0.1,0,0],[0,0.2,0]],\"gain\":2}]},"
         "\"timing\":{\"duration\":3,\"curve\":{\"degree\":1,\"closed\":false,\"knots\":[0,0,1,1],\"values\":"
         "[0,1]}}}",
         read_camera},
        {"{\"path\":{\"base\":{\"degree\":2,\"closed\":true,\"knots\":[0,1,2,3,4],\"points\":[[0,0,9],[4,0,9]"
         ",[4,4,9],[0,4,8]]},\"levels\":[]},\"orientation\":{\"mode\":\"along\",\"first\":{\"s\":[0,0,1]}},"
         "\"fov\":{\"degree\":1,\"knots\":[0,0,1,1],\"values\":[30,50]}}",
         read_camera},
        {"{\"path\":{\"degree\":2,\"closed\":true,\"knots\":[0,1,2,3,4],\"points\":[[0,0,9],[4,0,9],[4,4,9],["
         "0,4,8]]},\"orientation\":{\"mode\":\"look-at\",\"target\":[2,2,0],\"up\":[0,0,1]}}",
         read_camera},
        {"[{\"type\":\"move\",\"level\":1,\"index\":2,\"delta\":[1,2]},{\"type\":\"drag\",\"level\":0,\"u\":"
         "0.7,"
         "\"delta\":[3,4]},{\"type\":\"gain\",\"level\":1,\"value\":0.5},{\"type\":\"transform\",\"matrix\":["
         "[1,0,0,5],"
         "[0,1,0,6],[0,0,1,0]]},{\"type\":\"sketch\",\"level\":0,\"stroke\":{\"points\":[[10,5],[60,50],[120,"
         "40]]}}]",
         read_edits},
    };
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        spoil_all(spoil_json, good[i].text, values, VALUES, good[i].read);
}

static void words_of_obj(void **state) {
    (void)state;
    static const char good[] = "o edge\nv 0 0 0\nv 1 0 0 1\nv 2 1 0.5\nv 3 0 1\ncstype bspline\ndeg 2\n"
                               "curv 0 2 1 2 3 -1\nparm u 0 0 0 1 2 2 2\nend\n";
    static const char *const by[] = {"",      "x",      "-1",        "0",   "1.5", "99999",
                                     "1e400", "nan",    "# x",       "9",   "deg", "parm u",
                                     "\t",    "\\\n 1", "1 1 1 1 1", "end", "-9",  "\xff"};
    spoil_all(spoil_blanks, good, by, sizeof by / sizeof *by, read_obj);
    char *text = malloc(sizeof good);
    for (size_t size = 0; size < sizeof good; size++) { /* cut off */
        bat_problem problem = {"", ""};
        memcpy(text, good, size);
        text[size] = 0;
        if (!read_obj(text, &problem)) assert_true(problem.message[0]);
    }
    free(text);
}

static const char svg[] =
    "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
    "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' "
    "xmlns:sodipodi='http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd' width='100mm' height='50mm' "
    "viewBox='0 0 200 100' "
    "preserveAspectRatio='xMidYMid meet'><style>.a{fill:red} #p,path.b{stroke:blue}</style>"
    "<defs><linearGradient id='g' xlink:href='#h'/><radialGradient id='h'><stop offset='0.5' "
    "stop-color='#f80' "
    "stop-opacity='0.5'/><stop offset='1' style='stop-color:lime'/></radialGradient>"
    "<symbol id='s' viewBox='0 0 10 10'><circle cx='5' cy='5' r='4'/></symbol></defs>"
    "<g id='layer' inkscape:groupmode='layer' inkscape:label='front' sodipodi:insensitive='true' "
    "transform='translate(3)'>"
    "<path id='p' class='a b' d='M0 0L10 10H5V3C1 2 3 4 5 6S1 1 2 2Q3 3 4 4T9 9A5 4 30 0 1 20 20Z' "
    "fill='url(#g)' "
    "stroke='rgb(1,2,3)' stroke-width='2' stroke-linecap='round' stroke-linejoin='bevel' "
    "stroke-miterlimit='3' "
    "stroke-dasharray='1 2' fill-rule='evenodd' opacity='0.5' marker-end='url(#m)' paint-order='stroke' "
    "vector-effect='non-scaling-stroke'/></g>"
    "<rect x='1' y='2' width='30' height='20' rx='3' ry='4' style='fill:hsl(120,50%,50%);visibility:hidden'/>"
    "<ellipse cx='9' cy='9' rx='5' ry='6' fill='none' stroke='currentColor' color='teal' "
    "transform='rotate(45 3 4)'/>"
    "<line x1='0' y1='0' x2='9' y2='9' stroke='#123456' transform='matrix(1 0 0 1 2 3) skewX(10) scale(2)'/>"
    "<polyline points='0,0 5,5 9,1' transform='rotate(270)'/><polygon points='0 0 5 5 9 1' "
    "clip-path='url(#c)'/>"
    "<use href='#s' x='3' y='4' width='20' height='30'/><use href='#p' transform='skewY(5)'/>"
    "<switch><g systemLanguage='de'><path d='M0 0L1 1'/></g><path d='M0 0L2 2' requiredExtensions='x'/>"
    "<path d='M0 0L3 3'/></switch><svg x='1' y='1' width='9' height='9' viewBox='0 0 5 5' overflow='visible'>"
    "<path d='M0 0L3 3' stroke='red'/></svg>"
    "<image x='1' y='2' width='20' height='10' href='data:image/png;base64,iVBORw0KGgo='/></svg>";

static void words_of_svg(void **state) {
    (void)state;
    static const char *const by[] = {"",
                                     "x",
                                     "-1",
                                     "0",
                                     "1e99",
                                     "1e400",
                                     "50%",
                                     "3mm",
                                     "url(#p)",
                                     "#p",
                                     "none",
                                     "inherit",
                                     "1 2",
                                     " \t\n\f\r5 ,\t6",
                                     "rotate(270)",
                                     "rotate(30,1,2) scale(0)",
                                     "matrix(1\t0\n0\f1\r2 3)",
                                     "matrix(1 2 3 4 5 6 7)",
                                     "translate(1 2 3)",
                                     "0 0 0 0",
                                     "0 0 5",
                                     "defer xMaxYMin slice",
                                     "none meet",
                                     "#ggg",
                                     "#12345",
                                     "rgb(50%,2,3)",
                                     "rgba(1 2 3 / 4%)",
                                     "hsl(1",
                                     "M0 0 1 1z l",
                                     "M0 0A0 0 0 0 0 1 1",
                                     "M1e30 0L-1e30 9",
                                     "data:,x",
                                     "fill:;stroke:url(;width",
                                     "true",
                                     "layer",
                                     "red!important",
                                     "g",
                                     "s",
                                     "\xff"};
    spoil_all(spoil_quoted, svg, by, sizeof by / sizeof *by, read_svg);
}

static void wild_session(uint64_t seed, char **journal, char **document) {
    enum { SIZE = 500 };
    uint8_t data[SIZE];
    random_source r = {seed * 7919};
    for (int i = 0; i < SIZE; i++) data[i] = (uint8_t)random_int(&r, 0, 255);
    session_bytes bytes = {data, SIZE, 0};
    bat_editor *editor = pen_editor();
    double time = 0;
    size_t size = 0;
    while (bytes.at < bytes.size) wild_event(editor, &bytes, &time);
    wild_settle(editor);
    const char *text = bat_editor_journal(editor, &size);
    *journal = malloc(size + 1);
    memcpy(*journal, text, size + 1);
    assert_int_equal(bat_document_write(bat_editor_document(editor), document, &size), BAT_OK);
    bat_editor_free(editor);
}

static void spoil_some(const char *text, int tries, random_source *r, reader *read) {
    const int words = spoil_count(spoil_json, text);
    for (int i = 0; i < tries; i++) {
        const int word = random_int(r, 0, words - 1), value = random_int(r, 0, VALUES - 1);
        spoil_word(spoil_json, text, word, values[value], read);
    }
}

static void values_of_sessions(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= ROUNDS_OF(40); seed++) {
        char *journal = NULL, *document = NULL;
        random_source r = {seed};
        wild_session(seed, &journal, &document);
        spoil_some(journal, 150, &r, read_journal);
        spoil_some(document, 400, &r, read_document);
        free(journal);
        bat_free(document);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(values_of_json), cmocka_unit_test(words_of_obj),
                                       cmocka_unit_test(words_of_svg), cmocka_unit_test(values_of_sessions)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
