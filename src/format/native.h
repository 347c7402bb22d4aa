/* The native document as text inside other formats. */
#ifndef BATTEN_SRC_NATIVE_H
#define BATTEN_SRC_NATIVE_H

#include "format/text.h"

#include <batten/document.h>

/* Ids in files stay below this, so that a document never runs out of them. */
#define BAT_FILE_ID_MAX (((bat_id)1 << 31) - 1)

void bat_document_to_json(const bat_document *document, bat_text *text);

#endif
