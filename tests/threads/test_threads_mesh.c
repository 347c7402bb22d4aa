/* The promise of base.h about threads: concurrent const calls on one mesh, one binding of wires. */
#include "alike.h"

static uint64_t look_at_mesh(const void *shared, int seed) {
    const bat_polymesh *m = shared;
    const size_t count = bat_polymesh_vertex_count(m);
    double low[3], high[3], normals[12];
    int triangles[6];
    size_t corners = 0, size = 0;
    bat_polymesh *copy = NULL, *other = NULL;
    char *text = NULL;
    bat_polymesh_box(m, low, high);
    bat_polymesh_normals(m, normals);
    uint64_t d = add_doubles(add_doubles(bat_digest_begin(), low, 3), normals, (int)(3 * count));
    d = bat_digest_double(add(d, (uint64_t)bat_polymesh_triangles(m, triangles)), bat_polymesh_size(m));
    d = add(add(d, bat_polymesh_triangle_count(m)), (uint64_t)triangles[5]);
    d = add(d, (uint64_t)bat_polymesh_face(m, (size_t)seed % bat_polymesh_face_count(m), &corners)[2]);
    d = add(add(d, corners), (uint64_t)bat_polymesh_copy(m, &copy));
    d = add(d, (uint64_t)bat_polymesh_with(m, bat_polymesh_vertices(m), &other, NULL));
    d = add(d, copy && other && bat_polymesh_is_equal(copy, other) && bat_polymesh_is_equal(m, copy));
    d = add(add(d, (uint64_t)bat_polymesh_write(m, &text, &size)), size);
    bat_free(text);
    bat_polymesh_free(copy), bat_polymesh_free(other);
    bat_reference *reference = NULL;
    bat_deviation far = {0};
    const double from[3] = {seed, 1, 5};
    double closest[3], distance = 0;
    d = add(d, (uint64_t)bat_reference_create(0, NULL, 0, NULL, 1, &m, &reference));
    d = add(d, (uint64_t)bat_reference_nearest(reference, from, closest, &distance));
    d = add(d, (uint64_t)bat_polymesh_deviation(m, reference, 0, &far));
    d = bat_digest_double(bat_digest_double(d, distance), far.greatest);
    bat_reference_free(reference);
    return d;
}
static void const_calls_on_a_mesh(void **state) {
    (void)state;
    const double at[12] = {0, 0, 0, 4, 0, 0, 4, 4, 1, 0, 4, 0};
    const int sizes[2] = {3, 3}, corners[6] = {0, 1, 2, 0, 2, 3};
    bat_polymesh *mesh = NULL;
    assert_int_equal(bat_polymesh_create(4, at, 2, sizes, corners, &mesh, NULL), BAT_OK);
    assert_alike(look_at_mesh, mesh, 2);
    bat_polymesh_free(mesh);
}

typedef struct bound {
    bat_binding *binding;
    bat_curve *curve;
} bound;
static uint64_t look_at_binding(const void *shared, int seed) {
    const bound *b = shared;
    double points[12] = {0};
    const int edges[4] = {0, 1, 1, 2 + seed % 2};
    size_t torn = 0;
    bat_wire_report report = {.moved = 0};
    uint64_t d = add(bat_digest_begin(), bat_binding_count(b->binding));
    d = add(d, (uint64_t)bat_binding_torn(b->binding, 2, edges, 0, NULL, &torn));
    d = add(d, (uint64_t)bat_binding_apply(b->binding, (const bat_curve *const *)&b->curve, points, &report,
                                           NULL));
    return add_doubles(add(add(d, torn), report.moved), points, 12);
}
static void const_calls_on_a_binding(void **state) {
    (void)state;
    const double line[6] = {0, 0, 0, 4, 0, 0}, other[6] = {0, 0, 1, 4, 1, 1};
    const double points[12] = {0, 0, 0, 1, 1, 0, 2, 0, 1, 3, 9, 9};
    bat_curve *reference = NULL;
    bound b = {NULL, NULL};
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, line, &reference), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, other, &b.curve), BAT_OK);
    const bat_wire wire = {reference, bat_function_of(2), bat_function_of(2), NULL, BAT_TURN_FRAMES};
    assert_int_equal(bat_wires_bind(1, &wire, 4, points, NULL, &b.binding, NULL), BAT_OK);
    assert_alike(look_at_binding, &b, 2);
    bat_binding_free(b.binding);
    bat_curve_free(reference), bat_curve_free(b.curve);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(const_calls_on_a_mesh),
                                       cmocka_unit_test(const_calls_on_a_binding)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
