/* What of a document in space is shown; its surfaces, shaded, as a picture of cairo. */
#ifndef BATTEN_APPS_SHADE_SHOWN_H
#define BATTEN_APPS_SHADE_SHOWN_H

#include "form/shade/shade.h"

#include <batten/document.h>
#include <cairo.h>

/* What lines and letters are measured in, pixels. */
double picture_unit(const bat_viewpoint *view);

/* As bat_shade. Returns NULL, or what went wrong (static storage). */
const char *shade_shown(const bat_document *document, const bat_viewpoint *view, bat_look look,
                        bat_shading **out);
/* The shading as a picture; NULL: no memory. */
cairo_surface_t *shading_picture(const bat_shading *shading);
/* Where colours stand for curvature: a bar of them, with the curvatures at its ends. */
void paint_legend(cairo_t *cairo, const bat_viewpoint *view, bat_look look, double range);

#endif
