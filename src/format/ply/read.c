/* Reads PLY 1.0, as text and binary: vertices and faces of any number of corners. */
#include "format/ply/ply.h"

#include "format/model/floats.h"
#include "text/json.h"
#include "text/number.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

size_t bat_ply_size(bat_ply_type type) {
    static const size_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[type];
}

double bat_ply_number(const char *bytes, bat_ply_type type, bool big_endian) {
    const size_t size = bat_ply_size(type);
    uint64_t word = 0;
    for (size_t k = 0; k < size; k++)
        word |= (uint64_t)(unsigned char)bytes[big_endian ? size - 1 - k : k] << 8 * k;
    if (type == BAT_PLY_FLOAT64) {
        double number;
        memcpy(&number, &word, sizeof number);
        return number;
    }
    if (type == BAT_PLY_FLOAT32) {
        const uint32_t half = (uint32_t)word;
        float number;
        memcpy(&number, &half, sizeof number);
        return (double)number;
    }
    const bool is_signed = type == BAT_PLY_INT8 || type == BAT_PLY_INT16 || type == BAT_PLY_INT32;
    const double all = (double)((uint64_t)1 << 8 * size), value = (double)word;
    return is_signed && value >= all / 2 ? value - all : value;
}

typedef struct reader {
    const bat_ply_header *header;
    const char *at, *end;
    bat_faces *out;
    int *left_out;
    uint64_t vertices; /* as the header says */
    int *corners;      /* of one face */
    size_t room;
    const bat_ply_element *element;
    uint64_t row;
    bat_problem *problem;
} reader;

static bat_status wrong(const reader *r, bat_status status, const char *message) {
    static const char *const names[] = {"row", "vertex", "face"};
    char place[48];
    snprintf(place, sizeof place, "%s %zu", names[r->element->role], (size_t)r->row + 1);
    return bat_problem_set(r->problem, status, place, message);
}

static bat_status next_number(reader *r, bat_ply_type type, double *value) {
    if (!r->header->text) {
        const size_t size = bat_ply_size(type);
        if ((size_t)(r->end - r->at) < size) return wrong(r, BAT_SYNTAX, "expected a number, found the end");
        *value = bat_ply_number(r->at, type, r->header->big_endian);
        r->at += size;
        return BAT_OK;
    }
    while (r->at < r->end && (unsigned char)*r->at <= ' ') r->at++;
    if (r->at == r->end) return wrong(r, BAT_SYNTAX, "expected a number, found the end");
    const char *after = bat_number_scan(r->at, r->end, value);
    if (!after || (after < r->end && (unsigned char)*after > ' '))
        return wrong(r, BAT_SYNTAX, "expected a number, found something else");
    r->at = after;
    return BAT_OK;
}

static void leave_out(reader *r, uint64_t count) {
    const int room = INT_MAX - *r->left_out;
    *r->left_out += count < (uint64_t)room ? (int)count : room;
}

/* Room for the corners of a face, of which the file has as many bytes at least. */
static bool make_room(reader *r, size_t count) {
    if (count <= r->room) return true;
    const size_t wanted = count > 2 * r->room ? count : 2 * r->room;
    int *larger = realloc(r->corners, wanted * sizeof *larger);
    if (!larger) return false;
    r->corners = larger;
    r->room = wanted;
    return true;
}

static bat_status add_face(reader *r, size_t count, bat_ply_type type) {
    if (!make_room(r, count)) return wrong(r, BAT_MEMORY, bat_status_message(BAT_MEMORY));
    for (size_t i = 0; i < count; i++) {
        double value;
        const bat_status status = next_number(r, type, &value);
        if (status != BAT_OK) return status;
        if (!(value >= 0 && value < (double)r->vertices && value <= INT_MAX && value == floor(value)))
            return wrong(r, BAT_PARAMETER, "expected the number of a vertex, found none such");
        r->corners[i] = (int)value;
    }
    if (count < 3) leave_out(r, 1);
    const bat_status status = bat_faces_add(r->out, r->corners, count);
    return status == BAT_OK ? status : wrong(r, status, "expected 16777216 faces at most, found more");
}

static bat_status read_list(reader *r, const bat_ply_property *property) {
    const size_t left = (size_t)(r->end - r->at), least = r->header->text ? 1 : bat_ply_size(property->type);
    double count, value;
    bat_status status = next_number(r, property->count, &count);
    if (status != BAT_OK) return status;
    if (!(count >= 0 && count == floor(count)))
        return wrong(r, BAT_COUNT, "expected how many numbers follow");
    if (count * (double)least > (double)left)
        return wrong(r, BAT_SYNTAX, "expected as many numbers as the list says, found the end");
    if (property->role == BAT_PLY_CORNERS) return add_face(r, (size_t)count, property->type);
    for (size_t i = 0; i < (size_t)count && status == BAT_OK; i++)
        status = next_number(r, property->type, &value);
    return status;
}

static bat_status read_row(reader *r) {
    double place[3] = {0, 0, 0}, value;
    bat_status status = BAT_OK;
    for (int i = 0; i < r->element->properties && status == BAT_OK; i++) {
        const bat_ply_property *property = &r->header->property[r->element->first + i];
        if (property->count != BAT_PLY_NONE) {
            status = read_list(r, property);
            continue;
        }
        status = next_number(r, property->type, &value);
        if (status == BAT_OK && property->role >= 0) place[property->role] = value;
    }
    if (status != BAT_OK || r->element->role != BAT_PLY_VERTEX) return status;
    status = bat_faces_add_vertex(r->out, place);
    if (status == BAT_NUMBER) return wrong(r, status, "expected finite numbers, found another");
    if (status == BAT_COUNT) return wrong(r, status, "expected 16777216 vertices at most, found more");
    return status == BAT_OK ? status : wrong(r, status, bat_status_message(status));
}

static bat_status read_rows(reader *r) {
    bat_status status = BAT_OK;
    for (int e = 0; e < r->header->elements && status == BAT_OK; e++) {
        r->element = &r->header->element[e];
        if (r->element->role == BAT_PLY_OTHER) leave_out(r, r->element->rows);
        if (r->element->properties == 0) continue; /* rows of nothing */
        for (r->row = 0; r->row < r->element->rows && status == BAT_OK; r->row++) status = read_row(r);
    }
    return status;
}

bat_status bat_ply_parse(const char *bytes, size_t size, bat_faces *out, int *left_out,
                         bat_problem *problem) {
    bat_ply_header header;
    bat_status status = bat_ply_read_header(bytes, size, &header, problem);
    if (status != BAT_OK) return status;
    reader r = {.header = &header,
                .at = bytes + header.end,
                .end = bytes + size,
                .out = out,
                .left_out = left_out,
                .problem = problem};
    for (int e = 0; e < header.elements; e++)
        if (header.element[e].role == BAT_PLY_VERTEX) r.vertices = header.element[e].rows;
    status = read_rows(&r);
    free(r.corners);
    if (status == BAT_OK && out->vertex_count == 0)
        return bat_problem_set(problem, BAT_COUNT, "", "expected a vertex, found none");
    return status;
}
