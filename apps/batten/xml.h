/* SVG files: expat takes the XML apart, the library's reader makes a document of it. */
#ifndef BATTEN_APPS_XML_H
#define BATTEN_APPS_XML_H

#include <batten/format.h>

/* problem->place is "line L, column C" unless the reader knows better. */
bat_status xml_read_svg(const char *text, size_t size, const bat_svg_options *options, bat_document **out,
                        bat_svg_report *report, bat_problem *problem);

#endif
