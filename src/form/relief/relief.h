/* Inside surfaces with levels: what a relief is made of. */
#ifndef BATTEN_FORM_RELIEF_H
#define BATTEN_FORM_RELIEF_H

#include <batten/relief.h>

#include "form/surface/surface.h"
#include "hands/levels/shape.h"

typedef struct bat_relief_level {
    double gain;
    bool muted;
    double *details;   /* 3 a control point, row by row, in the frames below */
    int *source;       /* for each control point the level, below this one, whose surface carries the frame */
    bat_triad *frames; /* those the surface was built with: t the first leg, r the normal */
    bat_surface *surface; /* S^j */
} bat_relief_level;

enum { BAT_EDGES = 4 }; /* u first, u last, v first, v last */

struct bat_relief {
    int count;           /* levels over the base */
    int pole[BAT_EDGES]; /* edges that are a point: the least of those that share it; -1: no pole */
    bat_surface *base;
    bat_relief_level levels[BAT_RELIEF_LEVELS];
};

static inline bat_surface *bat_relief_at(const bat_relief *relief, int level) {
    return level > 0 ? relief->levels[level - 1].surface : relief->base;
}
static inline double bat_relief_loudness(const bat_relief_level *level) {
    return level->muted ? 0 : level->gain;
}
static inline size_t bat_relief_points(const bat_surface *surface) {
    return (size_t)surface->axis[0].count * (size_t)surface->axis[1].count;
}

/* An edge's control points: the index of the first, the step from one to the next, and how many. */
typedef struct bat_edge {
    size_t first, step, count;
} bat_edge;
bat_edge bat_edge_of(const bat_surface *surface, int edge);
/* Whether the edge is there, ends at its own control points, and these are equal within `slack`. */
bool bat_edge_is_point(const bat_surface *surface, int edge, double slack);
/* Replaces the vectors (3 numbers each) at the points of a pole by their mean, where they differ. */
void bat_pole_mean(const bat_surface *surface, const int pole[BAT_EDGES], double *vectors);
/* The user's control points, 3 numbers each, row by row. */
void bat_surface_gather(const bat_surface *surface, double *out);
/* A surface on the same knots with other control points. */
bat_status bat_surface_remade(const bat_surface *surface, const double *points, bat_surface **out);

/* u and v change places, so that the normals point the other way, at every level up to rounding. */
bat_status bat_relief_transpose(const bat_relief *relief, bat_relief **out);

/* The frames at the nodes of a level (math 8), from the surfaces below as they stand. */
bat_status bat_relief_frames(const bat_relief *relief, int level, bat_triad *out);
/* For each node of a level, the level that carries its frame: the highest below it that is not folded there. */
bat_status bat_relief_sources(const bat_relief *relief, int level, int *out);
/* Nodes of a direction, ascending; of a closed one they may lie beyond the domain. */
void bat_relief_nodes(const bat_surface *surface, int direction, double *out);

/* Builds S^level from the surface below and the frames it has. */
bat_status bat_relief_build(bat_relief *relief, int level);
/* Builds S^level (0: the caller has changed the base) and all above it, in the frames of their surfaces. On failure the
 * relief is spoilt: edit a copy. */
bat_status bat_relief_rebuild(bat_relief *relief, int level);
void bat_relief_adopt(bat_relief *relief, bat_relief *edited);
/* Adds a level without details on these knots, not built yet. */
bat_status bat_relief_push(bat_relief *relief, const int knot_count[2], const double *const knots[2]);
void bat_relief_pop(bat_relief *relief);

#endif
