/* A mesh as triangles to be shaded: smooth but for sharp edges. */
#ifndef BATTEN_FORM_MESH_FACETS_H
#define BATTEN_FORM_MESH_FACETS_H

#include <batten/mesh.h>

typedef struct bat_facets {
    size_t corner_count, triangle_count;
    double *points, *normals; /* 3 numbers a corner; normals are unit */
    int *triangles;           /* 3 corners each */
} bat_facets;

/* The first corners are the vertices, with their normals; where a triangle is turned from a corner's normal by more than 40
 * degrees it has a corner of its own there, with its own normal. O(corners), as bat_polymesh_triangles. */
bat_status bat_polymesh_facets(const bat_polymesh *mesh, bat_facets *out);
void bat_facets_clear(bat_facets *facets);

#endif
