/* batten wire: a mesh, a surface or a curve follows wires. */
#include "program.h"
#include "results.h"
#include <batten/format_space.h>
#include <batten/mesh.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The points of the target, 3 numbers each, and the edges between them. */
typedef struct net {
    size_t count, edge_count;
    double *points;
    int *edges;
} net;

static void link(net *n, size_t a, size_t b) {
    n->edges[2 * n->edge_count] = (int)a, n->edges[2 * n->edge_count++ + 1] = (int)b;
}

static bool make_room(net *n, size_t points, size_t edges) {
    *n = (net){.count = points,
               .points = malloc(3 * points * sizeof *n->points),
               .edges = malloc((2 * edges + 1) * sizeof *n->edges)};
    return n->points && n->edges;
}

static bool net_of_mesh(const bat_polymesh *mesh, net *n) {
    size_t corners = 0, count;
    for (size_t f = 0; f < bat_polymesh_face_count(mesh); f++)
        (void)bat_polymesh_face(mesh, f, &count), corners += count;
    if (!make_room(n, bat_polymesh_vertex_count(mesh), corners)) return false;
    memcpy(n->points, bat_polymesh_vertices(mesh), 3 * n->count * sizeof *n->points);
    for (size_t f = 0; f < bat_polymesh_face_count(mesh); f++) {
        const int *face = bat_polymesh_face(mesh, f, &count);
        for (size_t k = 0; k < count; k++) link(n, (size_t)face[k], (size_t)face[(k + 1) % count]);
    }
    return true;
}

static bool net_of_surface(const bat_surface *surface, net *n) {
    const size_t rows = bat_surface_count(surface, BAT_U), columns = bat_surface_count(surface, BAT_V);
    const bool closed[2] = {bat_surface_is_closed(surface, BAT_U), bat_surface_is_closed(surface, BAT_V)};
    if (!make_room(n, rows * columns, 2 * rows * columns)) return false;
    for (size_t i = 0; i < rows; i++) {
        memcpy(n->points + 3 * i * columns, bat_surface_row(surface, (int)i),
               3 * columns * sizeof *n->points);
        for (size_t j = 0; j < columns; j++) {
            const size_t at = i * columns + j;
            if (i + 1 < rows || closed[0]) link(n, at, (i + 1) % rows * columns + j);
            if (j + 1 < columns || closed[1]) link(n, at, i * columns + (j + 1) % columns);
        }
    }
    return true;
}

static bool net_of_curve(const bat_curve *curve, net *n) {
    const size_t count = bat_curve_count(curve), size = (size_t)bat_curve_dimension(curve);
    if (!make_room(n, count, count)) return false;
    for (size_t i = 0; i < count; i++) {
        n->points[3 * i + 2] = 0;
        memcpy(n->points + 3 * i, bat_curve_points(curve) + i * size, size * sizeof *n->points);
        if (i + 1 < count || bat_curve_is_closed(curve)) link(n, i, (i + 1) % count);
    }
    return true;
}

/* ---- the target with its points moved ---- */

static bat_status surface_with(const bat_surface *surface, const double *points, bat_surface **out) {
    int degree[2], knot_count[2];
    bool closed[2];
    size_t count[2];
    for (bat_direction d = BAT_U; d <= BAT_V; d++) {
        degree[d] = bat_surface_degree(surface, d), knot_count[d] = bat_surface_knot_count(surface, d);
        closed[d] = bat_surface_is_closed(surface, d), count[d] = bat_surface_count(surface, d);
    }
    return bat_surface_create(degree, closed, count, points, knot_count, bat_surface_knots(surface, BAT_U),
                              bat_surface_knots(surface, BAT_V), out);
}

/* A planar curve stays one while no point leaves its plane. */
static bat_status curve_with(const bat_curve *curve, double *points, bat_curve **out) {
    const size_t count = bat_curve_count(curve);
    int size = bat_curve_dimension(curve);
    for (size_t i = 0; i < count; i++)
        if (points[3 * i + 2] != 0) size = 3;
    for (size_t i = 0; i < count && size == 2; i++)
        memmove(points + 2 * i, points + 3 * i, 2 * sizeof *points);
    return bat_curve_create(size, bat_curve_degree(curve), bat_curve_is_closed(curve), count, points,
                            bat_curve_knot_count(curve), bat_curve_knots(curve), out);
}

static int write_target(const bat_model *target, net *n, bat_text *report) {
    bat_status status;
    bat_polymesh *mesh = NULL;
    bat_surface *surface = NULL;
    bat_curve *curve = NULL;
    int failed = EXIT_DONE;
    if (target->mesh)
        status = bat_polymesh_with(target->mesh, n->points, &mesh, NULL);
    else if (target->surface_count)
        status = surface_with(target->surfaces[0], n->points, &surface);
    else
        status = curve_with(target->curves[0], n->points, &curve);
    if (status != BAT_OK) bat_text_free(report);
    if (status == BAT_MEMORY) return fail_memory();
    if (status != BAT_OK)
        return fail_data("wires", NULL, "expected wires that leave a shape, found ones that do not: %s",
                         bat_status_message(status));
    failed = mesh      ? write_mesh(mesh, report)
             : surface ? write_surface(surface, report)
                       : write_curve_reported(curve, report);
    bat_polymesh_free(mesh), bat_surface_free(surface), bat_curve_free(curve);
    return failed;
}

static void put_report(bat_text *text, const net *n, const bat_wire_report *report, size_t torn) {
    bat_text_string(text, "{\"points\":");
    bat_text_integer(text, n->count);
    bat_text_string(text, ",\"moved\":");
    bat_text_integer(text, report->moved);
    bat_text_string(text, ",\"largest\":");
    bat_text_number(text, report->largest);
    bat_text_string(text, ",\"torn\":");
    bat_text_integer(text, torn);
    bat_text_string(text, "}");
}

static int fail_wires(const char *file, bat_status status, size_t wrong) {
    switch (status) {
    case BAT_MEMORY: return fail_memory();
    case BAT_PARAMETER:
        return fail_data(file, "radius", "expected one above 0 everywhere, found another at wire %zu", wrong);
    case BAT_NUMBER:
        return fail_data(file, NULL, "expected wires that move points by up to 1e75, found others");
    default: return fail_data(file, NULL, "%s", bat_status_message(status));
    }
}

/* What a person should know besides. */
static void remark_on(const char *file, const bat_wire_report *report) {
    if (report->disagreeing)
        remark("%s: %zu point%s on several wires that go apart: in the middle of where they go", file,
               report->disagreeing, report->disagreeing == 1 ? " is" : "s are");
    if (report->kinks)
        remark("%s: %zu end%s of a wire left the reference's place, tangent or curvature: there may be kinks",
               file, report->kinks, report->kinks == 1 ? "" : "s");
}

static int deform(const cli_arguments *arguments, const bat_model *target, const bat_wires_source *wires,
                  net *n) {
    const char *file = arguments->operands[1];
    bat_binding *binding = NULL;
    bat_wire_report report;
    bat_text text = {0};
    size_t torn = 0, wrong = 0;
    bat_status status = bat_wires_bind(wires->count, wires->wires, n->count, n->points, &wires->options,
                                       &binding, &wrong);
    if (status == BAT_OK) status = bat_binding_torn(binding, n->edge_count, n->edges, 0, NULL, &torn);
    if (status == BAT_OK)
        status = bat_binding_apply(binding, (const bat_curve *const *)wires->curves, n->points, &report,
                                   &wrong);
    bat_binding_free(binding);
    if (status != BAT_OK) return fail_wires(file, status, wrong);
    put_report(&text, n, &report, torn);
    int failed = write_target(target, n, &text);
    if (!failed) remark_on(file, &report);
    return failed;
}

static bat_status wires_of(const char *data, size_t size, void *out, bat_problem *problem) {
    return bat_wires_read(data, size, out, problem);
}

static int run(const cli_arguments *arguments) {
    bat_model target = {.mesh = NULL};
    bat_wires_source wires = {.count = 0};
    bat_problem problem;
    net n = {.count = 0};
    int failed = arguments_one_input(arguments, 2, "TARGET and WIRES");
    if (!failed) failed = read_model(arguments->operands[0], &target);
    if (!failed && (target.mesh != NULL) + target.surface_count + target.curve_count != 1)
        failed = fail_data(arguments->operands[0], NULL, "expected one mesh, surface or curve, found more");
    if (!failed) failed = read_data(arguments->operands[1], wires_of, &wires, &problem);
    if (!failed) {
        const bool there = target.mesh            ? net_of_mesh(target.mesh, &n)
                           : target.surface_count ? net_of_surface(target.surfaces[0], &n)
                                                  : net_of_curve(target.curves[0], &n);
        failed = there ? deform(arguments, &target, &wires, &n) : fail_memory();
    }
    free(n.points), free(n.edges);
    bat_wires_source_clear(&wires);
    bat_model_clear(&target);
    return failed;
}

const cli_command command_wire = {
    .name = "wire",
    .usage = "TARGET WIRES",
    .summary = "A mesh, a surface or a curve follows wires: curves near it that are given a new shape.",
    .details = "TARGET is a MESH, SURFACE or CURVE; vertices or control points move. WIRES names, for each "
               "wire, the "
               "reference it\nwas bound to, the curve it is now, and a radius; a scale, a curve that bounds "
               "the reach, "
               "by what it turns\n(\"turn\": \"tangent\" or \"frames\"), and how wires blend may be given. "
               "The result has a "
               "\"report\": points, how many\nmoved, by how much at most, and torn edges.",
    .example = "batten wire body.obj wires.json > shaped.json",
    .operands = 2,
    .run = run,
};
