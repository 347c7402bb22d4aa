/* The table of formats. */
#ifndef BATTEN_FORMAT_FORMATS_H
#define BATTEN_FORMAT_FORMATS_H

#include "document/format.h"

enum { BAT_FORMATS_WORDS = 192 };

/* By the extension of a file name ("a.svg"), in upper or lower case; NULL: no format has it. */
const bat_format *bat_format_called(const char *file);
/* By its own name ("svg"); NULL: there is none. */
const bat_format *bat_format_named(const char *name);
/* By the content of the text; NULL: none of them. */
const bat_format *bat_format_sniffed(const char *text, size_t size);
/* Reads the text as *format, which comes from the file's name; under the name of a format for parts, such as
 * .json, there may also be a whole document. *format NULL: the format is recognised from the text. *format
 * becomes the format that was read. */
bat_status bat_formats_read(const bat_reading *how, const char *text, size_t size, const bat_format **format,
                            bat_document **out, bat_svg_report *report, bat_problem *problem);
/* A list to be shown to users, with `before` in front of each name: ".batten, .svg or .json". keeps: only the
 * formats that keep whole documents. */
void bat_formats_words(const char *before, bool keeps, char words[BAT_FORMATS_WORDS]);

#endif
