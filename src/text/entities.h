/* Entities of XML: what stands for a character, or for what the document type declares. */
#ifndef BATTEN_TEXT_ENTITIES_H
#define BATTEN_TEXT_ENTITIES_H

#include "text/text.h"

/* Adds a value with its entities replaced; types: the document type, where more of them may be declared (NULL: none). False: one is
 * not known. */
bool bat_xml_decode(const char *raw, size_t size, const char *types, size_t types_size, bool attribute,
                    bat_text *out);

#endif
