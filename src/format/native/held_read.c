/* Reading what another format cannot hold (docs/format.md). */
#include "document/digest.h"
#include "document/document.h"
#include "format/json/curve.h"
#include "format/json/fields.h"
#include "format/native/held.h"
#include "format/native/native.h"
#include "text/base64.h"
#include "text/json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { VERSION = 11 }; /* of which older programs know nothing: they read the drawing */

static double number_at(const bat_json *json, uint32_t node) {
    return bat_json_type_of(json, node) == BAT_JSON_NUMBER ? json->nodes[node].value.number : -1;
}

/* A whole number from low to high; else false. */
static bool whole_at(const bat_json *json, uint32_t node, double low, double high, double *out) {
    *out = number_at(json, node);
    return bat_json_type_of(json, node) == BAT_JSON_NUMBER && *out >= low && *out <= high &&
           *out == floor(*out);
}

static uint32_t next_of(const bat_json *json, uint32_t node) { return node ? json->nodes[node].next : 0; }

/* Numbers as a list, or as base 64 of their bits, the low byte first. Freed by the caller; *count > 0. */
static bat_status read_numbers(const bat_json *json, uint32_t node, double **out, size_t *count) {
    const char *text = bat_json_text(json, node);
    if (!text) {
        const bat_status status = bat_numbers_from_json(json, node, "numbers", out, count, NULL);
        if (status != BAT_OK || *count > 0) return status;
        free(*out);
        return BAT_SYNTAX;
    }
    const size_t size = strlen(text);
    unsigned char *bytes = malloc(size + 4);
    size_t made = 0;
    if (!bytes) return BAT_MEMORY;
    bat_status status = bat_base64_read(text, size, bytes, &made);
    if (status == BAT_OK && (made % 8 != 0 || made == 0)) status = BAT_SYNTAX;
    double *numbers = status == BAT_OK ? malloc(made) : NULL;
    if (status == BAT_OK && !numbers) status = BAT_MEMORY;
    for (size_t i = 0; status == BAT_OK && i < made / 8; i++) {
        uint64_t bits = 0;
        for (int k = 7; k >= 0; k--) bits = bits << 8 | bytes[8 * i + (size_t)k];
        memcpy(&numbers[i], &bits, sizeof bits);
        if (!isfinite(numbers[i])) status = BAT_NUMBER;
    }
    free(bytes);
    if (status != BAT_OK) {
        free(numbers);
        return status;
    }
    *out = numbers;
    *count = made / 8;
    return BAT_OK;
}

/* degree, closed, knots, points, and dimension, which may be left out: 2. */
static bat_status read_whole_curve(const bat_json *json, uint32_t item, bat_redrawn *out) {
    double degree, dimension = 2, *knots = NULL, *points = NULL;
    size_t knot_count = 0, count = 0;
    if (!whole_at(json, item, 1, BAT_DEGREE_MAX, &degree)) return BAT_SYNTAX;
    item = next_of(json, item);
    const bool closed = bat_json_type_of(json, item) == BAT_JSON_TRUE;
    item = next_of(json, item);
    const uint32_t last = next_of(json, item), behind = next_of(json, last);
    if (behind && !whole_at(json, behind, 2, 3, &dimension)) return BAT_SYNTAX;
    bat_status status = read_numbers(json, item, &knots, &knot_count);
    if (status == BAT_OK) status = read_numbers(json, last, &points, &count);
    if (status == BAT_OK && (knot_count > INT32_MAX || count % (size_t)dimension)) status = BAT_COUNT;
    if (status == BAT_OK)
        status = bat_curve_create((int)dimension, (int)degree, closed, count / (size_t)dimension, points,
                                  (int)knot_count, knots, &out->curve);
    free(knots);
    free(points);
    return status;
}

/* numbers of all the points, and which they are: place, how many from there on, ... */
static bat_status read_points(const bat_json *json, uint32_t item, bat_redrawn *out) {
    bat_status status = read_numbers(json, item, &out->numbers, &out->number_count);
    if (status != BAT_OK) return status;
    out->places = malloc((out->number_count + 1) * sizeof *out->places);
    if (!out->places) return BAT_MEMORY;
    for (uint32_t at = next_of(json, item); at; at = next_of(json, next_of(json, at))) {
        double from, some;
        if (!whole_at(json, at, 0, BAT_POINTS_MAX, &from) ||
            !whole_at(json, next_of(json, at), 1, (double)(out->number_count - out->count), &some))
            return BAT_SYNTAX;
        for (int i = 0; i < (int)some; i++) out->places[out->count++] = (int)from + i;
    }
    return BAT_OK;
}

static bat_status read_curve(const bat_json *json, uint32_t node, bat_redrawn *out) {
    double at;
    const uint32_t first = bat_json_first(json, node), second = next_of(json, first);
    if (!whole_at(json, first, 0, INT32_MAX, &at)) return BAT_SYNTAX;
    out->index = (int)at;
    return bat_json_type_of(json, second) == BAT_JSON_NUMBER ? read_whole_curve(json, second, out)
                                                             : read_points(json, second, out);
}

/* [id, group, curve, ...]: an object as the drawing has it; group -1: as there. */
static bat_status read_like(const bat_json *json, uint32_t node, bat_substitute *out) {
    double id, parent;
    uint32_t item = bat_json_first(json, node);
    if (!whole_at(json, item, 1, (double)BAT_ID_MAX, &id)) return BAT_SYNTAX;
    item = next_of(json, item);
    if (!whole_at(json, item, -1, (double)BAT_ID_MAX, &parent)) return BAT_SYNTAX;
    const uint32_t count = bat_json_count(json, node) - 2;
    out->like = true;
    out->id = (bat_id)id;
    out->grouped = parent >= 0;
    out->parent = parent >= 0 ? (bat_id)parent : 0;
    if (count == 0) return BAT_OK;
    out->redrawn = calloc(count, sizeof *out->redrawn);
    if (!out->redrawn) return BAT_MEMORY;
    for (item = next_of(json, item); item; item = next_of(json, item)) {
        bat_redrawn *made = &out->redrawn[out->redrawn_count++];
        const bat_status status = read_curve(json, item, made);
        if (status != BAT_OK) return status;
        if (out->redrawn_count > 1 && made->index <= made[-1].index) return BAT_SYNTAX;
    }
    return BAT_OK;
}

static bat_status read_splice(const bat_fields *f, uint32_t node, int above, bat_substitute *out) {
    const bat_json *json = f->json;
    double at, count;
    uint32_t item = bat_json_first(json, node);
    if (!whole_at(json, item, above, INT32_MAX / 2, &at)) return BAT_SYNTAX;
    item = next_of(json, item);
    if (!whole_at(json, item, 0, INT32_MAX / 2, &count)) return BAT_SYNTAX;
    item = next_of(json, item);
    const char *digest = bat_json_text(json, item);
    item = next_of(json, item);
    out->at = (int)at;
    out->count = (int)count;
    if (!digest || (out->count > 0 && !bat_digest_scan(digest, &out->digest))) return BAT_SYNTAX;
    if (bat_json_type_of(json, item) == BAT_JSON_OBJECT) {
        const bat_status status = bat_object_from_json(json, item, f->pictures, &out->object, f->problem);
        double more;
        out->broken = status != BAT_OK;
        if (whole_at(json, next_of(json, item), 1, INT32_MAX, &more)) {
            out->grouped = out->count > 0;
            out->element = out->count > 0 ? 0 : (uint32_t)more;
        }
        return status == BAT_MEMORY ? status : BAT_OK;
    }
    if (bat_json_type_of(json, item) == BAT_JSON_LIST && out->count == 1) return read_like(json, item, out);
    return item && bat_json_type_of(json, item) == BAT_JSON_NULL && out->count > 0 ? BAT_OK : BAT_SYNTAX;
}

static bat_status read_splices(const bat_fields *f, bat_held *out) {
    const uint32_t list = bat_json_member(f->json, 1, "objects");
    out->splices = calloc((size_t)bat_json_count(f->json, list) + 1, sizeof *out->splices);
    if (!out->splices) return BAT_MEMORY;
    int above = 0;
    for (uint32_t at = bat_json_first(f->json, list); at; at = f->json->nodes[at].next) {
        bat_substitute *made = &out->splices[out->count++];
        const bat_status status = read_splice(f, at, above, made);
        if (status != BAT_OK) return status;
        above = made->at + made->count;
    }
    return BAT_OK;
}

/* [[index, more], ...] */
static bat_status read_shifts(const bat_json *json, bat_held *out) {
    const uint32_t list = bat_json_member(json, 1, "ids");
    out->shifts = malloc(((size_t)bat_json_count(json, list) + 1) * sizeof *out->shifts);
    if (!out->shifts) return BAT_MEMORY;
    double above = 0;
    for (uint32_t at = bat_json_first(json, list); at; at = json->nodes[at].next) {
        const uint32_t first = bat_json_first(json, at);
        double from, more;
        if (!whole_at(json, first, above, INT32_MAX / 2, &from) ||
            !whole_at(json, next_of(json, first), -(double)BAT_ID_MAX, (double)BAT_ID_MAX, &more))
            return BAT_SYNTAX;
        out->shifts[out->shift_count++] = (bat_id_shift){(int)from, (int64_t)more};
        above = from + 1;
    }
    return BAT_OK;
}

static bat_status read_whole(const bat_fields *f, bat_held *out) {
    const bat_json *json = f->json;
    const uint32_t named = bat_json_member(json, 1, "unit");
    bat_status status = BAT_OK;
    if (number_at(json, bat_json_member(json, 1, "batten")) != VERSION) return BAT_UNSUPPORTED;
    out->paged = bat_json_member(json, 1, "page") != 0;
    out->element_count = (uint32_t)fmax(0, number_at(json, bat_json_member(json, 1, "elements")));
    if (out->paged) status = bat_fields_numbers(f, 1, "page", 4, "x, y, width and height", out->page);
    if (status == BAT_OK) status = bat_fields_id(f, 1, "next", BAT_ID_MAX + 1, &out->next);
    if (status == BAT_OK && named) {
        const char *word = bat_json_text(json, named);
        if (!word || !bat_unit_of_word(word, &out->unit)) return BAT_SYNTAX;
        out->sized = true;
        out->scale = bat_unit_millimetres(out->unit);
        status = bat_fields_number(f, 1, "scale", 1e-12, 1e12, "millimetres from 1e-12 to 1e12", &out->scale);
    }
    return status;
}

bat_status bat_held_read(const char *text, size_t size, bat_pictures *pictures, bat_held *out) {
    bat_json json;
    bat_held made = {0};
    bat_status status = bat_json_parse(text, size, &json, NULL);
    if (status != BAT_OK) return status;
    const bat_fields f = {&json, pictures, NULL};
    status = read_whole(&f, &made);
    const uint32_t list = bat_json_member(&json, 1, "pictures");
    for (uint32_t at = bat_json_first(&json, list); at && status == BAT_OK; at = json.nodes[at].next)
        status = bat_picture_from_json(&json, at, pictures, NULL);
    if (status == BAT_OK) status = read_shifts(&json, &made);
    if (status == BAT_OK) status = read_splices(&f, &made);
    bat_json_free(&json);
    if (status == BAT_OK)
        *out = made;
    else
        bat_held_free(&made);
    return status;
}
