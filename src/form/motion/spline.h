/* Internal: splines over the frames of a take, by least squares. */
#ifndef BATTEN_FORM_MOTION_SPLINE_H
#define BATTEN_FORM_MOTION_SPLINE_H

#include <batten/curve.h>

/* Clamped knots over 0 .. frames - 1 (one frame: 0 .. 1), with inner ones between. */
typedef struct bat_knots {
    int degree, count; /* how many points they are for */
    double *t;         /* count + degree + 1 */
} bat_knots;

/* Degree 3, or less where there are fewer frames, without inner knots. */
bat_status bat_knots_plain(size_t frames, bat_knots *out);
/* `spans` spans of one length. */
bat_status bat_knots_even(size_t frames, int spans, bat_knots *out);
/* As many points as frames, so that a spline goes through all. */
bat_status bat_knots_all(size_t frames, bat_knots *out);
/* Every other inner knot of `from`. */
bat_status bat_knots_coarser(const bat_knots *from, bat_knots *out);
/* One more inner knot; BAT_KNOTS: it is there already. */
bat_status bat_knots_add(bat_knots *knots, double t);
void bat_knots_clear(bat_knots *knots);
int bat_knots_inner(const bat_knots *knots);

/* The points of the spline nearest to data[frames * size] in the least squares sense, size 3 or 4: out[count * size]. Knots
 * closer than frames are held by a little stiffness. */
bat_status bat_spline_fit(const bat_knots *knots, size_t frames, int size, const double *data, double *out);

#endif
