/* PLY as a format of drawings: one mesh, or a cloud where there are no faces. Millimetres, up is z. */
#include "format/ply/ply.h"

#include "text/json.h"

#include <string.h>

static int sniff(const char *text, size_t size) {
    return size > 3 && memcmp(text, "ply", 3) == 0 && (text[3] == '\n' || text[3] == '\r') ? 100 : 0;
}

static bat_status parse(const char *text, size_t size, bat_document *document, int *left_out,
                        bat_problem *problem) {
    static const bat_room room = {BAT_STAND_WALL, 1, false};
    bat_faces faces = {.vertices = NULL};
    bat_status status = bat_ply_parse(text, size, &faces, left_out, problem);
    if (status == BAT_OK) {
        status = bat_faces_weld(&faces);
        if (status == BAT_OK) status = bat_faces_insert(&faces, &room, "", document);
        if (status != BAT_OK) bat_problem_set(problem, status, "", bat_status_message(status));
    }
    bat_faces_clear(&faces);
    return status;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    (void)how;
    return bat_faces_read(parse, text, size, out, &report->lost.count[BAT_LOSS_UNKNOWN], problem);
}

static bat_status write(const bat_document *document, char **out, size_t *size, bat_problem *problem) {
    return bat_faces_write(document, 1, false, bat_ply_put_parts, out, size, problem);
}

const bat_format bat_format_of_ply = {"ply", "model/ply", false, sniff, read, write};
