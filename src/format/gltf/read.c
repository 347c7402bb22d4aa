/* Reads glTF 2.0: the triangles of each node's mesh, where the nodes place them. Lines, cameras, skins and motion are left out;
 * of materials and pictures nothing is read. */
#include "format/gltf/gltf.h"
#include "format/gltf/source.h"
#include "base/pose.h"

#include <batten/mesh.h>

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS, LINES_LAST = 3, TRIANGLES, STRIP, FAN };

typedef struct placed {
    size_t node;
    double matrix[12]; /* three rows of four */
} placed;

typedef struct reader {
    bat_gltf_source source;
    bat_document *out;
    int *left_out;
    uint64_t left; /* of vertices and corners */
    bat_faces faces;
    size_t depth; /* nodes that wait */
    placed *waiting;
    bool *seen; /* of each node */
} reader;

static bat_status no_memory(const reader *r) {
    return bat_problem_set(r->source.problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
}

static void leave_out(reader *r, size_t count) {
    const size_t room = (size_t)(INT_MAX - *r->left_out);
    *r->left_out += (int)(count < room ? count : room);
}

/* ---- matrices ---- */

/* A list of so many numbers; false: there is none. */
static bool read_numbers(const bat_json *json, uint32_t list, size_t count, double *out) {
    size_t k = 0;
    if (bat_json_count(json, list) != count) return false;
    for (uint32_t at = bat_json_first(json, list); at; at = json->nodes[at].next, k++) {
        if (bat_json_type_of(json, at) != BAT_JSON_NUMBER) return false;
        out[k] = json->nodes[at].value.number;
    }
    return true;
}

static void turn(const double q[4], double out[9]) {
    const double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    const double s = length > 0 && length < INFINITY ? 1 / length : 0;
    const double x = s * q[0], y = s * q[1], z = s * q[2], w = s > 0 ? s * q[3] : 1;
    const double rows[9] = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),
                            2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
                            2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y)};
    memcpy(out, rows, sizeof rows);
}

/* What a node does to what is in it: its matrix, or moved, turned and scaled. */
static bat_status read_matrix(const reader *r, size_t node, double out[12]) {
    const bat_json *json = &r->source.json;
    const uint32_t at = r->source.nodes[BAT_GLTF_NODES][node], matrix = bat_json_member(json, at, "matrix"),
                   move = bat_json_member(json, at, "translation"),
                   rotation = bat_json_member(json, at, "rotation"),
                   scale = bat_json_member(json, at, "scale");
    double all[16], to[3] = {0, 0, 0}, q[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1}, rows[9];
    if (matrix) {
        if (!read_numbers(json, matrix, 16, all))
            return bat_gltf_wrong(&r->source, BAT_GLTF_NODES, node, BAT_SYNTAX,
                                  "matrix: expected 16 numbers");
        for (int i = 0; i < 12; i++) out[i] = all[i / 4 + i % 4 * 4];
        return BAT_OK;
    }
    if ((move && !read_numbers(json, move, 3, to)) || (rotation && !read_numbers(json, rotation, 4, q)) ||
        (scale && !read_numbers(json, scale, 3, s)))
        return bat_gltf_wrong(&r->source, BAT_GLTF_NODES, node, BAT_SYNTAX,
                              "expected 3, 4 and 3 numbers as translation, rotation and scale");
    turn(q, rows);
    for (int i = 0; i < 12; i++) out[i] = i % 4 == 3 ? to[i / 4] : rows[i / 4 * 3 + i % 4] * s[i % 4];
    return BAT_OK;
}

/* ---- a primitive ---- */

/* What is read of one: places, and the vertices in the order in which they are used. */
typedef struct primitive {
    size_t mesh, place_count, corner_count;
    uint64_t mode;
    double *places, *corners; /* corners NULL: each once */
    int *vertex;              /* of each place: its number in the mesh, or -1 */
} primitive;

static bat_status add_vertex(reader *r, const primitive *p, const double m[12], size_t corner, int *out) {
    const double index = p->corners ? p->corners[corner] : (double)corner;
    if (!(index >= 0 && index < (double)p->place_count && index == floor(index)))
        return bat_gltf_wrong(&r->source, BAT_GLTF_MESHES, p->mesh, BAT_PARAMETER,
                              "indices: expected the number of a vertex, found none such");
    int *vertex = &p->vertex[(size_t)index];
    if (*vertex < 0) {
        const double *at = p->places + 3 * (size_t)index;
        double moved[3];
        bat_pose_apply(m, 1, at, moved);
        *vertex = (int)r->faces.vertex_count;
        const bat_status status = bat_faces_add_vertex(&r->faces, moved);
        if (status != BAT_OK)
            return bat_gltf_wrong(&r->source, BAT_GLTF_MESHES, p->mesh, status,
                                  status == BAT_NUMBER  ? "expected finite places, found another"
                                  : status == BAT_COUNT ? "expected 16777216 vertices at most, found more"
                                                        : bat_status_message(status));
    }
    *out = *vertex;
    return BAT_OK;
}

/* The corners of triangle t: anticlockwise on its outer side. */
static void corners_of(uint64_t mode, size_t t, bool mirrored, size_t out[3]) {
    const size_t odd = t % 2;
    out[0] = mode == TRIANGLES ? 3 * t : mode == STRIP ? t : 0;
    out[1] = mode == TRIANGLES ? 3 * t + 1 : mode == STRIP ? t + 1 + odd : t + 1;
    out[2] = mode == TRIANGLES ? 3 * t + 2 : mode == STRIP ? t + 2 - odd : t + 2;
    if (!mirrored) return;
    const size_t kept = out[1];
    out[1] = out[2], out[2] = kept;
}

static bat_status add_all(reader *r, const primitive *p, const double m[12]) {
    const size_t count = p->corners ? p->corner_count : p->place_count;
    const bool mirrored = bat_pose_mirrors(m);
    bat_status status = BAT_OK;
    if (p->mode == POINTS) {
        int vertex;
        for (size_t i = 0; i < count && status == BAT_OK; i++) status = add_vertex(r, p, m, i, &vertex);
        return status;
    }
    const size_t triangles = p->mode == TRIANGLES ? count / 3 : count < 3 ? 0 : count - 2;
    for (size_t t = 0; t < triangles && status == BAT_OK; t++) {
        size_t at[3];
        int face[3];
        corners_of(p->mode, t, mirrored, at);
        for (int k = 0; k < 3 && status == BAT_OK; k++) status = add_vertex(r, p, m, at[k], &face[k]);
        if (status != BAT_OK) return status;
        status = bat_faces_add(&r->faces, face, 3);
        if (status != BAT_OK)
            bat_gltf_wrong(&r->source, BAT_GLTF_MESHES, p->mesh, status, bat_status_message(status));
    }
    return status;
}

static bat_status read_primitive(reader *r, size_t mesh, uint32_t node, const double m[12]) {
    const bat_json *json = &r->source.json;
    primitive p = {.mesh = mesh};
    size_t places, indices;
    const uint32_t listed = bat_json_member(json, node, "indices"),
                   position = bat_json_member(json, bat_json_member(json, node, "attributes"), "POSITION");
    if (!bat_gltf_whole(json, bat_json_member(json, node, "mode"), FAN, TRIANGLES, &p.mode) ||
        (position && !bat_gltf_index(&r->source, position, BAT_GLTF_ACCESSORS, &places)) ||
        (listed && !bat_gltf_index(&r->source, listed, BAT_GLTF_ACCESSORS, &indices)))
        return bat_gltf_wrong(&r->source, BAT_GLTF_MESHES, mesh, BAT_SYNTAX,
                              "expected a mode, POSITION and indices that there are, found others");
    if (!position || (p.mode > POINTS && p.mode <= LINES_LAST)) {
        leave_out(r, 1);
        return BAT_OK;
    }
    bat_status status = bat_gltf_numbers(&r->source, places, 3, &r->left, &p.place_count, &p.places);
    if (status == BAT_OK && listed)
        status = bat_gltf_numbers(&r->source, indices, 1, &r->left, &p.corner_count, &p.corners);
    if (status == BAT_OK) {
        p.vertex = malloc((p.place_count + 1) * sizeof *p.vertex);
        for (size_t i = 0; p.vertex && i < p.place_count; i++) p.vertex[i] = -1;
        status = p.vertex ? add_all(r, &p, m) : no_memory(r);
    }
    free(p.places);
    free(p.corners);
    free(p.vertex);
    return status;
}

/* ---- nodes ---- */

static bat_status insert(reader *r, size_t node, size_t mesh) {
    static const bat_room metres = {BAT_STAND_WALL, 1000, true};
    const bat_json *json = &r->source.json;
    const char *name = bat_json_text(json,
                                     bat_json_member(json, r->source.nodes[BAT_GLTF_NODES][node], "name"));
    if (!name || !*name)
        name = bat_json_text(json, bat_json_member(json, r->source.nodes[BAT_GLTF_MESHES][mesh], "name"));
    const bool faces = r->faces.face_count > 0;
    bat_status status = bat_faces_weld(&r->faces);
    if (status == BAT_OK && (r->faces.vertex_count == 0 || (faces && r->faces.face_count == 0)))
        return BAT_OK;
    if (status == BAT_OK) status = bat_faces_insert(&r->faces, &metres, name ? name : "", r->out);
    if (status == BAT_OK) return status;
    return bat_gltf_wrong(&r->source, BAT_GLTF_NODES, node, status, bat_status_message(status));
}

static bat_status read_mesh(reader *r, size_t node, const double m[12]) {
    const bat_json *json = &r->source.json;
    const uint32_t at = r->source.nodes[BAT_GLTF_NODES][node], named = bat_json_member(json, at, "mesh");
    size_t mesh;
    bat_status status = BAT_OK;
    if (!named) return BAT_OK;
    if (!bat_gltf_index(&r->source, named, BAT_GLTF_MESHES, &mesh))
        return bat_gltf_wrong(&r->source, BAT_GLTF_NODES, node, BAT_PARAMETER,
                              "mesh: expected one that there is, found none such");
    if (bat_json_member(json, at, "skin")) leave_out(r, 1);
    bat_faces_empty(&r->faces);
    const uint32_t list = bat_json_member(json, r->source.nodes[BAT_GLTF_MESHES][mesh], "primitives");
    for (uint32_t each = bat_json_first(json, list); each && status == BAT_OK; each = json->nodes[each].next)
        status = read_primitive(r, mesh, each, m);
    return status == BAT_OK ? insert(r, node, mesh) : status;
}

/* Puts the nodes of a list, the first on top, where `matrix` places them. */
static bat_status wait(reader *r, uint32_t list, const double matrix[12]) {
    const bat_json *json = &r->source.json;
    const size_t first = r->depth;
    for (uint32_t at = bat_json_first(json, list); at; at = json->nodes[at].next) {
        size_t node;
        if (!bat_gltf_index(&r->source, at, BAT_GLTF_NODES, &node))
            return bat_problem_set(r->source.problem, BAT_PARAMETER, "nodes",
                                   "expected the number of a node, found none such");
        if (r->seen[node])
            return bat_gltf_wrong(&r->source, BAT_GLTF_NODES, node, BAT_STATE,
                                  "expected it in one node at most, found it twice or in itself");
        r->seen[node] = true;
        r->waiting[r->depth].node = node;
        memcpy(r->waiting[r->depth++].matrix, matrix, 12 * sizeof *matrix);
    }
    for (size_t a = first, b = r->depth; a + 1 < b; a++) {
        const placed kept = r->waiting[--b];
        r->waiting[b] = r->waiting[a];
        r->waiting[a] = kept;
    }
    return BAT_OK;
}

/* Without a scene: nodes that are in no other. */
static bat_status wait_for_roots(reader *r, const double matrix[12]) {
    const bat_json *json = &r->source.json;
    const size_t count = r->source.count[BAT_GLTF_NODES];
    bool *inner = calloc(count + 1, sizeof *inner);
    if (!inner) return no_memory(r);
    for (size_t i = 0; i < count; i++) {
        size_t node;
        const uint32_t list = bat_json_member(json, r->source.nodes[BAT_GLTF_NODES][i], "children");
        for (uint32_t at = bat_json_first(json, list); at; at = json->nodes[at].next)
            if (bat_gltf_index(&r->source, at, BAT_GLTF_NODES, &node)) inner[node] = true;
    }
    for (size_t i = count; i-- > 0;)
        if (!inner[i]) {
            r->seen[i] = true;
            r->waiting[r->depth].node = i;
            memcpy(r->waiting[r->depth++].matrix, matrix, 12 * sizeof *matrix);
        }
    free(inner);
    return BAT_OK;
}

static bat_status read_nodes(reader *r) {
    const bat_json *json = &r->source.json;
    const size_t count = r->source.count[BAT_GLTF_NODES];
    size_t scene = 0;
    const uint32_t chosen = bat_json_member(json, 1, "scene");
    r->waiting = malloc((count + 1) * sizeof *r->waiting);
    r->seen = calloc(count + 1, sizeof *r->seen);
    if (!r->waiting || !r->seen) return no_memory(r);
    if (chosen && !bat_gltf_index(&r->source, chosen, BAT_GLTF_SCENES, &scene))
        return bat_problem_set(r->source.problem, BAT_PARAMETER, "scene",
                               "expected a scene that there is, found none such");
    bat_status status = r->source.count[BAT_GLTF_SCENES]
                            ? wait(r, bat_json_member(json, r->source.nodes[BAT_GLTF_SCENES][scene], "nodes"),
                                   bat_pose_none)
                            : wait_for_roots(r, bat_pose_none);
    while (status == BAT_OK && r->depth > 0) {
        const placed at = r->waiting[--r->depth];
        double own[12], all[12];
        status = read_matrix(r, at.node, own);
        if (status != BAT_OK) break;
        bat_pose_multiply(at.matrix, own, all);
        status = read_mesh(r, at.node, all);
        if (status == BAT_OK)
            status = wait(r, bat_json_member(json, r->source.nodes[BAT_GLTF_NODES][at.node], "children"),
                          all);
    }
    return status;
}

bat_status bat_gltf_parse(const char *bytes, size_t size, bat_document *out, int *left_out,
                          bat_problem *problem) {
    reader r = {.out = out, .left_out = left_out};
    bat_status status = bat_gltf_open(bytes, size, &r.source, problem);
    if (status != BAT_OK) return status;
    r.left = bat_faces_bound(size);
    leave_out(&r, bat_json_count(&r.source.json, bat_json_member(&r.source.json, 1, "cameras")));
    leave_out(&r, bat_json_count(&r.source.json, bat_json_member(&r.source.json, 1, "animations")));
    status = read_nodes(&r);
    free(r.waiting);
    free(r.seen);
    bat_faces_clear(&r.faces);
    bat_gltf_close(&r.source);
    if (status == BAT_OK && bat_document_count(out) == 0)
        return bat_problem_set(problem, BAT_COUNT, "",
                               "expected a mesh of triangles or points in a node, found none");
    return status;
}
