/* A glyph of a font as a format of drawings. */
#include "document/format.h"
#include "text/json.h"

#include <string.h>

enum { HEAD = 4096 };

/* XML whose first element is a glyph. */
static int sniff(const char *text, size_t size) {
    static const char root[] = "<glyph";
    const size_t length = sizeof root - 1;
    const size_t end = size < HEAD ? size : HEAD;
    for (size_t at = bat_format_start(text, size); at + length < end; at++) {
        if (text[at] != '<') {
            if (text[at] > ' ' && at == bat_format_start(text, size)) return 0;
            continue;
        }
        if (memcmp(text + at, root, length) == 0 && strchr(" \t\r\n>/", text[at + length])) return 95;
        if (text[at + 1] != '?' && text[at + 1] != '!') return 0;
    }
    return 0;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    if (!how->xml)
        return bat_problem_set(problem, BAT_UNSUPPORTED, "",
                               "glyphs cannot be read here: there is no XML parser");
    return how->xml(text, size, &how->svg, out, report, problem);
}

static bat_status write(const bat_document *document, char **text, size_t *size, bat_problem *problem) {
    const bat_status status = bat_glif_write(document, false, text, size);
    return status == BAT_OK
               ? status
               : bat_problem_set(problem, status, "",
                                 status == BAT_DIMENSION
                                     ? "a glyph has curves of the page, found one in space"
                                 : status == BAT_NUMBER
                                     ? "a glyph holds places and widths up to 1e9, found one further out"
                                     : bat_status_message(status));
}

const bat_format bat_format_of_glif = {"glif", "application/xml", false, sniff, read, write};
