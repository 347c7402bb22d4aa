/* A model as triangles, lines and clouds. */
#include "format/model/model.h"
#include "base/real.h"

#include <batten/bezier.h>
#include <batten/mesh.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TRIANGLES_MOST = 1 << 24, STEPS_MOST = 1 << 20 };

void bat_parts_clear(bat_parts *parts) {
    for (size_t i = 0; i < parts->surface_count; i++) bat_tessellation_free(parts->surfaces[i]);
    for (size_t i = 0; i < parts->line_count; i++) free(parts->lines[i]);
    for (size_t i = 0; parts->blocks && i < parts->count; i++) free(parts->blocks[i]);
    free(parts->blocks);
    free(parts->surfaces);
    free(parts->lines);
    free(parts->normals);
    free(parts->triangles);
    free(parts->part);
    *parts = (bat_parts){.count = 0};
}

/* ---- the mesh ---- */

static bat_status add_mesh(const bat_polymesh *mesh, bat_parts *to) {
    const size_t count = bat_polymesh_vertex_count(mesh), triangles = bat_polymesh_triangle_count(mesh);
    bat_part *part = &to->part[to->count++];
    *part = (bat_part){.kind = BAT_PART_CLOUD, .vertex_count = count, .points = bat_polymesh_vertices(mesh)};
    if (triangles == 0) return BAT_OK;
    to->normals = malloc(3 * count * sizeof *to->normals);
    to->triangles = malloc(3 * triangles * sizeof *to->triangles);
    if (!to->normals || !to->triangles) return BAT_MEMORY;
    bat_polymesh_normals(mesh, to->normals);
    part->kind = BAT_PART_TRIANGLES, part->triangle_count = triangles;
    part->normals = to->normals, part->triangles = to->triangles;
    return bat_polymesh_triangles(mesh, to->triangles);
}

/* ---- surfaces ---- */

static bat_status add_surface(const bat_surface *surface, double tolerance, bat_parts *to) {
    bat_tessellate_options options = bat_tessellate_defaults();
    bat_tessellate_report report;
    bat_mesh mesh;
    options.tolerance = tolerance, options.triangles_max = TRIANGLES_MOST;
    bat_tessellation **made = &to->surfaces[to->surface_count];
    bat_status status = bat_surface_tessellate(surface, &options, made, &report);
    if (status != BAT_OK) return status == BAT_COUNT ? BAT_TOLERANCE : status;
    to->surface_count++;
    if (report.limited && report.max_error > tolerance) return BAT_TOLERANCE; /* rounding apart */
    bat_tessellation_mesh(*made, &mesh);
    to->part[to->count++] = (bat_part){BAT_PART_TRIANGLES,  mesh.rows * mesh.columns,
                                       mesh.triangle_count, mesh.points,
                                       mesh.normals,        mesh.triangles};
    return BAT_OK;
}

/* ---- curves ---- */

/* How many chords a Bézier segment needs: its second differences bound how far it is from a chord. */
static double chords(const double *points, int degree, int dimension, double tolerance) {
    double most = 0;
    for (int i = 0; i + 2 <= degree; i++) {
        double length = 0;
        for (int c = 0; c < dimension; c++) {
            const double *p = points + i * dimension + c;
            length = bat_hypot(length, p[0] - 2 * p[dimension] + p[2 * dimension]);
        }
        most = fmax(most, length);
    }
    return fmax(ceil(sqrt(degree * (degree - 1) / 8.0 * most / tolerance)), 1);
}

/* Fills in the line, or (at NULL) counts its points. */
static size_t walk(const bat_curve *curve, const double *points, const double *breaks, double tolerance,
                   double *at) {
    const int degree = bat_curve_degree(curve), dimension = bat_curve_dimension(curve);
    const int segments = bat_curve_segment_count(curve);
    double total = 1;
    for (int s = 0; s < segments && total < STEPS_MOST; s++) {
        const double *segment = points + s * (degree + 1) * dimension;
        const double steps = chords(segment, degree, dimension, tolerance);
        total += steps;
        for (int k = s > 0; at && k <= (int)steps; k++, at += 3) {
            const double u = breaks[s] + (breaks[s + 1] - breaks[s]) * (k / steps);
            at[2] = 0;
            bat_curve_eval(curve, s == segments - 1 && k == (int)steps ? breaks[segments] : u, 0, at);
        }
    }
    return total < STEPS_MOST ? (size_t)total : STEPS_MOST;
}

static bat_status add_curve(const bat_curve *curve, double tolerance, bat_parts *to) {
    const size_t segments = (size_t)bat_curve_segment_count(curve),
                 size = ((size_t)bat_curve_degree(curve) + 1) * (size_t)bat_curve_dimension(curve);
    double *points = malloc((segments * size + segments + 1) * sizeof *points);
    double *breaks = points ? points + segments * size : NULL;
    bat_status status = points ? bat_curve_to_bezier(curve, points, breaks) : BAT_MEMORY;
    if (status == BAT_OK) {
        const size_t count = walk(curve, points, breaks, tolerance, NULL);
        double *line = count < STEPS_MOST ? malloc(3 * count * sizeof *line) : NULL;
        if (line) {
            (void)walk(curve, points, breaks, tolerance, line);
            to->lines[to->line_count++] = line;
            to->part[to->count++] = (bat_part){.kind = BAT_PART_LINE, .vertex_count = count, .points = line};
        } else {
            status = count < STEPS_MOST ? BAT_MEMORY : BAT_TOLERANCE;
        }
    }
    free(points);
    return status;
}

bat_status bat_parts_create(const bat_model *model, double tolerance, bat_parts *out) {
    bat_parts made = {.count = 0};
    bat_status status = BAT_OK;
    if (!(tolerance >= 0 && tolerance < INFINITY)) return BAT_ARGUMENT;
    if (tolerance == 0) tolerance = 1e-4 * bat_model_size(model);
    if (tolerance == 0) tolerance = 1; /* one point */
    made.part = malloc((1 + model->surface_count + model->curve_count) * sizeof *made.part);
    made.surfaces = malloc((model->surface_count + 1) * sizeof *made.surfaces);
    made.lines = malloc((model->curve_count + 1) * sizeof *made.lines);
    if (!made.part || !made.surfaces || !made.lines) status = BAT_MEMORY;
    if (status == BAT_OK && model->mesh) status = add_mesh(model->mesh, &made);
    for (size_t i = 0; i < model->surface_count && status == BAT_OK; i++)
        status = add_surface(model->surfaces[i], tolerance, &made);
    for (size_t i = 0; i < model->curve_count && status == BAT_OK; i++)
        status = add_curve(model->curves[i], tolerance, &made);
    if (status == BAT_OK)
        *out = made;
    else
        bat_parts_clear(&made);
    return status;
}

bat_status bat_parts_write(const bat_model *model, double tolerance, bat_parts_writer *writer, char **bytes,
                           size_t *size) {
    if (!model || !bytes || !size) return BAT_ARGUMENT;
    bat_parts parts;
    bat_status status = bat_parts_create(model, tolerance, &parts);
    if (status != BAT_OK) return status;
    status = writer(&parts, bytes, size);
    bat_parts_clear(&parts);
    return status;
}
