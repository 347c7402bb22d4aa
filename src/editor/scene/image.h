/* The image of a curve under a map to drawing coordinates (editor/view/view.h). In perspective it is rational: it is
 * covered by cubics that have its ends and derivatives and are within a tolerance of it. What is behind the eye has no
 * image. */
#ifndef BATTEN_EDITOR_SCENE_IMAGE_H
#define BATTEN_EDITOR_SCENE_IMAGE_H

#include <batten/curve.h>

/* A piece of the image, over the stretch of the curve from u[0] to u[1]: four points; NULL: it is behind the eye. */
typedef void bat_image_piece(void *host, const double u[2], const double cubic[8]);

/* Hands over the pieces in order. tolerance: drawing coordinates, above 0. BAT_MEMORY. */
bat_status bat_image_walk(const bat_curve *curve, const double *map, double tolerance, bat_image_piece *piece,
                          void *host);
/* The image as a curve in the plane at the same parameters; stretches behind the eye are led round far away. BAT_NUMBER:
 * all of it is, or the image is too large. */
bat_status bat_image_create(const bat_curve *curve, const double *map, double tolerance, bat_curve **out);

#endif
