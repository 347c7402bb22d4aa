/* STL as a format of drawings: its triangles are one mesh, in which corners at one place are one vertex, so that what is closed
 * is closed. Millimetres, up is z. */
#include "document/format.h"
#include "format/model/faces.h"
#include "format/model/floats.h"
#include "format/stl/stl.h"
#include "text/json.h"

#include <string.h>

enum { HEADER = 84, TRIANGLE = 50, SURE = 100, LIKELY = 90, PERHAPS = 40, LOOK = 4096 };

static bool is_word_within(const char *text, size_t size, const char *word) {
    const size_t length = strlen(word);
    for (size_t i = 0; i + length <= size; i++) {
        size_t k = 0;
        while (k < length && (text[i + k] | 32) == word[k]) k++;
        if (k == length) return true;
    }
    return false;
}

/* Binary files may begin with "solid", too: those of text go on with a facet, or end at once. */
static bool is_text(const char *text, size_t size) {
    const size_t at = bat_format_start(text, size), left = size - at;
    if (left < 5 || !is_word_within(text + at, 5, "solid")) return false;
    const size_t look = left < LOOK ? left : LOOK;
    return is_word_within(text + at, look, "facet") || is_word_within(text + at, look, "endsolid");
}

bool bat_stl_is_binary(const char *bytes, size_t size) {
    if (size < HEADER) return false;
    const size_t room = (size - HEADER) / TRIANGLE, count = bat_word_at(bytes + HEADER - 4);
    if (count == room && (size - HEADER) % TRIANGLE == 0) return true;
    return !is_text(bytes, size);
}

static int sniff(const char *text, size_t size) {
    if (is_text(text, size)) return LIKELY;
    if (size < HEADER) return 0;
    const size_t count = bat_word_at(text + HEADER - 4);
    if (count > 0 && count == (size - HEADER) / TRIANGLE && (size - HEADER) % TRIANGLE == 0) return SURE;
    return size >= HEADER && memcmp(text, "solid ", 6) == 0 ? PERHAPS : 0;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    static const bat_room room = {BAT_STAND_WALL, 1, false};
    bat_faces faces = {.vertices = NULL};
    bat_document *document = NULL;
    (void)how, (void)report;
    bat_status status = bat_stl_parse(text, size, &faces, problem);
    if (status == BAT_OK) {
        status = bat_faces_weld(&faces);
        if (status == BAT_OK && faces.face_count == 0) status = BAT_COUNT;
        if (status == BAT_OK) status = bat_faces_drawing(&document);
        if (status == BAT_OK) status = bat_faces_insert(&faces, &room, "", document);
        if (status != BAT_OK)
            bat_problem_set(problem, status, "",
                            status == BAT_COUNT ? "expected triangles with an area, found none"
                                                : bat_status_message(status));
    }
    bat_faces_clear(&faces);
    if (status == BAT_OK)
        *out = document;
    else
        bat_document_free(document);
    return status;
}

static bat_status write(const bat_document *document, char **out, size_t *size, bat_problem *problem) {
    return bat_faces_write(document, 1, false, bat_stl_put_parts, out, size, problem);
}

const bat_format bat_format_of_stl = {"stl", "model/stl", false, sniff, read, write};
