/* Whether a text is well-formed XML 1.0, for texts that come from elsewhere than an XML parser. */
#ifndef BATTEN_TEXT_XML_H
#define BATTEN_TEXT_XML_H

#include <batten/base.h>

/* BAT_SYNTAX: it is not. UTF-8 only; any character above U+007F may stand in a name. References to entities with markup
 * in them, to external entities and to entities that are declared later count as errors. O(size log size). */
bat_status bat_xml_check(const char *text, size_t size);

#endif
