/* Lines that show a mesh: its edges, joined as they run on. Of edges alone, not of places, so that they stay the same
 * while vertices move. */
#ifndef BATTEN_FORM_MESH_STRIPS_H
#define BATTEN_FORM_MESH_STRIPS_H

#include <batten/mesh.h>

enum { BAT_STRIPS_MAX = 256, BAT_STRIP_POINTS_MAX = 1 << 14 };

/* Strip i: vertices[starts[i]] up to starts[i + 1]; one that is closed ends where it starts. */
typedef struct bat_strips {
    int count;
    int *starts;
    int *vertices;
} bat_strips;

/* Through a vertex whose faces surround it a strip runs on to the opposite edge, along the border it follows the border.
 * Each edge is in one strip; of the strips, as many as fit into the two limits, the longest first. A mesh without faces has
 * none. O(corners), where no more than 64 faces meet. Free with bat_strips_clear, also after a failure. */
bat_status bat_polymesh_strips(const bat_polymesh *mesh, bat_strips *out);
void bat_strips_clear(bat_strips *strips);

#endif
