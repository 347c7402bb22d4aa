/* A surface through three rings, bent by a wire, as triangles in an STL file. Usage: vase vase.stl */
#include <batten/batten.h>

#include <stdio.h>
#include <stdlib.h>

static void must(bat_status status) {
    if (status == BAT_OK) return;
    fprintf(stderr, "%s\n", bat_status_message(status));
    exit(1);
}

static bat_curve *ring(double size, double height) {
    static const double corners[8][2] = {{2, 0},  {2, 2},   {0, 2},  {-2, 2},
                                         {-2, 0}, {-2, -2}, {0, -2}, {2, -2}};
    static const double knots[9] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    double points[24];
    for (int i = 0; i < 8; i++) {
        points[3 * i] = size * corners[i][0], points[3 * i + 1] = size * corners[i][1];
        points[3 * i + 2] = height;
    }
    bat_curve *out = NULL;
    must(bat_curve_create(3, 3, true, 8, points, 9, knots, &out));
    return out;
}

int main(int argc, char **argv) {
    const bat_curve *rings[3] = {ring(5, 0), ring(3, 10), ring(6, 20)};
    bat_curve *straight = NULL, *bent = NULL;
    bat_surface *vase = NULL, *surface = NULL;
    must(bat_surface_loft(3, rings, &vase, NULL));
    must(bat_curve_create_clamped(3, 3, 4, (double[]){0, 0, 0, 0, 0, 7, 0, 0, 13, 0, 0, 20}, &straight));
    must(bat_curve_create_clamped(3, 3, 4, (double[]){0, 0, 0, 0, 0, 7, 4, 0, 13, 8, 0, 20}, &bent));

    const size_t count[2] = {(size_t)bat_surface_count(vase, BAT_U), (size_t)bat_surface_count(vase, BAT_V)};
    double *points = malloc(count[0] * count[1] * 3 * sizeof *points);
    for (size_t i = 0; points != NULL && i < count[0]; i++)
        for (size_t k = 0; k < 3 * count[1]; k++)
            points[i * 3 * count[1] + k] = bat_surface_row(vase, (int)i)[k];

    const bat_wire wire = {.reference = straight, .radius = {.constant = 50}, .scale = {.constant = 1}};
    bat_binding *binding = NULL;
    bat_wire_report report;
    must(bat_wires_bind(1, &wire, count[0] * count[1], points, NULL, &binding, NULL));
    must(bat_binding_apply(binding, (const bat_curve *const[]){bent}, points, &report, NULL));

    const int degree[2] = {bat_surface_degree(vase, BAT_U), bat_surface_degree(vase, BAT_V)};
    const bool closed[2] = {bat_surface_is_closed(vase, BAT_U), bat_surface_is_closed(vase, BAT_V)};
    const int knots[2] = {bat_surface_knot_count(vase, BAT_U), bat_surface_knot_count(vase, BAT_V)};
    must(bat_surface_create(degree, closed, count, points, knots, bat_surface_knots(vase, BAT_U),
                            bat_surface_knots(vase, BAT_V), &surface));
    const bat_model model = {.surface_count = 1, .surfaces = &surface};
    char *bytes = NULL;
    size_t size = 0;
    must(bat_stl_write(&model, 0.05, &bytes, &size));
    FILE *file = argc > 1 ? fopen(argv[1], "wb") : NULL;
    if (file == NULL || fwrite(bytes, 1, size, file) != size || fclose(file) != 0) return 2;
    printf("%zu by %zu points, %zu moved\n", count[0], count[1], report.moved);
    return 0; /* what it holds goes with the program */
}
