/* Internal to formats: where triangles end, and which of their vertices are at one place. */
#ifndef BATTEN_FORMAT_RIM_H
#define BATTEN_FORMAT_RIM_H

#include "format/model/model.h"

/* An edge that no triangle has the other way round, as its triangle has it; vertices as of `same`. */
typedef struct bat_rim_edge {
    int from, to;
} bat_rim_edge;

/* The vertex that stands for all that hang together with this one, by way of others; ways become shorter. */
static inline int bat_rim_root(int *way, int vertex) {
    while (way[vertex] != vertex) vertex = way[vertex] = way[way[vertex]];
    return vertex;
}

/* Of each vertex, the first one at its very place. O(vertices log vertices). */
bat_status bat_rim_same(const bat_part *part, int *same);
/* Edges in order of `from`, to be freed; triangles without area have none. O(triangles log triangles). */
bat_status bat_rim_edges(const bat_part *part, const int *same, size_t *count, bat_rim_edge **out);
/* Vertices at the ends of edges that are nearer than `within` to each other become the same. *joined: how many. */
bat_status bat_rim_join(const bat_part *part, size_t count, const bat_rim_edge *edges, double within,
                        int *same, size_t *joined);

#endif
