/* The header of a PLY file: lines of words that say which numbers follow. */
#include "format/ply/ply.h"

#include "text/json.h"
#include "text/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WORDS = 5 };

typedef struct reader {
    const char *at, *end;
    bat_ply_header *out;
    bat_problem *problem;
    int count; /* words of the line */
    const char *word[WORDS];
    size_t size[WORDS];
} reader;

static bat_status wrong(const reader *r, bat_status status, const char *message) {
    char place[40];
    snprintf(place, sizeof place, "line %ld", r->out->lines);
    return bat_problem_set(r->problem, status, place, message);
}

/* The next line, without its end. False: there is none. */
static bool next_line(reader *r) {
    if (r->at == r->end) return false;
    const char *at = r->at;
    r->count = 0;
    while (at < r->end && *at != '\n' && *at != '\r') {
        while (at < r->end && (*at == ' ' || *at == '\t')) at++;
        const char *first = at;
        while (at < r->end && (unsigned char)*at > ' ') at++;
        if (at == first && at < r->end && *at != '\n' && *at != '\r') at++; /* a control character */
        if (r->count < WORDS && at > first)
            r->word[r->count] = first, r->size[r->count++] = (size_t)(at - first);
    }
    if (at < r->end && *at == '\r' && at + 1 < r->end && at[1] == '\n') at++;
    if (at < r->end) at++;
    r->at = at;
    r->out->lines++;
    return true;
}

static bool is(const reader *r, int word, const char *what) {
    return word < r->count && strlen(what) == r->size[word] &&
           memcmp(what, r->word[word], r->size[word]) == 0;
}

static bat_ply_type type_at(const reader *r, int word) {
    static const char *const names[][2] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                                           {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                                           {"float", "float32"}, {"double", "float64"}};
    for (int i = 0; i < 8; i++)
        if (is(r, word, names[i][0]) || is(r, word, names[i][1])) return (bat_ply_type)(BAT_PLY_INT8 + i);
    return BAT_PLY_NONE;
}

static bat_status read_format(reader *r) {
    r->out->text = is(r, 1, "ascii");
    r->out->big_endian = is(r, 1, "binary_big_endian");
    if (!r->out->text && !r->out->big_endian && !is(r, 1, "binary_little_endian"))
        return wrong(r, BAT_UNSUPPORTED, "format: expected ascii, binary_little_endian or binary_big_endian");
    return BAT_OK;
}

static bat_status read_element(reader *r) {
    double rows = -1;
    if (r->out->elements == BAT_PLY_ELEMENTS)
        return wrong(r, BAT_COUNT, "expected 32 elements at most, found more");
    if (r->count < 3 ||
        bat_number_scan(r->word[2], r->word[2] + r->size[2], &rows) != r->word[2] + r->size[2] ||
        !(rows >= 0 && rows <= 9007199254740992.0 && rows == floor(rows)))
        return wrong(r, BAT_SYNTAX, "element: expected a name and how many there are");
    r->out->element[r->out->elements++] = (bat_ply_element){is(r, 1, "vertex") ? BAT_PLY_VERTEX
                                                            : is(r, 1, "face") ? BAT_PLY_FACE
                                                                               : BAT_PLY_OTHER,
                                                            (uint64_t)rows, r->out->properties, 0};
    return BAT_OK;
}

static int role_of(const reader *r, bat_ply_role element, int word, bool list) {
    if (element == BAT_PLY_VERTEX && !list)
        return is(r, word, "x") ? 0 : is(r, word, "y") ? 1 : is(r, word, "z") ? 2 : -1;
    if (element == BAT_PLY_FACE && list && (is(r, word, "vertex_indices") || is(r, word, "vertex_index")))
        return BAT_PLY_CORNERS;
    return -1;
}

static bat_status read_property(reader *r) {
    bat_ply_header *h = r->out;
    const bool list = is(r, 1, "list");
    if (!h->elements) return wrong(r, BAT_SYNTAX, "property: expected an element before it");
    if (h->properties == BAT_PLY_PROPERTIES)
        return wrong(r, BAT_COUNT, "expected 256 properties at most, found more");
    bat_ply_element *element = &h->element[h->elements - 1];
    const bat_ply_property made = {type_at(r, list ? 3 : 1), list ? type_at(r, 2) : BAT_PLY_NONE,
                                   role_of(r, element->role, list ? 4 : 2, list)};
    if (made.type == BAT_PLY_NONE || (list && (made.count == BAT_PLY_NONE || made.count >= BAT_PLY_FLOAT32)))
        return wrong(r, BAT_SYNTAX, "property: expected a type such as float, or list uchar int");
    h->property[h->properties++] = made;
    element->properties++;
    return BAT_OK;
}

static bool has(const bat_ply_header *h, const bat_ply_element *element, int role) {
    for (int i = 0; i < element->properties; i++)
        if (h->property[element->first + i].role == role) return true;
    return false;
}

/* Vertices have places, and there is one list of them. */
static bat_status check(const reader *r) {
    const bat_ply_header *h = r->out;
    int vertices = 0;
    for (int e = 0; e < h->elements; e++) {
        const bat_ply_element *element = &h->element[e];
        if (element->role != BAT_PLY_VERTEX) continue;
        vertices++;
        if (!has(h, element, 0) || !has(h, element, 1) || !has(h, element, 2))
            return bat_problem_set(r->problem, BAT_SYNTAX, "vertex", "expected properties x, y and z");
    }
    if (vertices == 1) return BAT_OK;
    return bat_problem_set(r->problem, BAT_SYNTAX, "",
                           vertices ? "element: expected vertex once, found it twice"
                                    : "element: expected vertex, found none");
}

bat_status bat_ply_read_header(const char *text, size_t size, bat_ply_header *out, bat_problem *problem) {
    *out = (bat_ply_header){.text = false};
    reader r = {.at = text, .end = text + size, .out = out, .problem = problem};
    bool formatted = false;
    if (!next_line(&r) || !is(&r, 0, "ply") || r.word[0] != text)
        return bat_problem_set(problem, BAT_SYNTAX, "line 1", "expected ply, found something else");
    for (;;) {
        bat_status status = BAT_OK;
        if (!next_line(&r)) return wrong(&r, BAT_SYNTAX, "expected end_header, found the end");
        if (is(&r, 0, "end_header")) break;
        if (is(&r, 0, "format"))
            status = read_format(&r), formatted = true;
        else if (is(&r, 0, "element"))
            status = read_element(&r);
        else if (is(&r, 0, "property"))
            status = read_property(&r);
        else if (r.count && !is(&r, 0, "comment") && !is(&r, 0, "obj_info"))
            status = wrong(&r, BAT_SYNTAX, "expected element, property, comment or end_header");
        if (status != BAT_OK) return status;
    }
    if (!formatted) return bat_problem_set(problem, BAT_SYNTAX, "", "expected a line format, found none");
    out->end = (size_t)(r.at - text);
    return check(&r);
}
