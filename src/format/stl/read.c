/* Reads STL, binary and as text. Normals are not read: the order of the corners says which side is the outer one. */
#include "format/stl/stl.h"

#include "format/model/faces.h"
#include "format/model/floats.h"
#include "text/json.h"
#include "text/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { HEADER = 84, TRIANGLE = 50, NORMAL = 12, CORNER = 12, WORD_ROOM = 12, LOOK = 4096 };

static bool is_word_within(const char *text, size_t size, const char *word) {
    const size_t length = strlen(word);
    for (size_t i = 0; i + length <= size; i++) {
        size_t k = 0;
        while (k < length && (text[i + k] | 32) == word[k]) k++;
        if (k == length) return true;
    }
    return false;
}

bool bat_stl_is_text(const char *text, size_t size) {
    const size_t at = bat_format_start(text, size), left = size - at;
    if (left < 5 || !is_word_within(text + at, 5, "solid")) return false;
    const size_t look = left < LOOK ? left : LOOK;
    return is_word_within(text + at, look, "facet") || is_word_within(text + at, look, "endsolid");
}

bool bat_stl_is_whole(const char *bytes, size_t size) {
    if (size < HEADER) return false;
    const size_t count = bat_word_at(bytes + HEADER - 4);
    return count > 0 && count == (size - HEADER) / TRIANGLE && (size - HEADER) % TRIANGLE == 0;
}

static bat_status add_triangle(bat_faces *faces, const double corners[9]) {
    bat_status status = BAT_OK;
    int at[3];
    for (int k = 0; k < 3 && status == BAT_OK; k++) {
        at[k] = (int)faces->vertex_count;
        status = bat_faces_add_vertex(faces, corners + (ptrdiff_t)3 * k);
    }
    return status == BAT_OK ? bat_faces_add(faces, at, 3) : status;
}

static const char *words_for(bat_status status) {
    if (status == BAT_NUMBER) return "expected finite numbers, found another";
    if (status == BAT_COUNT) return "expected 5592405 triangles at most, found more";
    return bat_status_message(status);
}

/* ---- binary ---- */

static bat_status parse_binary(const char *bytes, size_t size, bat_faces *out, bat_problem *problem) {
    char place[40], message[120];
    if (size < HEADER) return bat_problem_set(problem, BAT_SYNTAX, "", "expected STL, found nothing");
    const size_t count = bat_word_at(bytes + HEADER - 4), room = (size - HEADER) / TRIANGLE;
    if (count > room) {
        snprintf(message, sizeof message, "expected %zu triangles, as the header says, found %zu", count,
                 room);
        return bat_problem_set(problem, BAT_SYNTAX, "", message);
    }
    bat_status status = BAT_OK;
    for (size_t t = 0; t < count && status == BAT_OK; t++) {
        const char *from = bytes + HEADER + TRIANGLE * t + NORMAL;
        double corners[9];
        for (int k = 0; k < 9; k++) corners[k] = bat_float_at(from + (ptrdiff_t)4 * k);
        status = add_triangle(out, corners);
        if (status != BAT_OK) {
            snprintf(place, sizeof place, "triangle %zu", t + 1);
            bat_problem_set(problem, status, place, words_for(status));
        }
    }
    return status;
}

/* ---- text ---- */

typedef struct reader {
    const char *at, *end;
    long line; /* of `at`, from 1 */
    bat_problem *problem;
} reader;

static bat_status wrong(const reader *r, bat_status status, const char *message) {
    char place[40];
    snprintf(place, sizeof place, "line %ld", r->line);
    return bat_problem_set(r->problem, status, place, message);
}

static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

static void skip_blanks(reader *r) {
    for (; r->at < r->end && is_blank(*r->at); r->at++) r->line += *r->at == '\n';
}

/* The next word in lower case, cut to what known words have; false: there is none. */
static bool next_word(reader *r, char word[WORD_ROOM]) {
    size_t size = 0;
    skip_blanks(r);
    for (; r->at < r->end && !is_blank(*r->at); r->at++)
        if (size < WORD_ROOM - 1)
            word[size++] = (char)(*r->at >= 'A' && *r->at <= 'Z' ? *r->at + 32 : *r->at);
    word[size] = '\0';
    return size > 0;
}

static void skip_line(reader *r) {
    while (r->at < r->end && *r->at != '\n' && *r->at != '\r') r->at++;
}

static bat_status read_corner(reader *r, double at[3]) {
    for (int k = 0; k < 3; k++) {
        skip_blanks(r);
        const char *after = r->at < r->end ? bat_number_scan(r->at, r->end, &at[k]) : NULL;
        if (!after || (after < r->end && !is_blank(*after)))
            return wrong(r, BAT_SYNTAX, "vertex: expected three numbers, found something else");
        r->at = after;
        if (!(fabs(at[k]) <= BAT_COORDINATE_MAX)) return wrong(r, BAT_NUMBER, words_for(BAT_NUMBER));
    }
    return BAT_OK;
}

/* From behind "facet" up to "endfacet". */
static bat_status read_facet(reader *r, bat_faces *out) {
    char word[WORD_ROOM];
    double corners[9];
    int count = 0;
    bat_status status = BAT_OK;
    skip_line(r); /* the normal */
    for (;;) {
        if (!next_word(r, word)) return wrong(r, BAT_SYNTAX, "expected endfacet, found the end");
        if (strcmp(word, "endfacet") == 0) break;
        if (strcmp(word, "outer") == 0 || strcmp(word, "loop") == 0 || strcmp(word, "endloop") == 0) continue;
        if (strcmp(word, "vertex") != 0)
            return wrong(r, BAT_SYNTAX, "expected vertex or endfacet, found something else");
        if (count == 3) return wrong(r, BAT_SYNTAX, "expected three vertices in a facet, found more");
        status = read_corner(r, corners + (ptrdiff_t)3 * count++);
        if (status != BAT_OK) return status;
    }
    if (count < 3) return wrong(r, BAT_SYNTAX, "expected three vertices in a facet, found fewer");
    status = add_triangle(out, corners);
    return status == BAT_OK ? status : wrong(r, status, words_for(status));
}

static bat_status parse_text(const char *text, size_t size, bat_faces *out, bat_problem *problem) {
    const size_t start = bat_format_start(text, size);
    reader r = {text + start, text + size, 1, problem};
    char word[WORD_ROOM];
    bat_status status = BAT_OK;
    for (size_t i = 0; i < start; i++) r.line += text[i] == '\n';
    while (status == BAT_OK && next_word(&r, word)) {
        if (strcmp(word, "facet") == 0)
            status = read_facet(&r, out);
        else if (strcmp(word, "solid") == 0 || strcmp(word, "endsolid") == 0)
            skip_line(&r); /* its name */
        else
            status = wrong(&r, BAT_SYNTAX, "expected facet or endsolid, found something else");
    }
    return status;
}

bat_status bat_stl_parse(const char *bytes, size_t size, bat_faces *out, bat_problem *problem) {
    const bool text = !bat_stl_is_whole(bytes, size) && (size < HEADER || bat_stl_is_text(bytes, size));
    return text && size > 0 ? parse_text(bytes, size, out, problem) : parse_binary(bytes, size, out, problem);
}
