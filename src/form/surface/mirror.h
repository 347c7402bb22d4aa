/*
 * Surfaces that mirror each other, or themselves, in an upright plane: through the axis on the page, at right angles to
 * it. The lines of one are found in the other, and a redrawn line takes its image along (docs/math/surfaces.md).
 */
#ifndef BATTEN_FORM_SURFACE_MIRROR_H
#define BATTEN_FORM_SURFACE_MIRROR_H

#include "curve/mirror.h"
#include <batten/surface.h>

/* How the parameters of a surface's image run in another surface, or in the same one: the image of its line at u is the
 * other's line at u + sum, or, where they run back, at sum - u (closed: up to whole periods). */
typedef struct bat_surface_way {
    bool swap; /* the image of a line at u is a line at v, and of one at v a line at u */
    bool back[2];
    double sum[2];
} bat_surface_way;

/* The image, control point by control point. BAT_NUMBER: a point would lie too far out. */
bat_status bat_surface_image(const bat_surface *surface, const bat_mirror *mirror, bat_surface **out);
/* Whether b is the image of a: each control point within `within` of another's image, knots equal to 1e-9 of the width,
 * forwards or backwards, u as u or as v; where closed, from any knot on. O(points), and more for nets that are nearly
 * symmetric in other ways. */
bool bat_surface_is_image(const bat_surface *a, const bat_surface *b, const bat_mirror *mirror, double within,
                          bat_surface_way *way);
/* The same of one surface; u stays u. False also for a surface that lies in the plane. */
bool bat_surface_is_own_image(const bat_surface *surface, const bat_mirror *mirror, double within,
                              bat_surface_way *way);
/* The line's parameter in `other`, within its domain; *direction becomes the direction there. */
double bat_surface_way_line(const bat_surface_way *way, const bat_surface *other, bat_direction *direction,
                            double at);
/* The same of a stretch of a direction, ascending; closed: as far from the domain as it was. */
void bat_surface_way_range(const bat_surface_way *way, const bat_surface *other, bat_direction *direction,
                           const double range[2], double out[2]);
/* The image of `now` with its parameters run that way. Where `now` has the knots and a point of `was`, bit for bit, and
 * `other` has as many points, the point stays as `other` has it. other: the image of `was` that way. */
bat_status bat_surface_follow_image(const bat_surface *was, const bat_surface *now, const bat_surface *other,
                                    const bat_mirror *mirror, const bat_surface_way *way, bat_surface **out);

/*
 * A line of a surface that is its own image that way has been redrawn, which made `after` of `before`: the surface on
 * which the line's image is redrawn, too. Both lines are exact, and the surface is its own image again.
 * - The line is another than its image: both are solved for at once.
 * - It is its own image, running back: the side of the plane on which more has moved decides for both.
 * - It lies in the plane: it stays there.
 * *gain: how much farther the surface moves than the line, as in bat_surface_redraw. BAT_FAR: over 4 times, as the two
 * lines are too near to each other to part. O(points).
 */
bat_status bat_surface_redraw_image(const bat_surface *before, const bat_surface *after,
                                    const bat_mirror *mirror, const bat_surface_way *way,
                                    bat_direction direction, double at, double *gain, bat_surface **out);

/* Where control point i of a goes that way in direction d: to `shift` + i, or, running back, `shift` - i. */
bool bat_surface_way_shift(const bat_surface_way *way, const bat_surface *a, const bat_surface *b, int d,
                           double same, int *shift);
int bat_surface_way_index(const bat_surface_way *way, int d, int shift, const bat_surface *a, int i);

#endif
