/*
 * Mirror images of planar curves, and curves that are their own: a line is the axis; a curve that crosses it or ends at
 * it becomes one curve with its mirror image, C2 across the axis (docs/math/sketch.md 5.11).
 */
#ifndef BATTEN_CURVE_MIRROR_H
#define BATTEN_CURVE_MIRROR_H

#include <batten/curve.h>

typedef struct bat_mirror {
    bool on;
    double at[2], along[2]; /* the axis: a place on it, and its direction, of length 1 */
} bat_mirror;

/* Finite, within BAT_COORDINATE_MAX, the direction of length 1 to rounding. */
bool bat_mirror_is_good(const bat_mirror *mirror);
/* How far the place lies from the axis: positive on the side that is right of its direction in a drawing with y downwards
 * and the axis pointing down. */
double bat_mirror_side(const bat_mirror *mirror, const double point[2]);
/* How far along the axis the place is, and the place on the axis so far along. */
double bat_mirror_along(const bat_mirror *mirror, const double point[2]);
void bat_mirror_place(const bat_mirror *mirror, double along, double out[2]);
void bat_mirror_point(const bat_mirror *mirror, const double point[2], double out[2]);
/* As bat_matrix_ functions take it: x' = m[0] x + m[2] y + m[4], y' = m[1] x + m[3] y + m[5]. */
void bat_mirror_matrix(const bat_mirror *mirror, double out[6]);
/* The image, control point by control point, with the same knots. BAT_DIMENSION: not planar. */
bat_status bat_mirror_curve(const bat_mirror *mirror, const bat_curve *curve, bat_curve **out);

/* The same with another map of the points. */
bat_status bat_mirror_map(const bat_mirror *mirror, const bat_curve *curve,
                          void (*map)(const bat_mirror *m, const double p[2], double out[2]),
                          bat_curve **out);

/*
 * The curve as one that is its own mirror image. What lies on one side of the axis is kept, to within tolerance at the
 * axis and bit for bit two spans from it; the other side becomes its mirror image. side: -1 or 1, or 0 for the one that
 * more of its length is on. Ends that reach over the axis by no more than `reach` are cut off; ends that run towards it and
 * stop short by no more than that are led to it.
 * - an open curve across the axis, or with one end at it: an open curve;
 * - an open curve with both ends at it, a closed one that crosses it twice: a closed curve;
 * - an open curve along the axis, nowhere farther from it than half of reach: that stretch of the axis.
 * BAT_STATE: anything else; its image is another curve. BAT_DIMENSION: not planar. All lengths in document units.
 */
bat_status bat_mirror_whole(const bat_mirror *mirror, const bat_curve *curve, int side, double reach,
                            double tolerance, bat_curve **out);

/* Whether b is a's mirror image, each no farther than `within` from the other's. A curve may be its own. */
bool bat_mirror_twins(const bat_mirror *mirror, const bat_curve *a, const bat_curve *b, double within);
/*
 * The axis about which a planar curve is its own mirror image, control point for control point and span for span, each run through
 * backwards, to `within`; of several the one nearest to the direction upright. *turn: control point i is the image of
 * turn - 1 - i (modulo their number). O(n), at most 64 times. False: there is none, or not among the 64 that are the most upright.
 */
bool bat_mirror_find(const bat_curve *curve, const double upright[2], double within, bat_mirror *out,
                     int *turn);
static inline int bat_mirror_image_of(int count, int turn, int i) {
    return (2 * count - 1 - i + turn) % count;
}
/* The same with an axis that is known. */
bool bat_mirror_turn(const bat_mirror *mirror, const bat_curve *curve, double within, int *turn);
/* How far control points are from where their images belong, at most. */
double bat_mirror_uneven(const bat_mirror *mirror, const bat_curve *curve, int turn);
/*
 * Of a curve whose control points mirrored each other (to `within`) and have been moved since, its knots the same: the
 * curve where they mirror each other again. Of two that belong together the one that moved farther counts; those where
 * neither moved stay bit for bit. BAT_STATE: it is no such curve.
 */
bat_status bat_mirror_net(const bat_mirror *mirror, const bat_curve *before, const bat_curve *after,
                          double within, bat_curve **out);

#endif
