/* Parts of the SVG reader: path data, transforms, lengths, shapes. */
#ifndef BATTEN_FORMAT_SVG_SVG_H
#define BATTEN_FORMAT_SVG_SVG_H

#include "document/sheet.h"
#include "format/svg/outline.h"

#include <batten/format.h>

/* Adds path data to an outline. False when there is an error: everything up to the last good segment has been
 * added, as in SVG 2, 9.5.4. */
bool bat_svg_path(const char *data, size_t size, bat_outline *outline);

/* Where a cubic comes from: the bytes from..to of the data. One arc may have made several. */
typedef struct bat_svg_segment {
    size_t from, to;
    char command; /* as written, or what stands for the one that is left out */
    bool implied; /* it is left out */
} bat_svg_segment;
typedef struct bat_svg_segments {
    bat_svg_segment *list; /* of each cubic of the outline, in order; freed by the caller */
    size_t count, room;
    bool failed; /* out of memory */
} bat_svg_segments;
/* The same, and where it all comes from; both are empty before. */
bool bat_svg_path_segments(const char *data, size_t size, bat_outline *outline, bat_svg_segments *segments);

/* Skips white space and at most one comma. */
void bat_svg_skip(const char **at, const char *end);

/* Matrices are as in base/matrix.h. */
/* Reads a transform attribute; when it does not parse, returns false and m is the identity. */
bool bat_svg_transform(const char *text, double m[6]);
bool bat_svg_inverse(const double m[6], double out[6]); /* false: it has none */
/* Reads x y w h; false when it does not parse or a side is negative. */
bool bat_svg_view_box(const char *text, double box[4]);
/* Maps box into the viewport at x, y according to preserveAspectRatio (may be NULL). */
void bat_svg_fit(const double box[4], double x, double y, double w, double h, const char *ratio, double m[6]);

/* How long a pixel is in the units of the page, at the size that a file's root gives it (any may be NULL). */
double bat_svg_pixel(const double page[4], const char *width, const char *height, const char *ratio);

/* How large a file says that its drawing is (draw.c). */
typedef struct bat_svg_root {
    bat_sheet sheet;
    double stretch[2]; /* where width and height do not keep the proportions of the viewBox; else 1 */
    double pixel;      /* as bat_svg_pixel */
} bat_svg_root;

enum { BAT_SVG_SIDE_ROOM = 64 };
/* Its width or height: what its style attribute says in px, mm, cm, Q, in, pt or pc, as browsers obey it; else the attribute; NULL:
 * neither. style: may be NULL; room: for what it says. */
const char *bat_svg_root_side(const char *style, size_t size, const char *name, const char *attribute,
                              char room[BAT_SVG_SIDE_ROOM]);
/* From the attributes of the root, NULL where it has none. boxed: box is its viewBox; else what width and height make. */
void bat_svg_root_read(const double box[4], bool boxed, const char *width, const char *height,
                       const char *ratio, bat_svg_root *out);

/* Reads a length into user units (px); units: px pt pc mm cm in Q em ex rem, and % of `whole`. False when it
 * does not parse or is not finite. 1 em is 16. */
bool bat_svg_length(const char *text, double whole, double *value);

/* The shape of an element: `attribute` looks up attributes by name (NULL: missing). */
typedef struct bat_svg_shape {
    const char *(*attribute)(const void *element, const char *name);
    const void *element;
    double width, height; /* of the viewport, for percentages */
} bat_svg_shape;
struct bat_markers; /* document/markers.h */
/* What is drawn of a subpath. */
typedef enum bat_svg_drawn {
    BAT_SVG_CURVE,
    BAT_SVG_DOT,    /* nothing: it stays where it begins */
    BAT_SVG_BROKEN, /* nothing: it has numbers that no curve can have */
    BAT_SVG_NO_MEMORY
} bat_svg_drawn;
/* *out is set when there is a curve. markers: of the path; NULL: none. */
bat_svg_drawn bat_svg_subpath_curve(const bat_outline *outline, int index, const bat_svg_options *options,
                                    const struct bat_markers *markers, bat_curve **out);
struct bat_primitive; /* hands/figures/primitive.h */
/* The shape that an element of that name is, in its own units. False: it is none. */
bool bat_svg_shape_primitive(const bat_svg_shape *shape, const char *name, struct bat_primitive *out);
/* name: rect circle ellipse line polyline polygon path. False when some of it had to be left out. */
bool bat_svg_shape_outline(const bat_svg_shape *shape, const char *name, bat_outline *outline);

#endif
