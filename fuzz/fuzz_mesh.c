/* Any bytes as a MESH and as a model: what was read is written and reads back the same, and can be divided, converted
 * and given other vertices. */
#include <batten/bezier.h>
#include <batten/compare.h>
#include <batten/format.h>
#include <batten/mesh.h>
#include <batten/surface.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check_mesh(const bat_polymesh *mesh) {
    const size_t vertices = bat_polymesh_vertex_count(mesh), count = bat_polymesh_triangle_count(mesh);
    int *triangles = malloc((3 * count + 1) * sizeof *triangles);
    double *normals = malloc(3 * vertices * sizeof *normals), low[3], high[3];
    bat_polymesh *other = NULL, *copy = NULL;
    size_t corners = 0, wrong;
    if (!triangles || !normals || bat_polymesh_triangles(mesh, triangles) != BAT_OK) abort();
    for (size_t i = 0; i < 3 * count; i++)
        if (triangles[i] < 0 || (size_t)triangles[i] >= vertices) abort();
    for (size_t f = 0; f < bat_polymesh_face_count(mesh); f++) {
        size_t n;
        if (!bat_polymesh_face(mesh, f, &n) || n < 3) abort();
        corners += n - 2;
    }
    if (corners != count) abort();
    bat_polymesh_normals(mesh, normals);
    for (size_t i = 0; i < vertices; i++)
        if (!(fabs(hypot(hypot(normals[3 * i], normals[3 * i + 1]), normals[3 * i + 2]) - 1) < 1e-12))
            abort();
    bat_polymesh_box(mesh, low, high);
    if (!(bat_polymesh_size(mesh) >= high[0] - low[0])) abort();
    if (bat_polymesh_with(mesh, normals, &other, &wrong) != BAT_OK) abort();
    if (memcmp(bat_polymesh_vertices(other), normals, 3 * vertices * sizeof *normals) != 0) abort();
    if (bat_polymesh_copy(mesh, &copy) != BAT_OK || !bat_polymesh_is_equal(mesh, copy)) abort();
    bat_polymesh_free(other), bat_polymesh_free(copy);
    free(triangles), free(normals);
}

static void convert(const bat_model *model) {
    char *bytes[2] = {NULL, NULL};
    size_t size = 84;
    const double tolerance = 0.1 * bat_model_size(model);
    if (bat_stl_write(model, tolerance, &bytes[0], &size) == BAT_OK && size < 134) abort();
    if (bat_gltf_write(model, tolerance, &bytes[1], &size) == BAT_OK && size < 134) abort();
    bat_free(bytes[0]), bat_free(bytes[1]);
}

static bool small(const bat_model *model) {
    size_t count = 0;
    for (size_t i = 0; i < model->surface_count; i++)
        count += bat_surface_count(model->surfaces[i], BAT_U) * bat_surface_count(model->surfaces[i], BAT_V);
    for (size_t i = 0; i < model->curve_count; i++) count += bat_curve_count(model->curves[i]);
    return count < 30;
}

/* How far everything is from the mesh and the curves: at no point further than the greatest. */
static void compare(const bat_model *model) {
    bat_reference *reference = NULL;
    bat_deviation d;
    double closest[3], distance;
    const bat_polymesh *mesh = model->mesh;
    if (bat_reference_create(model->curve_count, (const bat_curve *const *)model->curves, 0, NULL,
                             mesh != NULL, &mesh, &reference) != BAT_OK)
        return;
    const double spacing = 0.3 * bat_model_size(model);
    if (mesh && bat_polymesh_deviation(mesh, reference, spacing, &d) == BAT_OK &&
        !(d.mean <= d.rms * (1 + 1e-9)))
        abort();
    for (size_t i = 0; i < model->curve_count; i++)
        if (bat_curve_deviation(model->curves[i], reference, spacing, &d) == BAT_OK && !(d.greatest >= 0))
            abort();
    for (size_t i = 0; i < model->surface_count; i++)
        if (bat_surface_deviation(model->surfaces[i], reference, spacing, &d) == BAT_OK &&
            !(bat_reference_nearest(reference, d.at, closest, &distance) == BAT_OK &&
              fabs(distance - d.greatest) <= 1e-9 * d.greatest))
            abort();
    bat_reference_free(reference);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bat_model model, again;
    bat_polymesh *mesh = NULL;
    bat_problem problem;
    char *text = NULL;
    size_t length = 0;
    if (bat_model_read((const char *)data, size, &model, &problem) != BAT_OK) return 0;
    if (bat_model_write(&model, &text, &length) != BAT_OK) abort();
    if (bat_model_read(text, length, &again, &problem) != BAT_OK) abort();
    if (model.mesh && !bat_polymesh_is_equal(model.mesh, again.mesh)) abort();
    bat_free(text);
    if (model.mesh) {
        check_mesh(model.mesh);
        if (bat_polymesh_write(model.mesh, &text, &length) != BAT_OK) abort();
        if (bat_polymesh_read(text, length, &mesh, &problem) != BAT_OK) abort();
        if (!bat_polymesh_is_equal(model.mesh, mesh)) abort();
        bat_polymesh_free(mesh), bat_free(text);
        mesh = NULL;
        const double at[3] = {0, 0, 0};
        const int three = 3, face[3] = {0, 0, (int)size};
        if (bat_polymesh_create(1, at, 1, &three, face, &mesh, &length) == BAT_OK) abort();
        if (bat_polymesh_check(1, at, 1, &three, face, &problem) == BAT_OK || !*problem.message) abort();
    }
    if (small(&model)) convert(&model), compare(&model);
    bat_model_clear(&model);
    bat_model_clear(&again);
    return 0;
}
