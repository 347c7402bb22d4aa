/* The promise of base.h about threads: concurrent const calls on one mesh. */
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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(const_calls_on_a_mesh)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
