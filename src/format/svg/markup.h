/* The pieces of markup that an object is written with. */
#ifndef BATTEN_FORMAT_SVG_MARKUP_H
#define BATTEN_FORMAT_SVG_MARKUP_H

#include "document/clip.h"
#include "document/markers.h"
#include "document/paint.h"
#include "format/seen/seen.h"
#include "format/svg/cubics.h"
#include "text/text.h"

void bat_svg_write_matrix(const double m[6], bat_text *out);
/* Path data: cubic Béziers of all curves of an object, exact up to degree 3, mapped by m before (NULL: as they are).
 * precision: as of bat_svg_write_within. */
bat_status bat_svg_write_curves(bat_text *text, const bat_object *object, const double m[6],
                                double precision);
/* The same for one curve. */
bat_status bat_svg_write_curve(bat_text *text, const bat_curve *curve, const double m[6], double precision);
/* The object's pen as a matrix, and its inverse. False: the pen is round, and both are the identity. */
bool bat_svg_pen(const bat_object *object, double pen[6], double back[6]);
/* attribute: with the space before it, and up to the quote behind it: ` width="`. */
void bat_svg_write_number(bat_text *text, const char *attribute, double number);
/* A length of the root, in the unit in which the document says its size; NULL: in px, one a unit. */
void bat_svg_write_size(bat_text *text, const char *attribute, double length, const bat_document *document);
void bat_svg_write_name(bat_text *text, const char *attribute,
                        const char *name); /* nothing for an empty name */
enum { BAT_SVG_ID = 48 };
/* The element of a gradient; m: from the document's units to those where it is used. */
void bat_svg_write_gradient(bat_text *text, const bat_gradient *gradient, const double m[6], const char *id);
/* The elements of the gradients of a paint (NULL: it has none) that are used, and their ids: empty without one. */
typedef struct bat_svg_ids {
    char fill[BAT_SVG_ID], stroke[BAT_SVG_ID], clip[BAT_SVG_ID], mask[BAT_SVG_ID],
        markers[BAT_MARKER_PLACES][BAT_SVG_ID];
    bat_marker_ink inks[2]; /* where fill and stroke come from */
    bool unmarked;          /* something around it could have markers */
} bat_svg_ids;
/* Ids that begin so belong to gradients, clip paths, masks and markers. */
#define BAT_SVG_PAINT_ID "batten-paint-"
/* number: to tell the ids from those that are taken. */
bat_svg_ids bat_svg_write_gradients(bat_text *text, const bat_object *object, const double m[6], int number);
/* Path data of a clip's innermost region, mapped by m before. */
bat_status bat_svg_write_region(bat_text *text, const bat_clip *region, const double m[6]);
/* The elements of the object's clip, which is mapped by m before, and the ids of the innermost region and the innermost mask;
 * they stay as they are without one. */
bat_status bat_svg_write_clip(bat_text *text, const bat_object *object, const double m[6], int number,
                              bat_svg_ids *ids);
/* The value of stroke-dasharray. */
void bat_svg_write_dashes(bat_text *text, const bat_paint *paint, double scale);
/* The value of paint-order. */
const char *bat_svg_order(const bat_object *object);
void bat_svg_refer_clip(bat_text *text, const bat_svg_ids *ids); /* the attributes; nothing without them */
void bat_svg_write_style(bat_text *text, const bat_object *object, const bat_svg_ids *ids);
/* The same as one attribute, which overrules style sheets and says all that something around it could say otherwise. */
void bat_svg_write_style_attribute(bat_text *text, const bat_object *object, const bat_style *style,
                                   const bat_svg_ids *ids);
/* The rest of an image element after its name: placed by m, and ended. */
void bat_svg_write_picture(bat_text *text, const bat_picture *picture, const double m[6], double opacity,
                           const bat_svg_ids *ids);
/* The rest of a text's element, of which the name has been written; m: as above, of bat_object_place. */
void bat_svg_write_lettering(bat_text *text, const bat_object *object, const double m[6], double opacity,
                             const bat_svg_ids *ids);
void bat_svg_write_state(bat_text *text, const bat_object *object); /* hidden, locked */
/* Writes the lines as paths of a group, hidden ones, dashed and below the others, when `dashed`. digest (may be NULL): of
 * what a reader will find, is added to. */
bat_status bat_svg_write_seen(bat_text *text, const bat_seen_content *content, bool dashed, uint64_t *digest);

#endif
