/* A picture in the document: reference-counted, and identified by a digest of its bytes. */
#ifndef BATTEN_SRC_PICTURE_H
#define BATTEN_SRC_PICTURE_H

#include <batten/document.h>

/* Reads width and height in pixels from the header of a PNG, JPEG or WebP file, or of an SVG file that stands alone, as the picture is meant to be
 * seen (a JPEG's Exif data may rotate it). Returns the file's media type, or NULL: none of the three, or a
 * broken header. Reads nothing beyond size; O(size) for JPEG, else O(1). PNG 3rd edition 11.2.1; ITU-T T.81
 * B.2.2; RFC 9649; Exif 2.32. */
const char *bat_picture_head(const unsigned char *bytes, size_t size, uint32_t *width, uint32_t *height);

/* How the pixels of a JPEG file lie, 1 to 8 as in its Exif data (Exif 2.32, 4.6.4 A); 1: as they are meant to be seen, as those of
 * all other kinds. */
uint32_t bat_picture_turn(const unsigned char *bytes, size_t size);

/* Whether it is an SVG file that stands alone, which begins with exactly
 * <svg xmlns="http://www.w3.org/2000/svg" width="W" height="H" viewBox="..."> and whole numbers W and H of pixels. */
bool bat_picture_is_drawing(const bat_picture *picture);

/* The start tag of such a file, of that size in pixels and with that viewBox; or one that shows a box (low x, low y, high x, high
 * y) with about 512 pixels along its longer side, which are a power of two of units: the box grows by less than one pixel. False:
 * the box is empty or too large. */
struct bat_text;
void bat_drawing_head(const double sides[2], const double view[4], struct bat_text *out);
bool bat_drawing_open(const double box[4], struct bat_text *out);
/* Of such a file: from its pixels to the units of its viewBox. */
bool bat_drawing_matrix(const bat_picture *picture, double m[6]);
/* The size of one for a box of that size: about so many pixels, of these proportions as far as pixels are whole. */
void bat_drawing_sides(double width, double height, uint32_t sides[2]);

/* The pictures of an object: its own, those of its patterns, and those of its masks, the innermost first; NULL: it has none
 * there. */
enum { BAT_OBJECT_PICTURES = 3 + 16 };
const bat_picture *bat_object_picture_at(const bat_object *object, int index);

/* A set of pictures. All zeros: empty. */
typedef struct bat_pictures {
    bat_picture **list; /* retained */
    int count, room;
    size_t size; /* of their bytes */
} bat_pictures;

void bat_pictures_free(bat_pictures *pictures);
const bat_picture *bat_pictures_find(const bat_pictures *pictures, uint64_t digest); /* NULL: not there */
/* Adds a picture; one that is already there changes nothing. BAT_COUNT: they would exceed BAT_PICTURES_SIZE in
 * all. BAT_ARGUMENT: a different picture has the same digest. On failure nothing changes. */
bat_status bat_pictures_add(bat_pictures *pictures, const bat_picture *picture);
void bat_pictures_drop(bat_pictures *pictures); /* removes the picture added last */

/* Decodes a picture; white space is skipped, as in data URIs of several lines. BAT_SYNTAX: the text is not
 * base 64, or not padded; otherwise the statuses of bat_picture_create. */
bat_status bat_picture_from_base64(const char *text, size_t size, bat_picture **out);

#endif
