/* The pieces into which the boundaries of regions cut each other (docs/math/relate.md 6). */
#ifndef BATTEN_SRC_RELATE_REGION_ARRANGEMENT_H
#define BATTEN_SRC_RELATE_REGION_ARRANGEMENT_H

#include <batten/region.h>

#define BAT_NO_NODE SIZE_MAX

/* A place where a curve is cut. */
typedef struct bat_cut {
    double u;
    size_t spot;
} bat_cut;

typedef struct bat_cut_curve {
    const bat_curve *curve;
    size_t region;
    size_t count, room;
    bat_cut *cuts;
} bat_cut_curve;

/* A piece of a curve between two nodes, or all of one that meets nothing. */
typedef struct bat_region_edge {
    size_t curve;
    double u[2];    /* u[1] not above u[0]: in the next period */
    size_t node[2]; /* BAT_NO_NODE, both: all of the curve */
    bat_curve *own; /* the piece, which begins and ends at its nodes bit for bit; NULL: straight */
    double *bezier; /* its spans: spans * (degree + 1) points */
    int spans;
    double box[4];  /* of its control points: low x, low y, high x, high y */
    size_t same_as; /* the first of the edges that run along it; its own index: it is that */
    int sign;       /* -1: against that one */
    size_t next;    /* of those that run along the same one; BAT_NO_NODE: none */
    int keep; /* of the first ones: 1 or -1 when it bounds the result, which lies to its left or right; else 0 */
} bat_region_edge;

typedef struct bat_arrangement {
    bat_region_operation operation;
    size_t region_count;
    const bat_region *regions;
    double tolerance, gap; /* gap: how near things are the same */
    double step;           /* of the grid, a power of 2; nodes are at multiples of it */
    size_t curve_count;
    bat_cut_curve *curves;
    size_t spot_count, spot_room;
    double *spots; /* x y, where cuts were found */
    size_t node_count;
    size_t *node_of; /* of each spot */
    double *nodes;   /* x y */
    size_t edge_count, edge_room;
    bat_region_edge *edges;
} bat_arrangement;

static inline int bat_edge_degree(const bat_arrangement *a, const bat_region_edge *e) {
    return bat_curve_degree(a->curves[e->curve].curve);
}

/* ---- cut.c ---- */
/* Cuts all curves where they meet. */
bat_status bat_arrangement_cut(bat_arrangement *a);
/* Whether only rounding makes a difference between two parameters. */
bool bat_is_same_place(const bat_curve *curve, double u, double v);
/* The knot next to u if it is the same place; else u. */
double bat_nearest_knot(const bat_curve *curve, double u);
/* ---- edges.c ---- */
/* The piece of a closed curve from u[0] to u[1], in the next period if that is not above u[0]; its ends are put where they have
 * to be. */
bat_status bat_region_piece(const bat_curve *curve, const double u[2], const double *from, const double *to,
                            bat_curve **out);
/* Makes the edges between cuts, and finds those that run along each other. */
bat_status bat_arrangement_edges(bat_arrangement *a);
/* ---- judge.c ---- */
/* Finds which edges bound the result. BAT_SINGULAR: they are no boundary together. */
bat_status bat_arrangement_judge(bat_arrangement *a);
/* Whether a place is in the result that is in so many regions, among them the first or not. */
bool bat_arrangement_holds(const bat_arrangement *a, size_t in, bool first);
/* ---- grid.c ---- */
/* Makes nodes and edges, straight ones, that meet at nodes alone. */
bat_status bat_arrangement_grid(bat_arrangement *a);
/* ---- faces.c ---- */
/* Finds which of such edges bound the result: always a boundary. */
bat_status bat_arrangement_faces(bat_arrangement *a);
/* ---- outline.c ---- */
/* Joins the edges that are kept to closed curves. */
bat_status bat_arrangement_outline(const bat_arrangement *a, size_t *count, bat_curve ***out);

#endif
