/* IGES as a format of drawings: B-spline curves and surfaces, in millimetres, whatever the file's unit is. Up is z. */
#include "document/format.h"
#include "format/model/drawn.h"

#include <string.h>

/* Lines of 80 columns, the first of which is number 1 of the section S. */
static int sniff(const char *text, size_t size) {
    enum { LETTER = 72, LINE = 80 };
    if (size < LINE || text[LETTER] != 'S' || text[LINE - 1] != '1') return 0;
    for (int i = LETTER + 1; i < LINE - 1; i++)
        if (text[i] != ' ' && text[i] != '0') return 0;
    return memchr(text, '\n', LINE) ? 0 : 95;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    (void)how;
    return bat_model_open(bat_iges_read, text, size, out, &report->lost.count[BAT_LOSS_UNKNOWN], problem);
}

static bat_status write(const bat_document *document, char **out, size_t *size, bat_problem *problem) {
    return bat_model_save(bat_iges_write, document, out, size, problem);
}

const bat_format bat_format_of_iges = {"iges", "model/iges", false, sniff, read, write};
