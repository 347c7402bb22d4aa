/* The table of formats. */
#ifndef BATTEN_FORMAT_FORMATS_H
#define BATTEN_FORMAT_FORMATS_H

#include "document/format.h"

enum { BAT_FORMATS_WORDS = 128 };

/* By the ending of a file's name, in any case of letters ("a.svg"); NULL: none is called so. */
const bat_format *bat_format_called(const char *file);
/* By its own name, "svg"; NULL: there is none. */
const bat_format *bat_format_named(const char *name);
/* By what stands in the text; NULL: none of them. */
const bat_format *bat_format_sniffed(const char *text, size_t size);
/* Reads it as what its name says (format); a name of parts, such as .json, may be that of a whole document, too. NULL: as
 * what the text is. *format becomes what it was read as. */
bat_status bat_formats_read(const bat_reading *how, const char *text, size_t size, const bat_format **format,
                            bat_document **out, bat_svg_report *report, bat_problem *problem);
/* For people, with `before` before each: ".batten, .svg or .json". keeps: only those that keep whole documents. */
void bat_formats_words(const char *before, bool keeps, char words[BAT_FORMATS_WORDS]);

#endif
