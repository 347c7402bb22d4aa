/* Writes OBJ. Closed directions get as many points and knots more as their degree, before the first. */
#include "format/model/full.h"
#include "format/obj/obj.h"
#include <batten/mesh.h>

enum { ROW = 10 };

/* Writes a blank and the number; the line is broken after every `row` numbers. */
static void put(bat_text *text, uint64_t i, int row, double number) {
    bat_text_string(text, i && i % (uint64_t)row == 0 ? " \\\n " : " ");
    bat_text_number(text, number);
}

static void put_knots(bat_text *text, const char *name, const bat_full_axis *a) {
    bat_text_string(text, name);
    for (int i = 0; i < a->count + a->degree + 1; i++) put(text, (uint64_t)i + 1, ROW, bat_full_knot(a, i));
    bat_text_string(text, "\n");
}

double bat_obj_turned(const double *way, int row, const double point[3]) {
    for (int c = 0; c < 3; c++)
        if (way[3 * row + c] != 0) return way[3 * row + c] < 0 ? -point[c] : point[c];
    return 0;
}

static void put_vertex(bat_text *text, const double *point, int size, const double *way) {
    const double whole[3] = {point[0], point[1], size == 3 ? point[2] : 0};
    bat_text_string(text, "v");
    for (int d = 0; d < 3; d++) put(text, 0, ROW, way ? bat_obj_turned(way, d, whole) : whole[d]);
    bat_text_string(text, "\n");
}

uint64_t bat_obj_put_curve(bat_text *text, const bat_curve *curve, const double *way, uint64_t vertices) {
    const int size = bat_curve_dimension(curve);
    const bat_full_axis a = bat_full_axis_of_curve(curve);
    double domain[2];
    bat_curve_domain(curve, domain);
    for (int i = 0; i < a.count; i++)
        put_vertex(text, bat_curve_points(curve) + bat_full_point(&a, i) * size, size, way);
    bat_text_string(text, "cstype bspline\ndeg ");
    bat_text_integer(text, (uint64_t)a.degree);
    bat_text_string(text, "\ncurv");
    for (int i = 0; i < 2; i++) put(text, 0, ROW, domain[i]);
    for (int i = 0; i < a.count; i++) put(text, (uint64_t)i + 2, ROW, (double)(vertices + (uint64_t)i + 1));
    bat_text_string(text, "\n");
    put_knots(text, "parm u", &a);
    bat_text_string(text, "end\n");
    return vertices + (uint64_t)a.count;
}

uint64_t bat_obj_put_surface(bat_text *text, const bat_surface *surface, const double *way,
                             uint64_t vertices) {
    bat_full_axis a[2];
    uint64_t count = 0;
    for (bat_direction d = BAT_U; d <= BAT_V; d++) a[d] = bat_full_axis_of_surface(surface, d);
    for (int j = 0; j < a[1].count; j++)
        for (int i = 0; i < a[0].count; i++, count++)
            put_vertex(text,
                       bat_surface_row(surface, bat_full_point(&a[0], i)) + 3 * bat_full_point(&a[1], j), 3,
                       way);
    bat_text_string(text, "cstype bspline\ndeg ");
    bat_text_integer(text, (uint64_t)a[0].degree);
    bat_text_string(text, " ");
    bat_text_integer(text, (uint64_t)a[1].degree);
    bat_text_string(text, "\nsurf");
    for (bat_direction d = BAT_U; d <= BAT_V; d++) {
        double domain[2];
        bat_surface_domain(surface, d, domain);
        for (int k = 0; k < 2; k++) put(text, 0, ROW, domain[k]);
    }
    for (uint64_t i = 0; i < count; i++) put(text, i + 4, ROW, (double)(vertices + i + 1));
    bat_text_string(text, "\n");
    put_knots(text, "parm u", &a[0]);
    put_knots(text, "parm v", &a[1]);
    bat_text_string(text, "end\n");
    return vertices + count;
}

uint64_t bat_obj_put_mesh(bat_text *text, const bat_polymesh *mesh, const double *way, uint64_t vertices) {
    const size_t count = bat_polymesh_vertex_count(mesh), faces = bat_polymesh_face_count(mesh);
    for (size_t i = 0; i < count; i++) put_vertex(text, bat_polymesh_vertices(mesh) + 3 * i, 3, way);
    if (faces == 0) { /* a cloud: also beside curves */
        bat_text_string(text, "p");
        for (size_t i = 0; i < count; i++) put(text, i, ROW, (double)(vertices + i + 1));
        bat_text_string(text, "\n");
    }
    for (size_t f = 0; f < faces; f++) {
        size_t size;
        const int *corners = bat_polymesh_face(mesh, f, &size);
        bat_text_string(text, "f");
        for (size_t k = 0; k < size; k++) put(text, k, 2 * ROW, (double)vertices + corners[k] + 1);
        bat_text_string(text, "\n");
    }
    return vertices + count;
}

bat_status bat_obj_write(const bat_model *model, char **out, size_t *size) {
    if (!model || !out || !size) return BAT_ARGUMENT;
    bat_text text = {0};
    uint64_t vertices = model->mesh ? bat_obj_put_mesh(&text, model->mesh, NULL, 0) : 0;
    for (size_t i = 0; i < model->surface_count; i++)
        vertices = bat_obj_put_surface(&text, model->surfaces[i], NULL, vertices);
    for (size_t i = 0; i < model->curve_count; i++)
        vertices = bat_obj_put_curve(&text, model->curves[i], NULL, vertices);
    if (vertices > 0) return bat_text_finish(&text, out, size);
    bat_text_free(&text);
    return BAT_COUNT;
}
