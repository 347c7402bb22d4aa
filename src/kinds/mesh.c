/* A polygon mesh in space. Its curves are strips of its edges (form/mesh/strips.h): they show it, and change only with it. Its
 * vertices can be bound to wires. */
#include "base/users.h"
#include "document/bound.h"
#include "document/digest.h"
#include "form/mesh/mesh.h"
#include "form/mesh/strips.h"
#include "format/json/bound.h"
#include "format/json/fields.h"
#include "format/json/mesh.h"
#include "format/json/style.h"
#include "kinds/kinds.h"
#include "text/text.h"

#include <stdlib.h>
#include <string.h>

enum { DOTS = 64 /* crosses that show a mesh without edges */ };
static const double DOT = 0.01; /* their size, of the mesh's */

/* What stays the same while vertices move. */
typedef struct kept_edges {
    bat_users users;
    bat_strips strips;
    uint64_t digest; /* of the faces */
} kept_edges;

typedef struct kept_mesh {
    bat_users users;
    bat_polymesh *mesh;
    kept_edges *edges;
    uint64_t digest; /* of the vertices and edges' */
} kept_mesh;

typedef struct own_part {
    kept_mesh *kept;
    bat_hold hold;
} own_part;

static const own_part *part_of(const void *own) { return own; }

static void release_edges(kept_edges *edges) {
    if (!edges || !bat_users_drop(&edges->users)) return;
    bat_strips_clear(&edges->strips);
    free(edges);
}

static void release(kept_mesh *kept) {
    if (!kept || !bat_users_drop(&kept->users)) return;
    bat_polymesh_free(kept->mesh);
    release_edges(kept->edges);
    free(kept);
}

static void share(const void *own) {
    bat_users_add(&part_of(own)->kept->users);
    if (part_of(own)->hold.bound) bat_bound_retain(part_of(own)->hold.bound);
}
static void end(void *own) {
    release(part_of(own)->kept);
    bat_bound_release(part_of(own)->hold.bound);
}

/* ---- lines ---- */

static bat_status polyline(size_t count, const double *points, bat_curve **out) {
    double *knots = malloc((count + 2) * sizeof *knots);
    if (!knots) return BAT_MEMORY;
    for (size_t i = 0; i < count; i++) knots[i + 1] = (double)i;
    knots[0] = 0, knots[count + 1] = (double)(count - 1);
    const bat_status status = bat_curve_create(3, 1, false, count, points, (int)count + 2, knots, out);
    free(knots);
    return status;
}

static bat_status strip_line(const bat_polymesh *mesh, const int *vertices, size_t count, bat_curve **out) {
    double *points = malloc(3 * count * sizeof *points);
    if (!points) return BAT_MEMORY;
    for (size_t i = 0; i < count; i++)
        memcpy(points + 3 * i, bat_polymesh_vertices(mesh) + 3 * (size_t)vertices[i], 3 * sizeof *points);
    const bat_status status = polyline(count, points, out);
    free(points);
    return status;
}

/* A mesh without edges shows some of its vertices as crosses; a cross is one line, there and back along each axis. */
static bat_status dot(const bat_polymesh *mesh, size_t vertex, bat_curve **out) {
    const double *at = bat_polymesh_vertices(mesh) + 3 * vertex;
    const double size = bat_polymesh_size(mesh), arm = size > 0 ? DOT * size : 1;
    double points[21];
    for (int i = 0; i < 7; i++) {
        memcpy(points + (ptrdiff_t)3 * i, at, 3 * sizeof *at);
        if (i % 2) points[3 * i + i / 2] += arm;
    }
    return polyline(7, points, out);
}

static int line_count(const bat_polymesh *mesh, const bat_strips *strips) {
    const size_t vertices = bat_polymesh_vertex_count(mesh);
    if (strips->count) return strips->count;
    return vertices < DOTS ? (int)vertices : DOTS;
}

static bat_status line(const bat_polymesh *mesh, const bat_strips *strips, int i, bat_curve **out) {
    if (!strips->count) {
        const size_t count = (size_t)line_count(mesh, strips);
        return dot(mesh, (size_t)i * bat_polymesh_vertex_count(mesh) / count, out);
    }
    const int first = strips->starts[i];
    return strip_line(mesh, strips->vertices + first, (size_t)(strips->starts[i + 1] - first), out);
}

/* ---- making ---- */

static uint64_t digest_faces(const bat_polymesh *mesh) {
    uint64_t digest = bat_digest_number(bat_digest_begin(), bat_polymesh_face_count(mesh));
    for (size_t f = 0; f < bat_polymesh_face_count(mesh); f++) {
        size_t count;
        const int *face = bat_polymesh_face(mesh, f, &count);
        digest = bat_digest_number(digest, count);
        for (size_t k = 0; k < count; k++) digest = bat_digest_number(digest, (uint64_t)face[k]);
    }
    return digest;
}

static bat_status find_edges(const bat_polymesh *mesh, kept_edges **out) {
    kept_edges *edges = calloc(1, sizeof *edges);
    if (!edges) return BAT_MEMORY;
    *edges = (kept_edges){.users = BAT_USERS_ONE, .digest = digest_faces(mesh)};
    const bat_status status = bat_polymesh_strips(mesh, &edges->strips);
    if (status == BAT_OK)
        *out = edges;
    else
        release_edges(edges);
    return status;
}

static bat_status make_object(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                              const own_part *own, bat_object **out) {
    const bat_strips *strips = &own->kept->edges->strips;
    const int count = line_count(own->kept->mesh, strips);
    bat_curve *curves[BAT_STRIPS_MAX];
    bat_status status = BAT_OK;
    int made = 0;
    while (made < count && status == BAT_OK) {
        status = line(own->kept->mesh, strips, made, &curves[made]);
        made += status == BAT_OK;
    }
    if (status == BAT_OK)
        status = object ? bat_object_remake(object, &bat_kind_of_mesh, own, count, curves, out)
                        : bat_object_make(&bat_kind_of_mesh, id, name, style, own, count, curves, out);
    while (status != BAT_OK && made > 0) bat_curve_free(curves[--made]);
    return status;
}

/* A new object, or (object) a copy with another mesh, which is taken over on success, as is what `hold` refers to (NULL:
 * nothing). edges: of a mesh with the same faces; NULL: they are found. */
static bat_status make(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                       bat_polymesh *mesh, kept_edges *edges, const bat_hold *hold, bat_object **out) {
    own_part own = {.kept = calloc(1, sizeof *own.kept)};
    if (!own.kept) return BAT_MEMORY;
    bat_status status = BAT_OK;
    if (edges)
        bat_users_add(&edges->users);
    else
        status = find_edges(mesh, &edges);
    if (hold) own.hold = *hold;
    *own.kept = (kept_mesh){.users = BAT_USERS_ONE, .mesh = mesh, .edges = edges};
    if (status == BAT_OK) {
        const double *vertices = bat_polymesh_vertices(mesh);
        uint64_t digest = bat_digest_number(edges->digest, bat_polymesh_vertex_count(mesh));
        for (size_t k = 0; k < 3 * bat_polymesh_vertex_count(mesh); k++)
            digest = bat_digest_double(digest, vertices[k]);
        own.kept->digest = digest;
        status = make_object(object, id, name, style, &own, out);
    }
    if (status == BAT_OK) return BAT_OK;
    release_edges(edges);
    free(own.kept);
    return status;
}

bat_status bat_object_create_mesh(bat_id id, const char *name, const bat_style *style,
                                  const bat_polymesh *mesh, bat_object **out) {
    bat_polymesh *copy = NULL;
    bat_status status = style && mesh && out ? bat_polymesh_copy(mesh, &copy) : BAT_ARGUMENT;
    if (status == BAT_OK) status = make(NULL, id, name, style, copy, NULL, NULL, out);
    if (status != BAT_OK) bat_polymesh_free(copy);
    return status;
}

const bat_polymesh *bat_object_mesh(const bat_object *object) {
    const void *own = bat_object_own(object, &bat_kind_of_mesh);
    return own ? part_of(own)->kept->mesh : NULL;
}

/* ---- what it is bound to ---- */

static const bat_hold *hold(const void *own) { return &part_of(own)->hold; }

static size_t points(const bat_object *object, double *out) {
    const bat_polymesh *mesh = bat_object_mesh(object);
    const size_t count = bat_polymesh_vertex_count(mesh);
    if (out) memcpy(out, bat_polymesh_vertices(mesh), 3 * count * sizeof *out);
    return count;
}

/* A copy of the object with this mesh, taken over in any case, and one more user of what it is bound to. */
static bat_status remade(const bat_object *object, bat_polymesh *mesh, kept_edges *edges,
                         const bat_hold *hold, bat_object **out) {
    const bat_status status = make(object, 0, NULL, NULL, mesh, edges, hold, out);
    if (status != BAT_OK)
        bat_polymesh_free(mesh);
    else if (hold->bound)
        bat_bound_retain(hold->bound);
    return status;
}

static bat_status put(const bat_object *object, const double *points, const bat_hold *hold,
                      bat_object **out) {
    bat_polymesh *mesh = NULL;
    bat_status status = bat_polymesh_with(bat_object_mesh(object), points, &mesh, NULL);
    if (status != BAT_OK) return status;
    return remade(object, mesh, part_of(bat_object_own(object, &bat_kind_of_mesh))->kept->edges, hold, out);
}

static bat_status flip(const bat_object *object, bat_object **out) {
    bat_polymesh *mesh = NULL;
    const bat_status status = bat_polymesh_flip(bat_object_mesh(object), &mesh);
    return status == BAT_OK ? remade(object, mesh, NULL, hold(bat_object_own(object, &bat_kind_of_mesh)), out)
                            : status;
}

static const bat_id *sources(const bat_object *object, int *count) {
    const bat_hold *held = bat_object_hold(object);
    *count = held ? held->bound->source_count : 0;
    return held ? held->bound->ids : NULL;
}

/* ---- what the document asks ---- */

static uint64_t digest(uint64_t digest, const void *own) {
    const own_part *part = part_of(own);
    digest = bat_digest_number(digest, part->kept->digest);
    return part->hold.bound ? bat_digest_number(digest, part->hold.bound->digest) : digest;
}

static const char *check(const bat_object *object) {
    const kept_mesh *kept = part_of(bat_object_own(object, &bat_kind_of_mesh))->kept;
    bool same = bat_object_curve_count(object) == line_count(kept->mesh, &kept->edges->strips);
    for (int i = 0; same && i < bat_object_curve_count(object); i++) {
        bat_curve *wanted = NULL;
        if (line(kept->mesh, &kept->edges->strips, i, &wanted) != BAT_OK) return NULL; /* out of memory */
        same = bat_curve_is_equal(wanted, bat_object_curve(object, i));
        bat_curve_free(wanted);
    }
    return same ? NULL : "the lines of a mesh are not where its edges are";
}

static bat_status read(const bat_fields *f, uint32_t node, bat_id id, const char *name, bat_object **out) {
    bat_style style = bat_style_defaults();
    bat_polymesh *mesh = NULL;
    const uint32_t member = bat_json_member(f->json, node, "mesh");
    bat_status status = bat_style_from_json(f, node, &style);
    if (status == BAT_OK && !member) return bat_fields_complain(f, node, "mesh", "an object");
    if (status == BAT_OK) status = bat_polymesh_from_json(f->json, member, &mesh, f->problem);
    if (status != BAT_OK) return status;
    status = make(NULL, id, name, &style, mesh, NULL, NULL, out);
    if (status == BAT_OK) return bat_bound_read(f, node, out);
    bat_polymesh_free(mesh);
    return bat_fields_say(f, node, status);
}

static void write(const bat_object *object, bat_text *text) {
    bat_text_string(text, ",\n  \"style\":");
    bat_style_to_json(bat_object_style(object), text);
    bat_text_string(text, ",\n  \"mesh\":");
    bat_polymesh_to_json(bat_object_mesh(object), text);
    bat_bound_write(object, text);
}

const bat_kind_type bat_kind_of_mesh = {.number = BAT_KIND_MESH,
                                        .name = "mesh",
                                        .traits = BAT_DRAWN | BAT_CURVES | BAT_MADE | BAT_FIXED | BAT_SPACE |
                                                  BAT_NEW,
                                        .size = sizeof(own_part),
                                        .share = share,
                                        .end = end,
                                        .check = check,
                                        .digest = digest,
                                        .transform = bat_bound_transform,
                                        .flip = flip,
                                        .sources = sources,
                                        .remake = bat_bound_remake,
                                        .points = points,
                                        .hold = hold,
                                        .put = put,
                                        .write = write,
                                        .read = read};
