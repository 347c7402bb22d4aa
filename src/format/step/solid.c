/* A closed B-spline surface as a solid: one face, whose boundary is its seams, there and back (ISO 10303-42). */
#include "form/relief/relief.h"
#include "format/step/put.h"

#include <batten/surface.h>

static const double POINT = 1e-9; /* of the size: control points at a pole */

static bool ends_in_points(const bat_surface *surface, bat_direction direction) {
    double low[3], high[3], size = 0;
    bat_surface_box(surface, low, high);
    for (int k = 0; k < 3; k++) size = high[k] - low[k] > size ? high[k] - low[k] : size;
    const int edge = direction == BAT_U ? 0 : 2;
    return bat_edge_is_point(surface, edge, POINT * size) &&
           bat_edge_is_point(surface, edge + 1, POINT * size);
}

bool bat_step_is_solid(const bat_surface *surface) {
    const bool u = bat_surface_is_closed(surface, BAT_U), v = bat_surface_is_closed(surface, BAT_V);
    return (u && (v || ends_in_points(surface, BAT_V))) || (v && ends_in_points(surface, BAT_U));
}

/* "#id=NAME(" and what follows it. */
static void begin(bat_text *text, uint64_t id, const char *words) {
    bat_step_put_id(text, id);
    bat_text_string(text, words);
}

static uint64_t put_vertex(bat_text *text, uint64_t id, const double at[3]) {
    id = bat_step_put_point(text, id, at, 3);
    begin(text, id, "=VERTEX_POINT('',");
    bat_step_put_id(text, id - 1);
    bat_text_string(text, ");\n");
    return id + 1;
}

/* The line at the start of a closed direction, as an edge between two vertices. */
static bat_status put_seam(bat_text *text, uint64_t *id, const bat_surface *surface, bat_direction direction,
                           const uint64_t vertices[2]) {
    double domain[2];
    bat_curve *line = NULL;
    bat_surface_domain(surface, direction, domain);
    const bat_status status = bat_surface_isocurve(surface, direction, domain[0], &line);
    if (status != BAT_OK) return status;
    *id = bat_step_put_curve(text, *id, line);
    bat_curve_free(line);
    begin(text, *id, "=EDGE_CURVE('',");
    bat_step_put_id(text, vertices[0]);
    bat_text_string(text, ",");
    bat_step_put_id(text, vertices[1]);
    bat_text_string(text, ",");
    bat_step_put_id(text, *id - 1);
    bat_text_string(text, ",.T.);\n");
    ++*id;
    return BAT_OK;
}

static uint64_t put_way(bat_text *text, uint64_t id, uint64_t edge, bool there) {
    begin(text, id, "=ORIENTED_EDGE('',*,*,");
    bat_step_put_id(text, edge);
    bat_text_string(text, there ? ",.T.);\n" : ",.F.);\n");
    return id + 1;
}

/* An instance that refers to the one before it. */
static uint64_t put_around(bat_text *text, uint64_t id, const char *before, const char *after) {
    begin(text, id, before);
    bat_step_put_id(text, id - 1);
    bat_text_string(text, after);
    return id + 1;
}

/* The two ends of the line in that direction from the corner of the domain, as vertices; one where they are the same. */
static void put_ends(bat_text *text, uint64_t *id, const bat_surface *surface, bat_direction along,
                     uint64_t vertices[2]) {
    const bool closed = bat_surface_is_closed(surface, along);
    double place[2][2], at[3];
    for (bat_direction d = BAT_U; d <= BAT_V; d++) bat_surface_domain(surface, d, place[d]);
    for (int k = 0; k < 2; k++) {
        if (k == 0 || !closed) {
            bat_surface_eval(surface, place[BAT_U][along == BAT_U ? k : 0],
                             place[BAT_V][along == BAT_V ? k : 0], 0, at);
            *id = put_vertex(text, *id, at);
        }
        vertices[k] = *id - 1;
    }
}

bat_status bat_step_put_solid(bat_text *text, uint64_t *id, const bat_surface *surface) {
    const bool both = bat_surface_is_closed(surface, BAT_U) && bat_surface_is_closed(surface, BAT_V);
    const bat_direction seam = bat_surface_is_closed(surface, BAT_U) ? BAT_U : BAT_V;
    uint64_t vertices[2], edges[2], ways[4];
    *id = bat_step_put_surface(text, *id, surface);
    const uint64_t whole = *id - 1;
    put_ends(text, id, surface, seam == BAT_U ? BAT_V : BAT_U, vertices);
    bat_status status = put_seam(text, id, surface, seam, vertices);
    edges[0] = *id - 1;
    if (status == BAT_OK && both) status = put_seam(text, id, surface, BAT_V, vertices);
    edges[1] = *id - 1;
    if (status != BAT_OK) return status;
    /* Anticlockwise around the domain, as seen against the normal. */
    const int count = both ? 4 : 2;
    for (int k = 0; k < count; k++) {
        const bool there = both ? k < 2 : k == (seam == BAT_V);
        ways[k] = *id;
        *id = put_way(text, *id, edges[both ? (k + 1) % 2 : 0], there);
    }
    begin(text, *id, "=EDGE_LOOP('',(");
    for (int k = 0; k < count; k++) {
        if (k) bat_text_string(text, ",");
        bat_step_put_id(text, ways[k]);
    }
    bat_text_string(text, "));\n");
    *id = put_around(text, *id + 1, "=FACE_OUTER_BOUND('',", ",.T.);\n");
    *id = put_around(text, *id, "=ADVANCED_FACE('',(", "),");
    bat_step_put_id(text, whole);
    bat_text_string(text, ",.T.);\n");
    *id = put_around(text, *id, "=CLOSED_SHELL('',(", "));\n");
    *id = put_around(text, *id, "=MANIFOLD_SOLID_BREP('',", ");\n");
    return BAT_OK;
}
