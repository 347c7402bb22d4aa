/* STEP as a format of drawings: B-spline curves and surfaces, in millimetres, whatever the file's unit is. Up is z. */
#include "document/format.h"
#include "format/model/drawn.h"

#include <string.h>

static int sniff(const char *text, size_t size) {
    static const char head[] = "ISO-10303-21;";
    const size_t at = bat_format_start(text, size);
    return size - at >= sizeof head - 1 && memcmp(text + at, head, sizeof head - 1) == 0 ? 100 : 0;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    (void)how;
    return bat_model_open(bat_step_read, text, size, out, &report->lost.count[BAT_LOSS_UNKNOWN], problem);
}

static bat_status write(const bat_document *document, char **out, size_t *size, bat_problem *problem) {
    return bat_model_save(bat_step_write, document, out, size, problem);
}

const bat_format bat_format_of_step = {"step", "model/step", false, sniff, read, write};
