/* STL as a format of drawings: its triangles are one mesh, in which corners at one place are one vertex, so that what is closed
 * is closed. Millimetres, up is z. */
#include "document/format.h"
#include "format/stl/stl.h"
#include "text/json.h"

#include <string.h>

enum { SURE = 100, LIKELY = 90, PERHAPS = 40, HEADER = 84 };

static int sniff(const char *text, size_t size) {
    if (bat_stl_is_text(text, size)) return LIKELY;
    if (bat_stl_is_whole(text, size)) return SURE;
    return size >= HEADER && memcmp(text, "solid ", 6) == 0 ? PERHAPS : 0;
}

static bat_status parse(const char *text, size_t size, bat_document *document, int *left_out,
                        bat_problem *problem) {
    static const bat_room room = {BAT_STAND_WALL, 1, false};
    bat_faces faces = {.vertices = NULL};
    (void)left_out;
    bat_status status = bat_stl_parse(text, size, &faces, problem);
    if (status == BAT_OK) {
        status = bat_faces_weld(&faces);
        if (status == BAT_OK && faces.face_count == 0) status = BAT_COUNT;
        if (status == BAT_OK) status = bat_faces_insert(&faces, &room, "", document);
        if (status != BAT_OK)
            bat_problem_set(problem, status, "",
                            status == BAT_COUNT ? "expected triangles with an area, found none"
                                                : bat_status_message(status));
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
    return bat_faces_write(document, 1, false, bat_stl_put_parts, out, size, problem);
}

const bat_format bat_format_of_stl = {"stl", "model/stl", false, sniff, read, write};
