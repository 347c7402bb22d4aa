/* The native document as text within other formats. */
#ifndef BATTEN_FORMAT_NATIVE_NATIVE_H
#define BATTEN_FORMAT_NATIVE_NATIVE_H

#include "document/picture.h"
#include "text/json.h"
#include "text/text.h"

#include <batten/format.h>

#include <batten/document.h>

/* Writes one object of the document's list; the next call reads it back, bit for bit (BAT_SYNTAX and so on,
 * explained in problem). The text has line ends between its parts, but none inside its strings. */
void bat_object_to_json(const bat_object *object, bat_text *text);
/* An image refers to its picture, which must be in `pictures`. */
bat_status bat_object_from_json(const bat_json *json, uint32_t node, const bat_pictures *pictures,
                                bat_object **out, bat_problem *problem);
/* {"picture":digest,"data":base 64}; the reader adds it to the pictures. */
void bat_picture_to_json(const bat_picture *picture, bat_text *text);
bat_status bat_picture_from_json(const bat_json *json, uint32_t node, bat_pictures *pictures,
                                 bat_problem *problem);
/* pictures: also writes the bytes of the pictures that images refer to (when these are more than a reader accepts, the
 * text fails), and the file that the document was read from. */
void bat_document_to_json(const bat_document *document, bool pictures, bat_text *text);
/* Like bat_document_read, given pictures that are known already; those of the document are added to them. *left, unless
 * NULL: whether the text of an SVG file was left out, since it is not well-formed XML. */
bat_status bat_document_read_with(const char *text, size_t size, bat_pictures *pictures, bat_document **out,
                                  bool *left, bat_problem *problem);

#endif
