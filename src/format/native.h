/* The native document as text inside other formats. */
#ifndef BATTEN_SRC_NATIVE_H
#define BATTEN_SRC_NATIVE_H

#include "format/json.h"
#include "format/text.h"

#include <batten/document.h>

/* Ids in files stay below this, so that a document never runs out of them. */
#define BAT_FILE_ID_MAX (((bat_id)1 << 31) - 1)

/* One object of the document's list, and back (BAT_SYNTAX and so on, told in problem). Bit for bit. The text
 * has line ends between its parts, none inside its strings. */
void bat_object_to_json(const bat_object *object, bat_text *text);
bat_status bat_object_from_json(const bat_json *json, uint32_t node, bat_object **out, bat_problem *problem);
void bat_document_to_json(const bat_document *document, bat_text *text);

#endif
