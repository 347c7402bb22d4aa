/*
 * Batten: polygon meshes, the MESH of docs/format.md: vertices in space, and faces of any number of corners. Anything
 * that lists vertices is kept: isolated vertices, clouds (no faces), edges with more than two faces, faces that turn
 * over or use a vertex twice. Faces are in the order of the input, and so are their corners: anticlockwise where the
 * normal points at the eye.
 *
 * A mesh is a value: it never changes after it is made, and is one allocation.
 */
#ifndef BATTEN_MESH_H
#define BATTEN_MESH_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    BAT_VERTICES_MAX = 1 << 24, /* of one mesh; as many faces */
    BAT_CORNERS_MAX = 1 << 26   /* of all faces of a mesh together */
};

typedef struct bat_polymesh bat_polymesh;

/*
 * Makes a mesh after checking everything; copies the arrays. vertices: 3 numbers each; sizes: the number of corners of
 * each face, 3 or more; corners: the vertices of all faces, one face after the other, from 0. wrong (may be NULL) is
 * filled in on failure: which vertex or face is meant. BAT_COUNT: no vertex, too many of anything, or a face with fewer
 * than 3 corners; BAT_NUMBER: a coordinate of a vertex is not finite or beyond BAT_COORDINATE_MAX; BAT_PARAMETER: a face
 * names a vertex that does not exist. O(vertices + corners).
 */
BAT_API bat_status bat_polymesh_create(size_t vertex_count, const double *vertices, size_t face_count,
                                       const int *sizes, const int *corners, bat_polymesh **out,
                                       size_t *wrong);
/* The same check, without a mesh; problem (may be NULL) says what is wrong: "faces[3][1]", "vertices[2][0]". */
BAT_API bat_status bat_polymesh_check(size_t vertex_count, const double *vertices, size_t face_count,
                                      const int *sizes, const int *corners, bat_problem *problem);
BAT_API bat_status bat_polymesh_copy(const bat_polymesh *mesh, bat_polymesh **out);
BAT_API void bat_polymesh_free(bat_polymesh *mesh); /* NULL is fine */

BAT_API size_t bat_polymesh_vertex_count(const bat_polymesh *mesh);
/* 3 numbers each; owned by the mesh. */
BAT_API const double *bat_polymesh_vertices(const bat_polymesh *mesh);
BAT_API size_t bat_polymesh_face_count(const bat_polymesh *mesh);
/* The vertices of face i, owned by the mesh; *count: how many. NULL and 0: no such face. */
BAT_API const int *bat_polymesh_face(const bat_polymesh *mesh, size_t i, size_t *count);
BAT_API void bat_polymesh_box(const bat_polymesh *mesh, double low[3], double high[3]);
/* Length of the box's diagonal: the "size" that relative bounds refer to. O(vertices). */
BAT_API double bat_polymesh_size(const bat_polymesh *mesh);
/* Bitwise equality. */
BAT_API bool bat_polymesh_is_equal(const bat_polymesh *a, const bat_polymesh *b);
/* The same faces with other vertices, as many. Statuses as for a new mesh. */
BAT_API bat_status bat_polymesh_with(const bat_polymesh *mesh, const double *vertices, bat_polymesh **out,
                                     size_t *wrong);

/*
 * The faces as triangles, 3 vertices each, in the same sense; room for 3 * bat_polymesh_triangle_count. A face whose
 * outline, seen along its mean normal, does not cross itself is divided along that outline, convex or not; others, and
 * faces of over 4096 corners that are not convex, are divided from their first corner. Triangles may be degenerate
 * where faces are. O(corners) for convex faces, O(corners squared) for a face that is not.
 */
BAT_API size_t bat_polymesh_triangle_count(const bat_polymesh *mesh);
BAT_API bat_status bat_polymesh_triangles(const bat_polymesh *mesh, int *out);
/* A unit normal at each vertex: the mean of its faces' normals by their areas; (0, 0, 1) where there is none. 3
 * numbers a vertex. O(vertices + corners). */
BAT_API void bat_polymesh_normals(const bat_polymesh *mesh, double *out);

#ifdef __cplusplus
}
#endif
#endif
