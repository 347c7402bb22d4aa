/*
 * Batten: the relief, a surface with levels. A base surface and levels of detail over it, in both directions, each
 * detail in a frame of the level below, so that the sweep and the detail are edited apart: the sweep is bent and the
 * detail stays, and detail goes from one surface to another. Source: the future work of multilevel-2016 (section 6), as
 * docs/math/surfaces.md ("Levels on surfaces", math 8) builds it.
 *
 *     S^j(u, v) = refine(S^{j-1}) + sum_ik F^{j-1}(u_i, v_k) g_j d_ik^j N_i^j(u) M_k^j(v)
 *
 * The knots of each level contain those below in both directions; (u_i, v_k) are pairs of Greville abscissae. A frame
 * has three axes of length 1 at right angles: the first between S_u and S_v (the middle of S_u and of S_v turned back by
 * a right angle), the third their normal n, S_u x S_v, the second n x the first. Details are three numbers in it, in
 * document units. Exchanging u and v changes the frames by rounding alone. Where an edge is a point (a pole) its row has
 * one frame and one detail, and stays a point.
 */
#ifndef BATTEN_RELIEF_H
#define BATTEN_RELIEF_H

#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { BAT_RELIEF_LEVELS = 12 }; /* over the base, at most */

typedef struct bat_relief bat_relief;

/* Copies the base. The relief has no level yet. An edge of the base whose control points are equal, in an open direction
 * with a clamped end, is a pole for good. O(points). */
BAT_API bat_status bat_relief_create(const bat_surface *base, bat_relief **out);
/* O(points of all levels). */
BAT_API bat_status bat_relief_copy(const bat_relief *relief, bat_relief **out);
BAT_API void bat_relief_free(bat_relief *relief); /* NULL is fine */

/*
 * Adds a level on top. u_knots, v_knots: of each direction a superset of the knots below, in a surface's own form; NULL: a
 * knot in the middle of every span of that direction (its count is then not read). details: 3 for each control point of the
 * level, row by row, or NULL: none yet. source: one for each control point, the level whose surface carries its frame, or
 * NULL: the level below. At a pole the mean of the row's details is taken. BAT_KNOTS: not a superset; BAT_COUNT:
 * BAT_RELIEF_LEVELS there are, or too many points; BAT_NUMBER: a detail is not within BAT_COORDINATE_MAX; BAT_ARGUMENT: a
 * source is no level below. O(points).
 */
BAT_API bat_status bat_relief_add_level(bat_relief *relief, const int knot_count[2], const double *u_knots,
                                        const double *v_knots, const double *details, const int *source);

BAT_API int bat_relief_levels(const bat_relief *relief); /* k; 0 at first */
/* S^0 (the base) to S^k; owned by the relief, valid until it changes. NULL: no such level. */
BAT_API const bat_surface *bat_relief_surface(const bat_relief *relief, int level);
/* Of level 1 to k, for each control point of S^level, row by row; owned by the relief. No such level: NULL, gain 0, not
 * muted. */
BAT_API const double *bat_relief_details(const bat_relief *relief, int level);
BAT_API const int *bat_relief_source(const bat_relief *relief, int level);
BAT_API double bat_relief_gain(const bat_relief *relief, int level);
BAT_API bool bat_relief_is_muted(const bat_relief *relief, int level);

/*
 * Edits. Vectors are in world coordinates, 3 numbers each; level 0 is the base. On failure the relief is as it was. What
 * lies beyond the supports of what is moved, at its level, keeps every bit, as do details of other levels. Each call costs O(points of the levels above).
 * BAT_ARGUMENT: there is no such level or control point; BAT_STATE: a muted level, or one of gain 0, shows no change;
 * BAT_NUMBER: numbers are not finite, or points would lie too far out.
 */
/* Moves `count` control points of S^level by deltas; index: row * (points a row) + place in the row. The points of a pole
 * move together, by the mean of what is asked for. */
BAT_API bat_status bat_relief_move(bat_relief *relief, int level, size_t count, const size_t *index,
                                   const double *deltas);
/* Moves the point of S^level at (u, v) by exactly delta, with the least change of its control points. */
BAT_API bat_status bat_relief_drag(bat_relief *relief, int level, double u, double v, const double delta[3]);
/* The same, repeated until the point of the finest surface at (u, v) has moved by delta within tolerance (at most 20 times).
 * *left (may be NULL): what is missing. BAT_TOLERANCE: the point does not get there. */
BAT_API bat_status bat_relief_drag_finest(bat_relief *relief, int level, double u, double v,
                                          const double delta[3], double tolerance, double *left);
/* bat_surface_redraw on S^level, with its weights, report and statuses, except that the line has to have exactly
 * the knots of S^level (else BAT_KNOTS). The levels above ride along. options may be NULL: the defaults. */
BAT_API bat_status bat_relief_redraw(bat_relief *relief, int level, bat_direction direction, double at,
                                     const bat_curve *line, const bat_surface_redraw_options *options,
                                     double *weights, bat_surface_redraw_report *report);
/* The equaliser: 0 mutes the detail, 1 leaves it as it is, above 1 exaggerates it; within +-1e6, else BAT_NUMBER. */
BAT_API bat_status bat_relief_set_gain(bat_relief *relief, int level, double gain);
/* A muted level shows nothing; its gain is kept. */
BAT_API bat_status bat_relief_set_muted(bat_relief *relief, int level, bool muted);
/* Affine image, 3 rows of 4. Details are expressed anew, so that every S^j is exactly the image of what it was; under a
 * rigid motion they do not change (rounding apart), under a reflection their third number changes its sign. BAT_SINGULAR:
 * the image is no surface; BAT_NUMBER. */
BAT_API bat_status bat_relief_transform(bat_relief *relief, const double *matrix);

/*
 * Takes a surface apart into `levels` levels, exactly: at each level every other inner knot of both directions is left out,
 * and the coarse surface is fitted by least squares (clamped edges stay). The finest surface is the given one within 1e-13 of
 * its size. Where the base of a detail is folded (|S_u x S_v| below a tenth of the base's there) a coarser level carries its
 * frame. A direction without knots to spare stays as it is. BAT_COUNT: at some level neither direction has any, or levels
 * is not within 0 and BAT_RELIEF_LEVELS; BAT_SINGULAR: a coarser surface would be a point. O(points * degree^2).
 */
BAT_API bat_status bat_relief_decompose(const bat_surface *surface, int levels, bat_relief **out);
/* The same down to a base of coarsest[0] by coarsest[1] control points, the counts in between forming geometric
 * progressions. BAT_COUNT: fewer than a surface needs (closed: fewer than 3), or so many that there is no room for the
 * levels; a direction may also keep the count that it has. */
BAT_API bat_status bat_relief_decompose_to(const bat_surface *surface, int levels, const size_t coarsest[2],
                                           bat_relief **out);

/* The levels of `from`, with their gains, over another base: u goes to u, v to v, the domains are mapped onto each other,
 * and details keep their lengths and how they lie to the surface. In directions of the same degree that are both open or both
 * closed the details are the same splines on the knots of both, else they are taken at the nodes. BAT_COUNT: too many
 * points. O(points of the result). */
BAT_API bat_status bat_relief_copy_levels(const bat_relief *from, const bat_surface *onto, bat_relief **out);

#ifdef __cplusplus
}
#endif
#endif
