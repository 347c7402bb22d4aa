/* A file format: what the rest needs to know of it. format/ has a folder for each, format/formats.def a row. */
#ifndef BATTEN_DOCUMENT_FORMAT_H
#define BATTEN_DOCUMENT_FORMAT_H

#include <batten/format.h>

/* What a reader is lent by its host. */
typedef struct bat_reading {
    bat_svg_options svg;
    /* Takes XML apart for bat_svg_reader. NULL: the host has no parser, and SVG is BAT_UNSUPPORTED. */
    bat_status (*xml)(const char *text, size_t size, const bat_svg_options *options, bat_document **out,
                      bat_svg_report *report, bat_problem *problem);
} bat_reading;

typedef struct bat_format {
    const char *name; /* and the ending of its files, after a dot */
    const char *media_type;
    bool keeps; /* whole documents: what is written is read back as it was */
    /* 0 to 100: how sure it is that this is such a file. The text may begin with a byte order mark. */
    int (*sniff)(const char *text, size_t size);
    /* *report: what was left out; zeros where formats cannot hold more than a document. */
    bat_status (*read)(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem);
    /* bat_free(*text). A document that the format cannot hold: told in problem. */
    bat_status (*write)(const bat_document *document, char **text, size_t *size, bat_problem *problem);
} bat_format;

/* Where the text begins, after a byte order mark and white space. */
static inline size_t bat_format_start(const char *text, size_t size) {
    size_t at = size >= 3 && text[0] == '\xEF' && text[1] == '\xBB' && text[2] == '\xBF' ? 3 : 0;
    while (at < size && (text[at] == ' ' || text[at] == '\t' || text[at] == '\r' || text[at] == '\n')) at++;
    return at;
}

#endif
