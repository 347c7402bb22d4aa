/*
 * Batten: views, and strokes cast into space. A view says where the eye is and what the window shows; each pixel of it
 * is a ray. A stroke is cast on a plane, on the ruled surface of a curve, or on a surface: every sample lands where its
 * ray meets it (docs/math/surfaces.md).
 *
 * Pixel (0, 0) is the top left corner, y points down; the eye looks through the middle of the window.
 */
#ifndef BATTEN_VIEW_H
#define BATTEN_VIEW_H

#include <batten/sketch.h>
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Either fov or height is above 0, and the other is 0. */
typedef struct bat_viewpoint {
    double eye[3], target[3], up[3];
    double size[2]; /* width and height of the window in pixels */
    double fov;     /* perspective: the vertical angle that the window shows, in degrees, below 180 */
    double height;  /* parallel projection: document units from the top of the window to the bottom */
} bat_viewpoint;

/* Checks a view: BAT_NUMBER: a number is not finite or too large; BAT_ARGUMENT: size, fov or height are out of range;
 * BAT_SINGULAR: eye and target are the same point, or up is parallel to the gaze. The calls below check it, too.
 * problem (may be NULL) says what is wrong: "size[1]". */
BAT_API bat_status bat_viewpoint_check(const bat_viewpoint *view, bat_problem *problem);
/* The ray through a pixel. direction has length 1. origin: the eye, or in parallel projection the point at the pixel in
 * the plane of the eye at right angles to the gaze; what lies before it on the ray is behind the eye. BAT_NUMBER:
 * the pixel is not finite. */
BAT_API bat_status bat_viewpoint_ray(const bat_viewpoint *view, const double pixel[2], double origin[3],
                                     double direction[3]);
/* The pixel at which a point is seen; depth (may be NULL): its distance from the eye along the gaze. BAT_NUMBER: the
 * point is not finite; BAT_FAR: in perspective, it does not lie before the eye. */
BAT_API bat_status bat_viewpoint_project(const bat_viewpoint *view, const double point[3], double pixel[2],
                                         double *depth);

/* What a stroke is cast on: the ruled surface of the curve C, the points C(s) + h along (along is made unit); or else
 * a surface; or else, when both are NULL, the plane. Borrowed by the calls below. */
typedef struct bat_canvas {
    bat_curve *curve; /* of dimension 2 or 3; 2: z = 0 */
    double along[3];
    bat_surface *surface;
    double origin[3], normal[3]; /* the plane; normal of any length above 0 */
} bat_canvas;

/* Frees the curve and the surface, as bat_canvas_read (format.h) hands them over. */
BAT_API void bat_canvas_clear(bat_canvas *canvas);

/* What became of a sample. When several reasons hold, the first of them. */
typedef enum bat_cast_fate {
    BAT_CAST_LANDED = 0,
    BAT_CAST_EDGE_ON = 1, /* the sine of the angle between ray and canvas is below that of 5 degrees */
    BAT_CAST_MISSED = 2,
    BAT_CAST_BEHIND = 3, /* behind the eye */
    BAT_CAST_FAR = 4     /* on a ruled surface: further from the curve than 4 times the curve's size */
} bat_cast_fate;

typedef struct bat_cast_point {
    bat_cast_fate fate;
    double point[3]; /* this and the rest only where the sample landed */
    double own[2];   /* on the canvas: s and h, or u and v; on a plane 0 */
    double distance; /* from the origin of the ray */
} bat_cast_point;

/*
 * Casts each sample of a stroke, in pixels of the view. out: as many as the stroke has samples. *landed (may be NULL):
 * how many landed. A ray can meet a ruled surface more than once: of the places that can be kept the first sample
 * takes the one with the least |h| (of those within 1e-6 of the size, the nearest to the eye), every other one the s nearest to that of the sample that landed before it. On a
 * surface it is the hit nearest to the eye. BAT_DIMENSION: the stroke does not have 2 coordinates; BAT_NUMBER: a sample
 * or the canvas is not finite; BAT_ARGUMENT: along or normal is zero; else as bat_viewpoint_check. Cost: a curve's
 * spans for each sample; on a surface that of bat_surface_hits.
 */
BAT_API bat_status bat_cast(const bat_viewpoint *view, const bat_stroke *stroke, const bat_canvas *canvas,
                            bat_cast_point *out, size_t *landed);

/* The line of a surface that a marking means. */
typedef struct bat_surface_pick {
    bat_direction direction; /* BAT_U: the line at u = value */
    double value;
    bool boundary; /* the marking is within 2 % of the domain's width of an edge: the line is that edge */
    size_t used, dropped; /* samples on the surface, and beside it */
    double
        residual[2]; /* how far the marking deviates from the best line at u, at v: a length on the surface */
} bat_surface_pick;

/* Finds the line that a marking (a stroke in pixels of the view) means: at its mean u or v, whichever it deviates from
 * less. Statuses as bat_cast; BAT_FAR: no sample is on the surface. */
BAT_API bat_status bat_surface_pick_line(const bat_viewpoint *view, const bat_stroke *marking,
                                         const bat_surface *surface, bat_surface_pick *out);

/* How a line of a surface is redrawn by a stroke. */
typedef struct bat_surface_sketch_options {
    size_t size;      /* of this struct, as base.h says */
    double along[3];  /* the direction of the ruled surface on which the stroke is cast; zero: as below */
    double tolerance; /* greatest distance of the new line from the stroke; 0: 1e-4 of the surface's size */
    const bat_surface_redraw_options *redraw; /* how the surface follows; NULL: the defaults */
    /* How many control points at the start and at the end of the line stay as they are: 1 keeps its place there, 2 the
     * tangent, 3 the curvature; at least 0. */
    int keep[2];
} bat_surface_sketch_options;

BAT_API void bat_surface_sketch_options_init(bat_surface_sketch_options *options, size_t size);
static inline bat_surface_sketch_options bat_surface_sketch_defaults(void) {
    bat_surface_sketch_options options;
    bat_surface_sketch_options_init(&options, sizeof options);
    return options;
}

typedef struct bat_surface_sketch_report {
    bat_surface_redraw_report redraw; /* gain 0: the surface was not reached */
    size_t landed, dropped;           /* samples of the stroke */
    double along[3];                  /* the direction of the ruled surface, of length 1 */
    bool turned;                      /* it is not the surface's own, which would be seen from its edge */
    double max_error;                 /* the line's distance from the stroke, before knots are removed */
} bat_surface_sketch_report;

/*
 * Redraws the line of the surface at u (BAT_U) or v (BAT_V) with a stroke in pixels of the view: it is cast on the line's
 * ruled surface (bat_cast), the sketch hand redraws the line in space (bat_sketch), the line is put on the surface's knots,
 * and more of them only where these cannot meet the tolerance, the surface follows (bat_surface_redraw), and knots along
 * the line that can go within the tolerance are removed. Degrees 1 and 2 along the line are first raised to 3. The ruled
 * surface runs along the surface's mean normal; where normals cancel, as round a rim, along the normal of the line's loop;
 * where it would be seen at less than 15 degrees, across the gaze. options may be NULL: the defaults; weights
 * and report: as in bat_surface_redraw. Statuses
 * of these calls; BAT_FAR: over a third of the samples is dropped, or the stroke is too far from the line, or the line
 * cannot move; BAT_TOLERANCE: the tolerance cannot be met; BAT_STATE: the stroke moves an end that is to stay. The report is filled in as far as the call came.
 */
BAT_API bat_status bat_surface_sketch(const bat_surface *surface, bat_direction direction, double at,
                                      const bat_viewpoint *view, const bat_stroke *stroke,
                                      const bat_surface_sketch_options *options, bat_surface **out,
                                      double *weights, bat_surface_sketch_report *report);

#ifdef __cplusplus
}
#endif
#endif
