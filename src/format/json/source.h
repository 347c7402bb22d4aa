/* The file that a document was read from, as a member of the native document. */
#ifndef BATTEN_FORMAT_JSON_SOURCE_H
#define BATTEN_FORMAT_JSON_SOURCE_H

#include "document/document.h"
#include "format/json/fields.h"
#include "text/text.h"

/* Reads the node into the document; 0: nothing to read. *left: its text is not well-formed XML, and the document has none. */
bat_status bat_source_from_json(const bat_fields *f, uint32_t node, bat_document *document, bool *left);
void bat_source_to_json(const bat_source *source, bat_text *text);

#endif
