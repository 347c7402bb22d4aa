/*
 * Batten: what is seen of a scene: surfaces and curves in a view as lines, split where they become hidden (docs/math/
 * surfaces.md). The lines are those of surfaces' edges, knots, silhouettes and intersections, and the curves.
 */
#ifndef BATTEN_SIGHT_H
#define BATTEN_SIGHT_H

#include <batten/trace.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Borrowed by the call. */
typedef struct bat_line_scene {
    size_t surface_count;
    const bat_surface *const *surfaces;
    size_t curve_count;
    const bat_curve *const *curves; /* of dimension 2 or 3; 2: z = 0. They hide nothing */
} bat_line_scene;

typedef enum bat_line_kind {
    BAT_LINE_EDGE = 0,      /* where a surface ends */
    BAT_LINE_PARAMETER = 1, /* at a knot inside: of at most 63 in each direction */
    BAT_LINE_SILHOUETTE = 2,
    BAT_LINE_INTERSECTION = 3, /* of two surfaces of the scene */
    BAT_LINE_CURVE = 4
} bat_line_kind;

/* A stretch of a line that is all hidden or all seen. */
typedef struct bat_seen_line {
    bat_line_kind kind;
    size_t source; /* index of the surface (intersection: the first) or curve */
    bool hidden;
    int segments;         /* cubic Bezier segments that follow each other */
    const double *points; /* pixels: segments * 3 + 1 points of 2 numbers; owned by the drawing */
} bat_seen_line;

typedef struct bat_line_drawing bat_line_drawing;

/*
 * Draws what is before the eye. In the window and as much again around it lines are within 0.1 pixels, split where they cross
 * in the image, where their surface turns away, and at cusps; exact rays decide each piece, which is halved where they differ.
 * Farther off they are coarse, and what hides them may be missed. Statuses as bat_viewpoint_check; BAT_ARGUMENT: a surface or
 * curve is NULL; BAT_COUNT: over 1000 surfaces, or too many lines for memory. Cost: that of the silhouettes, of intersections
 * of all pairs of surfaces whose boxes meet, and some thousand rays; what is far beyond the window adds next to nothing.
 */
BAT_API bat_status bat_line_drawing_create(const bat_viewpoint *view, const bat_line_scene *scene,
                                           bat_line_drawing **out);
BAT_API void bat_line_drawing_free(bat_line_drawing *drawing); /* NULL is fine */
BAT_API size_t bat_line_drawing_count(const bat_line_drawing *drawing);
/* All zero: no such line. */
BAT_API void bat_line_drawing_at(const bat_line_drawing *drawing, size_t i, bat_seen_line *out);
/* Whether all silhouettes and intersections were traced; else surfaces touch along curves, or are seen from such a side,
 * and what lies near these may be wrong. */
BAT_API bool bat_line_drawing_is_whole(const bat_line_drawing *drawing);

#ifdef __cplusplus
}
#endif
#endif
