/* Batten: the closest point, provably right (Bernstein sign test). */
#ifndef BATTEN_NEAREST_H
#define BATTEN_NEAREST_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct bat_near {
    double u;
    double distance;
    double point[BAT_DIMENSION_MAX];
} bat_near;

/* Global closest point; of equally close ones, the one with the smaller u. BAT_NUMBER: the point is not finite.
 * Cost: O(count), and more for spans that come near. */
BAT_API bat_status bat_curve_nearest(const bat_curve *curve, const double *point, bat_near *out);
/* All local minima of distance within `within` (document units, may be INFINITY), nearest first; at most `room`
 * written, *count says how many there are. Ends of open curves count if the distance grows from there inwards. out
 * may be NULL when room is 0. BAT_ARGUMENT: within below 0 or NaN; BAT_NUMBER: the point is not finite. */
BAT_API bat_status bat_curve_nearest_all(const bat_curve *curve, const double *point, double within,
                                         size_t room, bat_near *out, size_t *count);
/* Newton projection starting from u, with `steps` steps; the result is never farther away than the start. Cheap
 * and local. */
BAT_API double bat_curve_project_near(const bat_curve *curve, const double *point, double u, int steps);

/* A finder precomputes boxes of span hulls for many queries on one curve, in O(count). Borrows the curve, which
 * must outlive it. A point that is not finite has no nearest point: the distance is NaN. */
typedef struct bat_finder bat_finder;
BAT_API bat_status bat_finder_create(const bat_curve *curve, bat_finder **out);
BAT_API void bat_finder_free(bat_finder *finder); /* NULL is fine */
BAT_API void bat_finder_nearest(const bat_finder *finder, const double *point, bat_near *out);

#ifdef __cplusplus
}
#endif
#endif
