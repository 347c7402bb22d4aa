/* SVG as a file. */
#include "document/format.h"
#include "text/json.h"

/* Text that begins with '<', or with a UTF-16 byte order mark. */
static int sniff(const char *text, size_t size) {
    size_t at = bat_format_start(text, size);
    return at < size && (text[at] == '<' || text[at] == '\xFE' || text[at] == '\xFF') ? 90 : 0;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    if (!how->xml)
        return bat_problem_set(problem, BAT_UNSUPPORTED, "",
                               "SVG cannot be read here: there is no XML parser");
    return how->xml(text, size, &how->svg, out, report, problem);
}

static bat_status write(const bat_document *document, char **text, size_t *size, bat_problem *problem) {
    bat_status status = bat_svg_write(document, true, text, size);
    return status == BAT_OK ? status : bat_problem_set(problem, status, "", bat_status_message(status));
}

const bat_format bat_format_of_svg = {"svg", "image/svg+xml", true, sniff, read, write};
