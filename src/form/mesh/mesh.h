/* Internal to meshes: the representation. */
#ifndef BATTEN_FORM_MESH_H
#define BATTEN_FORM_MESH_H

#include <batten/mesh.h>

struct bat_polymesh {
    size_t vertex_count, face_count, corner_count;
    double *vertices;
    int *first; /* face_count + 1: where each face's corners begin */
    int *corners;
};

/* The same faces, seen from the other side: corners in the other sense, from the first. BAT_MEMORY. O(corners). */
bat_status bat_polymesh_flip(const bat_polymesh *mesh, bat_polymesh **out);
/* Twice the area times the normal (Newell): exact for planar faces, the best plane's for others. */
void bat_face_normal(const bat_polymesh *mesh, size_t face, double out[3]);

#endif
