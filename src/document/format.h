/* A file format: what the rest of the library needs to know of it. Each has a folder in format/ and a row in
 * format/formats.def. */
#ifndef BATTEN_DOCUMENT_FORMAT_H
#define BATTEN_DOCUMENT_FORMAT_H

#include <batten/format.h>

/* What the host provides to a reader. */
typedef struct bat_reading {
    bat_svg_options svg;
    /* Parses XML for bat_svg_reader. NULL: the host has no parser, and SVG is BAT_UNSUPPORTED. */
    bat_status (*xml)(const char *text, size_t size, const bat_svg_options *options, bat_document **out,
                      bat_svg_report *report, bat_problem *problem);
} bat_reading;

typedef struct bat_format {
    const char *name; /* also the extension of its files, without the dot */
    const char *media_type;
    bool keeps; /* it keeps whole documents: what is written is read back unchanged */
    /* How certain it is, 0 to 100, that the text is in this format. The text may begin with a byte order mark. */
    int (*sniff)(const char *text, size_t size);
    /* *report: what was left out; zeros for formats that cannot hold more than a document. */
    bat_status (*read)(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem);
    /* The caller frees *text with bat_free. When the format cannot hold the document, `problem` says so. */
    bat_status (*write)(const bat_document *document, char **text, size_t *size, bat_problem *problem);
} bat_format;

/* Offset of the first character after a byte order mark and white space. */
static inline size_t bat_format_start(const char *text, size_t size) {
    size_t at = size >= 3 && text[0] == '\xEF' && text[1] == '\xBB' && text[2] == '\xBF' ? 3 : 0;
    while (at < size && (text[at] == ' ' || text[at] == '\t' || text[at] == '\r' || text[at] == '\n')) at++;
    return at;
}

#endif
