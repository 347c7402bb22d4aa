/* Models: OBJ and JSON there and back bit for bit, files of other programs, what is refused, binary files by their
 * layout; every allocation may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/mesh.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"
#include "support/random_surface.h"

typedef bat_status reader(const char *text, size_t size, bat_model *out, bat_problem *problem);
typedef bat_status writer(const bat_model *model, char **text, size_t *size);

static bat_model read_obj(const char *text) {
    bat_model model;
    bat_problem problem;
    assert_int_equal(bat_obj_read(text, strlen(text), &model, &problem), BAT_OK);
    return model;
}

static bool alike(const bat_model *a, const bat_model *b) {
    if (!a->mesh != !b->mesh || a->surface_count != b->surface_count || a->curve_count != b->curve_count)
        return false;
    if (a->mesh && !bat_polymesh_is_equal(a->mesh, b->mesh)) return false;
    for (size_t i = 0; i < a->surface_count; i++)
        if (!bat_surface_is_equal(a->surfaces[i], b->surfaces[i])) return false;
    for (size_t i = 0; i < a->curve_count; i++)
        if (!bat_curve_is_equal(a->curves[i], b->curves[i])) return false;
    return true;
}

static bat_polymesh *random_mesh(random_source *r) {
    double at[60];
    int sizes[10], corners[60];
    const int vertices = random_int(r, 1, 20), faces = random_int(r, 0, 10);
    int count = 0;
    bat_polymesh *mesh = NULL;
    for (int i = 0; i < 60; i++) at[i] = random_between(r, -9, 9);
    for (int f = 0; f < faces; f++) {
        sizes[f] = random_int(r, 3, 6);
        for (int k = 0; k < sizes[f]; k++) corners[count++] = random_int(r, 0, vertices - 1);
    }
    assert_int_equal(bat_polymesh_create((size_t)vertices, at, (size_t)faces, sizes, corners, &mesh, NULL),
                     BAT_OK);
    return mesh;
}

static bat_surface *surface_of(random_source *r) {
    int degree[2], kind[2], spans[2];
    for (int d = 0; d < 2; d++) {
        degree[d] = random_int(r, 1, 4);
        kind[d] = random_int(r, 0, 2);
        spans[d] = random_int(r, 2, 5);
    }
    return random_surface(r, degree, kind, spans);
}

static void there_and_back(void **state) {
    (void)state;
    random_source r = {31};
    for (int run = 0; run < 200; run++) {
        enum { MOST = 3 };
        bat_surface *surfaces[MOST];
        bat_curve *curves[MOST];
        bat_model model = {.surfaces = surfaces, .curves = curves};
        const int surface_count = random_int(&r, 0, MOST), curve_count = random_int(&r, 0, MOST);
        if (run % 2 || surface_count + curve_count == 0) model.mesh = random_mesh(&r);
        for (int i = 0; i < surface_count; i++) surfaces[model.surface_count++] = surface_of(&r);
        for (int i = 0; i < curve_count; i++) {
            const int degree = random_int(&r, 1, 7), kind = random_int(&r, 0, 2);
            curves[model.curve_count++] = random_curve(&r, degree, 2 + run % 2, kind, 4);
        }
        for (int k = 0; k < 2; k++) {
            reader *const read = k ? bat_model_read : bat_obj_read;
            writer *const write = k ? bat_model_write : bat_obj_write;
            char *text;
            size_t size;
            bat_model back;
            bat_problem problem;
            assert_int_equal(write(&model, &text, &size), BAT_OK);
            assert_int_equal(read(text, size, &back, &problem), BAT_OK);
            assert_true(alike(&model, &back));
            assert_int_equal(back.left_out, 0);
            assert_true(bat_model_size(&back) == bat_model_size(&model));
            bat_free(text);
            bat_model_clear(&back);
        }
        model.surfaces = NULL, model.curves = NULL; /* they are on the stack */
        for (size_t i = 0; i < model.surface_count; i++) bat_surface_free(surfaces[i]);
        for (size_t i = 0; i < model.curve_count; i++) bat_curve_free(curves[i]);
        model.surface_count = model.curve_count = 0;
        bat_model_clear(&model);
    }
}

/* Numbers from the end, with textures and normals, groups, lines that go on, polylines; a weight that all share. */
static void from_others(void **state) {
    (void)state;
    bat_model m = read_obj(
        "\xEF\xBB\xBF# made by hand\r\nmtllib a.mtl\r\nv 0 0 0\r\nv 1 0 0 0.5 0.5 0.5\r\nv 1 1 0\r\n"
        "vt 0 0\r\nvn 0 0 1\r\ng left\r\nusemtl red\r\ns 1\r\nf 1/1/1 2//1 \\\r\n -1/1\r\n"
        "v 5 5 5\r\nf -4 -3 -2 4\r\nl 1 2\r\nf 1 2\r\n");
    size_t count;
    assert_int_equal(bat_polymesh_vertex_count(m.mesh), 4);
    assert_int_equal(bat_polymesh_face_count(m.mesh), 2);
    assert_memory_equal(bat_polymesh_face(m.mesh, 0, &count), ((const int[3]){0, 1, 2}), 3 * sizeof(int));
    assert_memory_equal(bat_polymesh_face(m.mesh, 1, &count), ((const int[4]){0, 1, 2, 3}), 4 * sizeof(int));
    assert_int_equal(count, 4);
    assert_int_equal(m.left_out, 2);
    bat_model_clear(&m);
    m = read_obj(
        "v 0 0 0 2\nv 1 0 0 2\nv 0 1 0 2\nv 1 1 7 2\nv 9 9 9\ncstype rat bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 "
        "3 4\nparm u 0 0 1 1\nparm v 0 0 1 1\nend\n");
    double at[3];
    assert_true(m.surface_count == 1 && !m.mesh);
    bat_surface_eval(m.surfaces[0], 1, 0, 0, at); /* u runs first in the file */
    assert_true(at[0] == 1 && at[1] == 0);
    bat_surface_eval(m.surfaces[0], 0.5, 0.5, 0, at);
    assert_true(at[2] == 1.75);
    bat_model_clear(&m);
    m = read_obj("v 1 2 3\nv 4 5 6\n");
    assert_true(bat_polymesh_vertex_count(m.mesh) == 2 && bat_polymesh_face_count(m.mesh) == 0);
    bat_model_clear(&m);
    m = read_obj("v 1 2 3\nv 4 5 6\nv 7 7 7\nv 8 8 8\np 4 1\ncstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 0 "
                 "1 1\nend\n");
    assert_true(m.curve_count == 1 && bat_polymesh_vertex_count(m.mesh) == 3); /* all but vertex 2 */
    bat_model_clear(&m);
}

static void what_cannot_be_written(void **state) {
    (void)state;
    const bat_model empty = {.mesh = NULL};
    bat_model cloud = read_obj("v 1 2 3\n"), far = read_obj("v 1 2 3e40\nv 0 0 0\nv 1 0 0\nf 1 2 3\n");
    char *bytes = NULL;
    size_t size = 0;
    assert_int_equal(bat_obj_write(&empty, &bytes, &size), BAT_COUNT);
    assert_int_equal(bat_model_write(&empty, &bytes, &size), BAT_COUNT);
    assert_int_equal(bat_stl_write(&empty, 0, &bytes, &size), BAT_COUNT);
    assert_int_equal(bat_gltf_write(&empty, 0, &bytes, &size), BAT_COUNT);
    assert_int_equal(bat_stl_write(&cloud, 0, &bytes, &size), BAT_COUNT);
    assert_int_equal(bat_stl_write(&far, 0, &bytes, &size), BAT_NUMBER);
    assert_int_equal(bat_stl_write(NULL, 0, &bytes, &size), BAT_ARGUMENT);
    assert_int_equal(bat_stl_write(&far, 0, NULL, &size), BAT_ARGUMENT);
    assert_int_equal(bat_stl_write(&far, 0, &bytes, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_stl_write(&far, -1, &bytes, &size), BAT_ARGUMENT);
    assert_int_equal(bat_gltf_write(&far, 0, &bytes, &size), BAT_NUMBER);
    assert_int_equal(bat_gltf_write(&far, -1, &bytes, &size), BAT_ARGUMENT);
    assert_null(bytes);
    bat_model read;
    bat_problem problem;
    assert_int_equal(bat_obj_read("# nothing\n", 10, &read, &problem), BAT_COUNT);
    assert_int_equal(bat_model_read("[]", 2, &read, &problem), BAT_COUNT);
    assert_int_equal(bat_model_read("3", 1, &read, &problem), BAT_SYNTAX);
    bat_model_clear(&cloud);
    bat_model_clear(&far);
    bat_model_clear(NULL);
}

/* What a tolerance asks of a line: the chords of a circle-like curve are within it, and fewer would not be. */
static uint32_t word(const char *at) {
    uint32_t w = 0;
    for (int k = 3; k >= 0; k--) w = w << 8 | (unsigned char)at[k];
    return w;
}
static double number(const char *at) {
    const uint32_t w = word(at);
    float f;
    memcpy(&f, &w, sizeof f);
    return (double)f;
}

static void a_curve_as_a_line(void **state) {
    (void)state;
    bat_model m = {.curve_count = 0};
    bat_problem problem;
    const char *text =
        "{\"degree\":2,\"knots\":[0,0,0,1,1,1],\"points\":[[-1,1],[0,-1],[1,1]]}"; /* y = x * x */
    char *bytes;
    size_t size;
    assert_int_equal(bat_model_read(text, strlen(text), &m, &problem), BAT_OK);
    for (double tolerance = 0.1; tolerance > 1e-5; tolerance /= 7) {
        assert_int_equal(bat_gltf_write(&m, tolerance, &bytes, &size), BAT_OK);
        assert_true(word(bytes) == 0x46546C67 && word(bytes + 8) == size);
        const char *numbers = bytes + 20 + word(bytes + 12) + 8;
        const size_t count = word(numbers - 8) / 12;
        for (size_t i = 0; i < count; i++) {
            const double x = number(numbers + 12 * i), y = number(numbers + 12 * i + 4);
            assert_true(fabs(y - x * x) < 1e-6);
            if (i == 0) continue;
            const double before = number(numbers + 12 * (i - 1));
            assert_true((x - before) * (x - before) / 4 <= 1.01 * tolerance);
            assert_true((x - before) * (x - before) / 4 > 0.2 * tolerance);
        }
        bat_free(bytes);
    }
    bat_model_clear(&m);
}

/* ---- failing allocations ---- */

static const char FILE_OBJ[] =
    "o a\nv 0 0 0\nv 4 0 0\nv 4 4 1\nv 3 1 0\nf 1 2 3 4\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 2\ncstype "
    "bspline\ndeg 1 1\n"
    "surf 0 1 0 1 5 6 7 8\nparm u 0 0 1 1\nparm v 0 0 1 1\nend\no b\nsurf 0 1 0 1 8 6 7 5\nparm u 0 0 1 1\n"
    "parm v 0 0 1 1\nend\ncurv 0 1 5 6\nparm u 0 0 1 1\nend\ncurv 0.5 1 5 6\nparm u 0 0 1 1\nend\n";
static bat_model whole;
static char *json;
static size_t json_size;

static bat_status from_obj(bat_model *m, char **bytes) {
    return (void)bytes, bat_obj_read(FILE_OBJ, sizeof FILE_OBJ - 1, m, NULL);
}
static bat_status from_json(bat_model *m, char **bytes) {
    return (void)bytes, bat_model_read(json, json_size, m, NULL);
}
static bat_status to_obj(bat_model *m, char **bytes) {
    size_t size;
    return (void)m, bat_obj_write(&whole, bytes, &size);
}
static bat_status to_json(bat_model *m, char **bytes) {
    size_t size;
    return (void)m, bat_model_write(&whole, bytes, &size);
}
static bat_status to_stl(bat_model *m, char **bytes) {
    size_t size;
    return (void)m, bat_stl_write(&whole, 0.1, bytes, &size);
}
static bat_status to_gltf(bat_model *m, char **bytes) {
    size_t size;
    return (void)m, bat_gltf_write(&whole, 0.1, bytes, &size);
}

static void each_allocation(void **state) {
    (void)state;
    static bat_status (*const operations[])(bat_model *, char **) = {from_obj, from_json, to_obj,
                                                                     to_json,  to_stl,    to_gltf};
    whole = read_obj(FILE_OBJ);
    assert_true(whole.mesh && whole.surface_count == 2 && whole.curve_count == 2);
    assert_int_equal(bat_model_write(&whole, &json, &json_size), BAT_OK);
    for (size_t i = 0; i < sizeof operations / sizeof *operations; i++) {
        const long before = alloc_live();
        for (long n = 1;; n++) {
            bat_model model = {.mesh = NULL};
            char *bytes = NULL;
            alloc_fail_at(n);
            const bat_status status = operations[i](&model, &bytes);
            const bool reached = alloc_fail_reached();
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            if (reached) assert_true(!model.mesh && model.surface_count + model.curve_count == 0 && !bytes);
            bat_model_clear(&model);
            bat_free(bytes);
            assert_int_equal(alloc_live(), before);
            if (!reached) break;
        }
    }
    bat_free(json);
    bat_model_clear(&whole);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(there_and_back), cmocka_unit_test(from_others),
                                       cmocka_unit_test(what_cannot_be_written),
                                       cmocka_unit_test(a_curve_as_a_line),
                                       cmocka_unit_test(each_allocation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
