/* Parts of the SVG reader: path data, transforms, lengths, shapes. */
#ifndef BATTEN_FORMAT_SVG_SVG_H
#define BATTEN_FORMAT_SVG_SVG_H

#include "format/svg/outline.h"

/* Adds path data to an outline. False when it breaks off: all up to the last good segment has been added, as
 * SVG 2, 9.5.4 says. */
bool bat_svg_path(const char *data, size_t size, bat_outline *outline);

/* White space, and one comma at most. */
void bat_svg_skip(const char **at, const char *end);

/* Matrices are those of base/matrix.h. */
/* A transform attribute; false, and m the identity, when it does not parse. */
bool bat_svg_transform(const char *text, double m[6]);
/* x y w h; false when it does not parse or a side is negative. */
bool bat_svg_view_box(const char *text, double box[4]);
/* Maps box into the viewport at x, y as preserveAspectRatio (may be NULL) says. */
void bat_svg_fit(const double box[4], double x, double y, double w, double h, const char *ratio, double m[6]);

/* A length in user units (px): px pt pc mm cm in Q em ex rem, % of `whole`. False when it does not parse, or
 * is not finite. em is 16. */
bool bat_svg_length(const char *text, double whole, double *value);

/* The shape of an element: looks its attributes up by name (NULL: not there). */
typedef struct bat_svg_shape {
    const char *(*attribute)(const void *element, const char *name);
    const void *element;
    double width, height; /* of the viewport, for percentages */
} bat_svg_shape;
/* name: rect circle ellipse line polyline polygon path. False when some of it had to be left out. */
bool bat_svg_shape_outline(const bat_svg_shape *shape, const char *name, bat_outline *outline);

#endif
