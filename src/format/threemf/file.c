/* 3MF as a format of drawings: a mesh for each item of the build. Up is z. */
#include "format/threemf/threemf.h"

#include <string.h>

static int sniff(const char *text, size_t size) {
    static const char archive[] = {'P', 'K', 3, 4};
    return size > sizeof archive && memcmp(text, archive, sizeof archive) == 0 ? 90 : 0;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    (void)how;
    return bat_faces_read(bat_threemf_parse, text, size, out, &report->lost.count[BAT_LOSS_UNKNOWN], problem);
}

static bat_status write(const bat_document *document, char **out, size_t *size, bat_problem *problem) {
    return bat_faces_write(document, 1, false, bat_threemf_put_parts, out, size, problem);
}

const bat_format bat_format_of_3mf = {"3mf", "model/3mf", false, sniff, read, write};
