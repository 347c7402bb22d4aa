/* G-code as a format of drawings, which is written and never read: it says what a machine does, not what is drawn. */
#include "document/format.h"
#include "text/json.h"

static int sniff(const char *text, size_t size) {
    (void)text, (void)size;
    return 0;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    (void)how, (void)text, (void)size, (void)out, (void)report;
    return bat_problem_set(problem, BAT_UNSUPPORTED, "", "G-code is written, not read");
}

static bat_status write(const bat_document *document, char **text, size_t *size, bat_problem *problem) {
    const bat_status status = bat_gcode_write(document, NULL, text, size);
    if (status == BAT_OK) return BAT_OK;
    return bat_problem_set(problem, status, "",
                           status == BAT_COUNT       ? "G-code cuts curves, expected 1 at least, found none"
                           : status == BAT_DIMENSION ? "G-code cuts curves of the page, found one in space"
                           : status == BAT_NUMBER    ? "G-code holds places up to 1e7, found one further out"
                                                     : bat_status_message(status));
}

const bat_format bat_format_of_gcode = {"gcode", "text/x.gcode", false, sniff, read, write};
