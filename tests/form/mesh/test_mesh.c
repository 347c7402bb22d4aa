/* Meshes: what is kept and what is refused, JSON bit for bit, areas and senses of triangles, normals; every allocation
 * may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <stdlib.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/mesh.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { MOST = 64 };

static bat_polymesh *mesh_of(size_t vertices, const double *at, size_t faces, const int *sizes,
                             const int *corners) {
    bat_polymesh *mesh = NULL;
    assert_int_equal(bat_polymesh_create(vertices, at, faces, sizes, corners, &mesh, NULL), BAT_OK);
    return mesh;
}

static void round_trip(const bat_polymesh *mesh) {
    bat_polymesh *back = NULL, *copy = NULL;
    bat_problem problem;
    char *text;
    size_t size;
    assert_int_equal(bat_polymesh_write(mesh, &text, &size), BAT_OK);
    assert_int_equal(bat_polymesh_read(text, size, &back, &problem), BAT_OK);
    assert_int_equal(bat_polymesh_copy(mesh, &copy), BAT_OK);
    assert_true(bat_polymesh_is_equal(mesh, back) && bat_polymesh_is_equal(mesh, copy));
    bat_free(text);
    bat_polymesh_free(back);
    bat_polymesh_free(copy);
}

/* Random faces over random vertices: isolated vertices, edges with many faces, vertices used twice. */
static void everything_is_kept(void **state) {
    (void)state;
    random_source r = {11};
    for (int run = 0; run < 200; run++) {
        double at[3 * MOST];
        int sizes[MOST], corners[MOST * 7];
        const int vertices = random_int(&r, 1, MOST), faces = run % 5 ? random_int(&r, 0, MOST) : 0;
        int count = 0;
        for (int i = 0; i < 3 * vertices; i++) at[i] = random_between(&r, -1, 1) * (run % 7 ? 1 : 1e70);
        for (int f = 0; f < faces; f++) {
            sizes[f] = random_int(&r, 3, 7);
            for (int k = 0; k < sizes[f]; k++) corners[count++] = random_int(&r, 0, vertices - 1);
        }
        bat_polymesh *mesh = mesh_of((size_t)vertices, at, (size_t)faces, sizes, corners);
        round_trip(mesh);
        const int *first = corners;
        assert_int_equal(bat_polymesh_vertex_count(mesh), vertices);
        assert_int_equal(bat_polymesh_face_count(mesh), faces);
        for (int f = 0; f < faces; f++) {
            size_t n;
            const int *face = bat_polymesh_face(mesh, (size_t)f, &n);
            assert_int_equal(n, sizes[f]);
            assert_memory_equal(face, first, n * sizeof *face);
            first += n;
        }
        bat_polymesh_free(mesh);
    }
}

static void what_is_refused(void **state) {
    (void)state;
    const double at[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, bad[9] = {0, 0, 0, 1, 0, 0, 0, NAN, 0};
    const double far[9] = {0, 0, 0, 1, 2e75, 0, 0, 0, 0};
    const int three = 3, two = 2, face[3] = {0, 1, 2}, none[3] = {0, 3, 1}, below[3] = {0, 1, -1};
    bat_polymesh *mesh = NULL;
    size_t wrong = 99;
    assert_int_equal(bat_polymesh_create(3, bad, 1, &three, face, &mesh, &wrong), BAT_NUMBER);
    assert_int_equal(wrong, 2);
    assert_int_equal(bat_polymesh_create(3, far, 1, &three, face, &mesh, &wrong), BAT_NUMBER);
    assert_int_equal(wrong, 1);
    assert_int_equal(bat_polymesh_create(3, at, 1, &two, face, &mesh, &wrong), BAT_COUNT);
    assert_int_equal(wrong, 0);
    assert_int_equal(bat_polymesh_create(3, at, 1, &three, none, &mesh, NULL), BAT_PARAMETER);
    assert_int_equal(bat_polymesh_create(3, at, 1, &three, below, &mesh, NULL), BAT_PARAMETER);
    assert_int_equal(bat_polymesh_create(0, at, 0, NULL, NULL, &mesh, NULL), BAT_COUNT);
    assert_int_equal(bat_polymesh_create(BAT_VERTICES_MAX + 1, at, 0, NULL, NULL, &mesh, NULL), BAT_COUNT);
    assert_int_equal(bat_polymesh_create(3, NULL, 0, NULL, NULL, &mesh, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_polymesh_create(3, at, 1, NULL, NULL, &mesh, NULL), BAT_ARGUMENT);
    assert_null(mesh);
    mesh = mesh_of(3, at, 1, &three, face);
    bat_polymesh *other = NULL;
    assert_int_equal(bat_polymesh_with(mesh, bad, &other, &wrong), BAT_NUMBER);
    assert_int_equal(wrong, 2);
    const double moved[9] = {5, 0, 0, 1, 0, 0, 0, 1, 0};
    assert_int_equal(bat_polymesh_with(mesh, moved, &other, NULL), BAT_OK);
    assert_true(bat_polymesh_vertices(other)[0] == 5 && !bat_polymesh_is_equal(mesh, other));
    assert_true(fabs(bat_polymesh_size(other) - sqrt(26)) < 1e-15);
    bat_polymesh_free(other);
    bat_polymesh_free(mesh);
}

static void what_json_says(void **state) {
    (void)state;
    static const struct {
        const char *text, *says;
        bat_status status;
    } cases[] = {{"[]", "an object", BAT_SYNTAX},
                 {"{\"faces\":[]}", "a list of points", BAT_SYNTAX},
                 {"{\"vertices\":[[0,0,0]]}", "a list of faces", BAT_SYNTAX},
                 {"{\"vertices\":[],\"faces\":[]}", "expected 1 to", BAT_COUNT},
                 {"{\"vertices\":[[0,0,0],[1,2]],\"faces\":[]}", "as the first", BAT_DIMENSION},
                 {"{\"vertices\":[[0,0,0],[0,1e76,0]],\"faces\":[]}", "in 1", BAT_NUMBER},
                 {"{\"vertices\":[[0,0,0]],\"faces\":[[0,0]]}", "3 vertices or more", BAT_COUNT},
                 {"{\"vertices\":[[0,0,0]],\"faces\":[[0,0,1]]}", "from 0 to 0", BAT_PARAMETER},
                 {"{\"vertices\":[[0,0,0]],\"faces\":[[0,0,0.5]]}", "from 0 to 0", BAT_PARAMETER},
                 {"{\"vertices\":[[0,0,0]],\"faces\":[[0,0,null]]}", "from 0 to 0", BAT_PARAMETER}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_polymesh *mesh = NULL;
        bat_problem problem = {.place = ""};
        assert_int_equal(bat_polymesh_read(cases[i].text, strlen(cases[i].text), &mesh, &problem),
                         cases[i].status);
        assert_null(mesh);
        assert_non_null(strstr(problem.message, cases[i].says));
        assert_non_null(strstr(problem.place, "line 1"));
    }
    bat_polymesh *flat = NULL;
    const char *text = "{\"vertices\":[[1,2],[3,4]],\"faces\":[]}";
    assert_int_equal(bat_polymesh_read(text, strlen(text), &flat, NULL), BAT_OK);
    const double want[6] = {1, 2, 0, 3, 4, 0};
    assert_memory_equal(bat_polymesh_vertices(flat), want, sizeof want);
    bat_polymesh_free(flat);
}

/* ---- triangles ---- */

static void cross(const double *a, const double *b, const double *c, double *out) {
    for (int k = 0; k < 3; k++) {
        const int x = (k + 1) % 3, y = (k + 2) % 3;
        out[k] = (b[x] - a[x]) * (c[y] - a[y]) - (b[y] - a[y]) * (c[x] - a[x]);
    }
}

/* A star-shaped outline in a tilted plane: its triangles all face its way, and their areas add up to its area. */
static void triangles_cover_a_face(void **state) {
    (void)state;
    random_source r = {5};
    for (int run = 0; run < 300; run++) {
        double at[3 * MOST], area = 0, sum = 0, normal[3];
        int corners[MOST], triangles[3 * MOST];
        const int n = random_int(&r, 3, MOST), tilt = run % 3;
        const bool convex = run % 4 == 0;
        for (int k = 0; k < n; k++) {
            const double angle = 6.283185307179586 * k / n, far = convex ? 2 : random_between(&r, 0.1, 2);
            const double x = far * cos(angle), y = far * sin(angle);
            at[3 * k + tilt] = x, at[3 * k + (tilt + 1) % 3] = y;
            at[3 * k + (tilt + 2) % 3] = 0.3 * x - 0.8 * y;
            corners[k] = run % 2 ? k : n - 1 - k;
        }
        for (int k = 0; k < n; k++) {
            const double origin[3] = {0, 0, 0};
            cross(origin, at + 3 * corners[k], at + 3 * corners[(k + 1) % n], normal);
            area += sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        }
        bat_polymesh *mesh = mesh_of((size_t)n, at, 1, &n, corners);
        assert_int_equal(bat_polymesh_triangle_count(mesh), n - 2);
        assert_int_equal(bat_polymesh_triangles(mesh, triangles), BAT_OK);
        for (int t = 0; t < n - 2; t++) {
            const int *v = triangles + 3 * t;
            cross(at + 3 * v[0], at + 3 * v[1], at + 3 * v[2], normal);
            const double up = normal[(tilt + 2) % 3];
            assert_true(run % 2 ? up >= -1e-12 : up <= 1e-12);
            sum += sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        }
        assert_true(fabs(sum - area) < 1e-12 * area);
        bat_polymesh_free(mesh);
    }
}

/* Faces that cross themselves or have no area give as many triangles, with the face's vertices. */
static void any_face_can_be_divided(void **state) {
    (void)state;
    random_source r = {6};
    for (int run = 0; run < 300; run++) {
        double at[3 * MOST];
        int corners[MOST], triangles[3 * MOST];
        const int vertices = random_int(&r, 1, 9), n = random_int(&r, 3, MOST);
        for (int k = 0; k < 3 * vertices; k++) at[k] = random_int(&r, -2, 2);
        for (int k = 0; k < n; k++) corners[k] = random_int(&r, 0, vertices - 1);
        bat_polymesh *mesh = mesh_of((size_t)vertices, at, 1, &n, corners);
        assert_int_equal(bat_polymesh_triangles(mesh, triangles), BAT_OK);
        for (int k = 0; k < 3 * (n - 2); k++) assert_true(triangles[k] >= 0 && triangles[k] < vertices);
        bat_polymesh_free(mesh);
    }
}

/* A cube: each normal points out along the diagonal, also where areas are below what a double holds in full; an isolated vertex
 * has one, too. */
static void normals(void **state) {
    (void)state;
    static const double lengths[] = {1, 1e-150, 1e-158, 1e9};
    double at[27], out[27];
    const int sizes[6] = {4, 4, 4, 4, 4, 4},
              corners[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    at[24] = at[25] = at[26] = 7;
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        for (int k = 0; k < 24; k++) at[k] = (k / 3 >> k % 3 & 1) * lengths[i];
        bat_polymesh *mesh = mesh_of(9, at, 6, sizes, corners);
        bat_polymesh_normals(mesh, out);
        for (int k = 0; k < 24; k++)
            assert_true(fabs(out[k] - (at[k] > 0 ? 1 : -1) / sqrt(3)) < (i == 2 ? 1e-6 : 1e-15));
        for (int k = 0; k < 8; k++)
            assert_true(fabs(hypot(hypot(out[3 * k], out[3 * k + 1]), out[3 * k + 2]) - 1) < 1e-15);
        assert_true(out[24] == 0 && out[25] == 0 && out[26] == 1);
        bat_polymesh_free(mesh);
    }
}

/* ---- failing allocations ---- */

static bat_polymesh *square;
static const char *const SQUARE = "{\"vertices\":[[0,0],[4,0],[4,4],[3,1]],\"faces\":[[0,1,2,3]]}";

static bat_status copy(bat_polymesh **mesh, char **text) {
    return (void)text, bat_polymesh_copy(square, mesh);
}
static bat_status with(bat_polymesh **mesh, char **text) {
    return (void)text, bat_polymesh_with(square, bat_polymesh_vertices(square), mesh, NULL);
}
static bat_status divide(bat_polymesh **mesh, char **text) {
    int out[6];
    return (void)text, (void)mesh, bat_polymesh_triangles(square, out);
}
static bat_status read_text(bat_polymesh **mesh, char **text) {
    return (void)text, bat_polymesh_read(SQUARE, strlen(SQUARE), mesh, NULL);
}
static bat_status write_text(bat_polymesh **mesh, char **text) {
    size_t size;
    return (void)mesh, bat_polymesh_write(square, text, &size);
}

static void each_allocation(void **state) {
    (void)state;
    static bat_status (*const operations[])(bat_polymesh **, char **) = {copy, with, divide, read_text,
                                                                         write_text};
    assert_int_equal(bat_polymesh_read(SQUARE, strlen(SQUARE), &square, NULL), BAT_OK);
    for (size_t i = 0; i < sizeof operations / sizeof *operations; i++) {
        const long before = alloc_live();
        for (long n = 1;; n++) {
            bat_polymesh *mesh = NULL;
            char *text = NULL;
            alloc_fail_at(n);
            const bat_status status = operations[i](&mesh, &text);
            const bool reached = alloc_fail_reached();
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            if (reached) assert_true(!mesh && !text);
            bat_polymesh_free(mesh);
            bat_free(text);
            assert_int_equal(alloc_live(), before);
            if (!reached) break;
        }
    }
    bat_polymesh_free(square);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything_is_kept),      cmocka_unit_test(what_is_refused),
        cmocka_unit_test(what_json_says),          cmocka_unit_test(triangles_cover_a_face),
        cmocka_unit_test(any_face_can_be_divided), cmocka_unit_test(normals),
        cmocka_unit_test(each_allocation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
