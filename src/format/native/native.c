/* The native document: {"batten":1, "page":[...], "next":4, "objects":[...]} (docs/format.md). */
#include "format/native/native.h"

#include "document/digest.h"
#include "document/document.h"
#include "text/base64.h"
#include "format/json/curve.h"
#include "text/json.h"
#include "format/json/shape.h"
#include "format/json/spline.h"

#include <batten/bezier.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const caps[] = {"butt", "round", "square"};
static const char *const joins[] = {"miter", "round", "bevel"};

typedef struct reader {
    const bat_json *json;
    const bat_pictures *pictures; /* what images may name */
    bat_problem *problem;
} reader;

static bat_status complain(const reader *r, uint32_t node, const char *what, const char *expected) {
    return bat_json_complain(r->json, node, BAT_SYNTAX, what, expected, r->problem);
}

/* Members that may be left out keep what *value holds. */
static bat_status read_number(const reader *r, uint32_t object, const char *name, double low, double high,
                              const char *expected, double *value) {
    uint32_t node = bat_json_member(r->json, object, name);
    if (!node) return BAT_OK;
    double number = r->json->nodes[node].value.number;
    if (bat_json_type_of(r->json, node) != BAT_JSON_NUMBER || !(number >= low && number <= high))
        return complain(r, node, name, expected);
    *value = number;
    return BAT_OK;
}

/* A whole number from 1 to high; a member that may be left out keeps what *id holds. */
static bat_status read_id(const reader *r, uint32_t object, const char *name, bat_id high, bat_id *id) {
    char expected[48];
    double number = (double)*id;
    snprintf(expected, sizeof expected, "a whole number from 1 to %lu", (unsigned long)high);
    bat_status status = read_number(r, object, name, 1, (double)high, expected, &number);
    if (status == BAT_OK && number != floor(number))
        status = complain(r, bat_json_member(r->json, object, name), name, expected);
    if (status == BAT_OK) *id = (bat_id)number;
    return status;
}

static bat_status read_flag(const reader *r, uint32_t object, const char *name, bool *value) {
    uint32_t node = bat_json_member(r->json, object, name);
    if (!node) return BAT_OK;
    bat_json_type type = bat_json_type_of(r->json, node);
    if (type != BAT_JSON_TRUE && type != BAT_JSON_FALSE) return complain(r, node, name, "true or false");
    *value = type == BAT_JSON_TRUE;
    return BAT_OK;
}

static bat_status read_colour(const reader *r, uint32_t object, const char *name, uint32_t *value) {
    uint32_t node = bat_json_member(r->json, object, name), colour = 0;
    if (!node) return BAT_OK;
    const char *text = bat_json_text(r->json, node);
    bool good = text && text[0] == '#' && strlen(text) == 9;
    for (int i = 1; good && i < 9; i++) {
        char c = text[i];
        int digit = c >= '0' && c <= '9'   ? c - '0'
                    : c >= 'a' && c <= 'f' ? c - 'a' + 10
                    : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                           : -1;
        good = digit >= 0;
        colour = colour << 4 | (uint32_t)(digit & 15);
    }
    if (!good) return complain(r, node, name, "a colour \"#rrggbbaa\"");
    *value = colour;
    return BAT_OK;
}

static bat_status read_choice(const reader *r, uint32_t object, const char *name, const char *const words[3],
                              const char *expected, int *value) {
    uint32_t node = bat_json_member(r->json, object, name);
    if (!node) return BAT_OK;
    const char *text = bat_json_text(r->json, node);
    for (int i = 0; text && i < 3; i++)
        if (strcmp(text, words[i]) == 0) {
            *value = i;
            return BAT_OK;
        }
    return complain(r, node, name, expected);
}

static bat_status read_style(const reader *r, uint32_t node, bat_style *style) {
    if (!node) return BAT_OK;
    if (bat_json_type_of(r->json, node) != BAT_JSON_OBJECT) return complain(r, node, "style", "an object");
    int cap = (int)style->cap, join = (int)style->join;
    bat_status status = read_flag(r, node, "stroked", &style->stroked);
    if (status == BAT_OK) status = read_flag(r, node, "filled", &style->filled);
    if (status == BAT_OK) status = read_flag(r, node, "even_odd", &style->even_odd);
    if (status == BAT_OK) status = read_colour(r, node, "stroke", &style->stroke);
    if (status == BAT_OK) status = read_colour(r, node, "fill", &style->fill);
    if (status == BAT_OK)
        status = read_number(r, node, "width", 0, BAT_COORDINATE_MAX, "a number from 0", &style->width);
    if (status == BAT_OK)
        status = read_number(r, node, "opacity", 0, 1, "a number from 0 to 1", &style->opacity);
    if (status == BAT_OK)
        status = read_number(r, node, "miter_limit", 1, BAT_COORDINATE_MAX, "a number from 1",
                             &style->miter_limit);
    if (status == BAT_OK) status = read_choice(r, node, "cap", caps, "butt, round or square", &cap);
    if (status == BAT_OK) status = read_choice(r, node, "join", joins, "miter, round or bevel", &join);
    style->cap = (bat_cap)cap, style->join = (bat_join)join;
    return status;
}

/* One of an object's curves, with levels or without. */
typedef struct making {
    bat_curve *curve;
    bat_shape *shape; /* owned beside its finest curve; NULL: none */
} making;

static bat_status read_making(const reader *r, uint32_t node, making *out) {
    if (!bat_json_member(r->json, node, "base"))
        return bat_curve_from_json(r->json, node, &out->curve, r->problem);
    bat_status status = bat_shape_from_json(r->json, node, &out->shape, r->problem);
    if (status != BAT_OK) return status;
    status = bat_curve_copy(bat_shape_curve(out->shape, bat_shape_levels(out->shape)), &out->curve);
    return status == BAT_OK ? status
                            : bat_json_say(r->json, node, status, bat_status_message(status), r->problem);
}

static bat_status read_makings(const reader *r, uint32_t list, making *makings, int *count) {
    for (uint32_t at = bat_json_first(r->json, list); at; at = r->json->nodes[at].next) {
        bat_status status = read_making(r, at, &makings[(*count)++]);
        if (status != BAT_OK) return status;
        if (bat_curve_dimension(makings[*count - 1].curve) != bat_curve_dimension(makings[0].curve))
            return bat_json_say(r->json, at, BAT_DIMENSION, "curves: expected one dimension, found two",
                                r->problem);
    }
    return BAT_OK;
}

/* The path of the curves, then each shape in its place; what is used up is taken out of `makings`. */
static bat_status make_path(bat_id id, const char *name, const bat_style *style, int count, making *makings,
                            bat_object **out) {
    bat_curve **curves = malloc((size_t)count * sizeof *curves);
    bat_object *object = NULL;
    if (!curves) return BAT_MEMORY;
    for (int i = 0; i < count; i++) curves[i] = makings[i].curve;
    bat_status status = bat_object_create_path(id, name, style, count, curves, &object);
    free(curves);
    if (status != BAT_OK) return status;
    for (int i = 0; i < count; i++) makings[i].curve = NULL;
    for (int i = 0; i < count && status == BAT_OK; i++) {
        bat_object *next = NULL;
        if (!makings[i].shape) continue;
        status = bat_object_with_shape(object, i, makings[i].shape, &next);
        if (status != BAT_OK) break;
        makings[i].shape = NULL;
        bat_object_release(object);
        object = next;
    }
    if (status != BAT_OK)
        bat_object_release(object);
    else
        *out = object;
    return status;
}

static bat_status read_path(const reader *r, uint32_t node, bat_id id, const char *name,
                            const bat_style *style, bool shape, bat_object **out) {
    const bat_json *json = r->json;
    uint32_t list = bat_json_member(json, node, "curves");
    uint32_t room = bat_json_count(json, list);
    if (room == 0) return complain(r, list ? list : node, "curves", "a list of at least one curve");
    making *makings = calloc(room, sizeof *makings);
    if (!makings) return bat_json_say(json, node, BAT_MEMORY, bat_status_message(BAT_MEMORY), r->problem);
    int count = 0;
    bool any = false;
    bat_status status = read_makings(r, list, makings, &count);
    for (int i = 0; i < count; i++) any = any || makings[i].shape;
    if (status == BAT_OK && any != shape)
        status = complain(r, list, "curves",
                          shape ? "one with a base and levels" : "no base and levels, which are of a shape");
    else if (status == BAT_OK) {
        status = make_path(id, name, style, count, makings, out);
        if (status != BAT_OK) bat_json_say(json, node, status, bat_status_message(status), r->problem);
    }
    for (int i = 0; i < count; i++) {
        bat_curve_free(makings[i].curve);
        bat_shape_free(makings[i].shape);
    }
    free(makings);
    return status;
}

static bat_status read_spline_object(const reader *r, uint32_t node, bat_id id, const char *name,
                                     const bat_style *style, bat_object **out) {
    uint32_t member = bat_json_member(r->json, node, "spline");
    if (!member) return complain(r, node, "spline", "an object");
    bat_tangents_options options = bat_tangents_defaults();
    bat_spline spline;
    void *block = NULL;
    bat_status status = bat_spline_from_json(r->json, member, &spline, &block, &options, r->problem);
    if (status != BAT_OK) return status;
    status = bat_object_create_spline(id, name, style, &spline, &options, out);
    bat_free(block);
    if (status == BAT_OK) return BAT_OK;
    return bat_json_say(r->json, member, status,
                        status == BAT_COUNT ? "spline: expected two different points at least, found fewer"
                                            : bat_status_message(status),
                        r->problem);
}

static bat_status read_image(const reader *r, uint32_t node, bat_id id, const char *name, bat_object **out) {
    uint32_t named = bat_json_member(r->json, node, "picture"),
             list = bat_json_member(r->json, node, "matrix");
    const char *word = bat_json_text(r->json, named);
    uint64_t digest;
    const bat_picture *picture = word && bat_digest_scan(word, &digest)
                                     ? bat_pictures_find(r->pictures, digest)
                                     : NULL;
    if (!picture) return complain(r, named ? named : node, "picture", "the digest of one of the pictures");
    double opacity = 1, *matrix;
    size_t count;
    bat_status status = read_number(r, node, "opacity", 0, 1, "a number from 0 to 1", &opacity);
    if (status != BAT_OK) return status;
    if (!list) return complain(r, node, "matrix", "six numbers");
    status = bat_numbers_from_json(r->json, list, "matrix", &matrix, &count, r->problem);
    if (status != BAT_OK) return status;
    status = count == 6 ? bat_object_create_image(id, name, picture, matrix, opacity, out) : BAT_COUNT;
    free(matrix);
    if (status == BAT_MEMORY)
        return bat_json_say(r->json, list, status, bat_status_message(status), r->problem);
    return status == BAT_OK ? status
                            : bat_json_complain(r->json, list, status, "matrix",
                                                "six numbers that do not flatten", r->problem);
}

/* `made` takes the object's place, or what went wrong is told (fault NULL: in the words of the status). */
static bat_status exchange(const reader *r, uint32_t node, bat_status status, const char *fault,
                           bat_object *made, bat_object **object) {
    if (status != BAT_OK)
        return bat_json_say(r->json, node, status, fault ? fault : bat_status_message(status), r->problem);
    bat_object_release(*object);
    *object = made;
    return BAT_OK;
}

/* Name, where it is not given at once, group, visibility and lock; takes `object` over. */
static bat_status place_object(const reader *r, uint32_t node, const char *name, bat_object *object,
                               bat_object **out) {
    bat_id parent = 0;
    bool hidden = false, locked = false;
    bat_object *placed = NULL;
    bat_status status = read_id(r, node, "parent", BAT_ID_MAX, &parent);
    if (status == BAT_OK) status = read_flag(r, node, "hidden", &hidden);
    if (status == BAT_OK) status = read_flag(r, node, "locked", &locked);
    if (status == BAT_OK && strcmp(name, bat_object_name(object)) != 0) {
        status = bat_object_with_name(object, name, &placed);
        status = exchange(r, node, status, NULL, placed, &object);
    }
    if (status == BAT_OK && parent > 0) {
        status = bat_object_with_parent(object, parent, &placed);
        status = exchange(r, node, status, "parent: not itself", placed, &object);
    }
    if (status == BAT_OK && (hidden || locked)) {
        status = bat_object_with_state(object, hidden, locked, &placed);
        status = exchange(r, node, status, NULL, placed, &object);
    }
    if (status != BAT_OK)
        bat_object_release(object);
    else
        *out = object;
    return status;
}

static bat_status read_guide(const reader *r, uint32_t node, bat_id id, bat_object **out) {
    int axis = bat_json_member(r->json, node, "x") ? 0 : 1;
    double at = NAN;
    bat_status status = read_number(r, node, axis ? "y" : "x", -BAT_COORDINATE_MAX, BAT_COORDINATE_MAX,
                                    "a number", &at);
    if (status != BAT_OK) return status;
    if (isnan(at)) return complain(r, node, "guide", "x or y");
    status = bat_object_create_guide(id, axis, at, out);
    return status == BAT_OK ? status
                            : bat_json_say(r->json, node, status, bat_status_message(status), r->problem);
}

static bat_status read_object(const reader *r, uint32_t node, bat_object **out) {
    const bat_json *json = r->json;
    if (bat_json_type_of(json, node) != BAT_JSON_OBJECT) return complain(r, node, "objects", "an object");
    uint32_t kind = bat_json_member(json, node, "kind");
    const char *word = bat_json_text(json, kind);
    if (!word) return complain(r, kind ? kind : node, "kind", "a text");
    bool group = strcmp(word, "group") == 0 || strcmp(word, "layer") == 0;
    bool shape = strcmp(word, "shape") == 0, image = strcmp(word, "image") == 0;
    bool guide = strcmp(word, "guide") == 0;
    if (strcmp(word, "path") != 0 && strcmp(word, "spline") != 0 && !shape && !image && !guide && !group)
        return bat_json_complain(
            json, kind, BAT_UNSUPPORTED, "kind",
            "\"path\", \"spline\", \"shape\", \"image\", \"guide\", \"group\" or \"layer\"", r->problem);
    bat_id id = 0;
    bat_status status = read_id(r, node, "id", BAT_ID_MAX, &id);
    if (status != BAT_OK) return status;
    if (id == 0) return complain(r, node, "id", "a whole number");
    uint32_t named = bat_json_member(json, node, "name");
    const char *name = named ? bat_json_text(json, named) : "";
    if (!name) return complain(r, named, "name", "a text");
    bat_style style = bat_style_defaults();
    status = read_style(r, bat_json_member(json, node, "style"), &style);
    if (status != BAT_OK) return status;
    bat_object *object = NULL;
    if (group) {
        status = bat_object_create_group(id, name, word[0] == 'l', &object);
        if (status != BAT_OK) bat_json_say(json, node, status, bat_status_message(status), r->problem);
    } else if (image) {
        status = read_image(r, node, id, name, &object);
    } else if (guide) {
        status = read_guide(r, node, id, &object);
    } else if (strcmp(word, "spline") == 0) {
        status = read_spline_object(r, node, id, name, &style, &object);
    } else {
        status = read_path(r, node, id, name, &style, shape, &object);
    }
    return status == BAT_OK ? place_object(r, node, name, object, out) : status;
}

bat_status bat_object_from_json(const bat_json *json, uint32_t node, const bat_pictures *pictures,
                                bat_object **out, bat_problem *problem) {
    return read_object(&(reader){json, pictures, problem}, node, out);
}

bat_status bat_picture_from_json(const bat_json *json, uint32_t node, bat_pictures *pictures,
                                 bat_problem *problem) {
    uint32_t named = bat_json_member(json, node, "picture"), data = bat_json_member(json, node, "data");
    const char *word = bat_json_text(json, named), *text = bat_json_text(json, data);
    uint64_t digest;
    bat_picture *picture = NULL;
    if (!word || !bat_digest_scan(word, &digest))
        return bat_json_complain(json, named ? named : node, BAT_SYNTAX, "picture", "16 hexadecimal digits",
                                 problem);
    if (!text) return bat_json_complain(json, data ? data : node, BAT_SYNTAX, "data", "a text", problem);
    bat_status status = bat_picture_from_base64(text, strlen(text), &picture);
    if (status == BAT_OK && bat_picture_digest(picture) != digest) status = BAT_ARGUMENT;
    if (status == BAT_OK) status = bat_pictures_add(pictures, picture);
    bat_picture_release(picture);
    if (status == BAT_OK) return status;
    return bat_json_say(json, data, status,
                        status == BAT_SYNTAX        ? "data: expected base 64, padded, found something else"
                        : status == BAT_UNSUPPORTED ? "data: expected a PNG, JPEG or WebP file, found none"
                        : status == BAT_COUNT       ? "data: expected 16 MB at most, 32 MB in all, found more"
                        : status == BAT_ARGUMENT ? "picture: expected the digest of the data, found another"
                                                 : bat_status_message(status),
                        problem);
}

static bat_status read_objects(const reader *r, uint32_t list, bat_document *document) {
    if (bat_json_type_of(r->json, list) != BAT_JSON_LIST)
        return complain(r, list ? list : 1, "objects", "a list");
    uint32_t room = bat_json_count(r->json, list);
    bat_object **objects = malloc(((size_t)room + 1) * sizeof *objects);
    if (!objects) return bat_json_say(r->json, list, BAT_MEMORY, bat_status_message(BAT_MEMORY), r->problem);
    int count = 0;
    bat_status status = BAT_OK;
    for (uint32_t at = bat_json_first(r->json, list); at && status == BAT_OK; at = r->json->nodes[at].next) {
        status = read_object(r, at, &objects[count]);
        if (status == BAT_OK) count++;
    }
    if (status == BAT_OK) {
        status = bat_document_fill(document, count, objects);
        if (status != BAT_OK)
            bat_json_say(r->json, list, status,
                         status == BAT_ARGUMENT ? "objects: expected different ids, found one twice"
                                                : bat_status_message(status),
                         r->problem);
    }
    if (status != BAT_OK)
        while (count > 0) bat_object_release(objects[--count]);
    free(objects);
    const char *wrong = status == BAT_OK ? bat_document_check_nesting(document) : NULL;
    if (wrong) status = bat_json_say(r->json, list, BAT_ARGUMENT, wrong, r->problem);
    return status;
}

static bat_status read_page(const reader *r, uint32_t list, bat_document *document) {
    if (!list) return BAT_OK;
    double *page;
    size_t count;
    bat_status status = bat_numbers_from_json(r->json, list, "page", &page, &count, r->problem);
    if (status != BAT_OK) return status;
    status = count == 4 ? bat_document_set_page(document, page) : BAT_COUNT;
    free(page);
    if (status == BAT_OK) return BAT_OK;
    return bat_json_complain(r->json, list, status, "page",
                             "x, y, width and height, none of them negative width or height", r->problem);
}

/* The document's own pictures, besides those known. */
static bat_status read_pictures(const reader *r, uint32_t list, bat_pictures *pictures) {
    bat_status status = BAT_OK;
    if (list && bat_json_type_of(r->json, list) != BAT_JSON_LIST)
        return complain(r, list, "pictures", "a list");
    for (uint32_t at = bat_json_first(r->json, list); at && status == BAT_OK; at = r->json->nodes[at].next)
        status = bat_picture_from_json(r->json, at, pictures, r->problem);
    return status;
}

static bat_status read_document(const reader *r, bat_document *document) {
    uint32_t version = bat_json_member(r->json, 1, "batten");
    if (bat_json_type_of(r->json, version) != BAT_JSON_NUMBER)
        return complain(r, version ? version : 1, "batten", "the version of the format, a number");
    if (r->json->nodes[version].value.number != 1)
        return bat_json_complain(r->json, version, BAT_UNSUPPORTED, "batten", "version 1", r->problem);
    bat_id next = 0;
    bat_status status = read_page(r, bat_json_member(r->json, 1, "page"), document);
    if (status == BAT_OK) status = read_objects(r, bat_json_member(r->json, 1, "objects"), document);
    if (status == BAT_OK) status = read_id(r, 1, "next", BAT_ID_MAX + 1, &next);
    if (status == BAT_OK) bat_document_raise_next(document, next);
    return status;
}

bat_status bat_document_read(const char *text, size_t size, bat_document **out, bat_problem *problem) {
    bat_pictures none = {0};
    bat_status status = bat_document_read_with(text, size, &none, out, problem);
    bat_pictures_free(&none);
    return status;
}

bat_status bat_document_read_with(const char *text, size_t size, bat_pictures *pictures, bat_document **out,
                                  bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    reader r = {&json, pictures, problem};
    bat_document *document = NULL;
    status = read_pictures(&r, bat_json_member(&json, 1, "pictures"), pictures);
    if (status == BAT_OK && (status = bat_document_create(&document)) != BAT_OK)
        bat_problem_set(problem, status, "", bat_status_message(status));
    if (status == BAT_OK) status = read_document(&r, document);
    bat_json_free(&json);
    if (status != BAT_OK)
        bat_document_free(document);
    else
        *out = document;
    return status;
}

static void write_colour(bat_text *text, const char *member, uint32_t colour) {
    char value[12];
    bat_text_string(text, member);
    snprintf(value, sizeof value, "\"#%08lx\"", (unsigned long)colour);
    bat_text_string(text, value);
}

static void write_flag(bat_text *text, const char *member, bool flag) {
    bat_text_string(text, member);
    bat_text_string(text, flag ? "true" : "false");
}

static void write_style(bat_text *text, const bat_style *style) {
    write_flag(text, "{\"stroked\":", style->stroked);
    write_colour(text, ",\"stroke\":", style->stroke);
    bat_text_string(text, ",\"width\":");
    bat_text_number(text, style->width);
    bat_text_string(text, ",\"cap\":\"");
    bat_text_string(text, caps[style->cap]);
    bat_text_string(text, "\",\"join\":\"");
    bat_text_string(text, joins[style->join]);
    bat_text_string(text, "\",\"miter_limit\":");
    bat_text_number(text, style->miter_limit);
    write_flag(text, ",\"filled\":", style->filled);
    write_colour(text, ",\"fill\":", style->fill);
    write_flag(text, ",\"even_odd\":", style->even_odd);
    bat_text_string(text, ",\"opacity\":");
    bat_text_number(text, style->opacity);
    bat_text_string(text, "}");
}

static void write_name(bat_text *text, const char *member, const bat_picture *picture) {
    char name[17];
    bat_digest_print(bat_picture_digest(picture), name);
    bat_text_string(text, member);
    bat_text_json_string(text, name);
}

void bat_picture_to_json(const bat_picture *picture, bat_text *text) {
    size_t size;
    const void *bytes = bat_picture_bytes(picture, &size);
    write_name(text, "{\"picture\":", picture);
    bat_text_string(text, ",\"data\":\"");
    bat_base64_write(text, bytes, size);
    bat_text_string(text, "\"}");
}

void bat_object_to_json(const bat_object *object, bat_text *text) {
    bat_text_string(text, "{\"id\":");
    bat_text_integer(text, bat_object_id(object));
    const bat_spline *spline = bat_object_spline(object);
    static const char *const kinds[] = {
        [BAT_KIND_PATH] = "path",   [BAT_KIND_SPLINE] = "spline", [BAT_KIND_GROUP] = "group",
        [BAT_KIND_LAYER] = "layer", [BAT_KIND_SHAPE] = "shape",   [BAT_KIND_IMAGE] = "image",
        [BAT_KIND_GUIDE] = "guide"};
    bat_text_string(text, ",\"kind\":\"");
    bat_text_string(text, kinds[bat_object_kind(object)]);
    bat_text_string(text, "\",\"name\":");
    bat_text_json_string(text, bat_object_name(object));
    if (bat_object_parent(object)) {
        bat_text_string(text, ",\"parent\":");
        bat_text_integer(text, bat_object_parent(object));
    }
    if (bat_object_hidden(object)) bat_text_string(text, ",\"hidden\":true");
    if (bat_object_locked(object)) bat_text_string(text, ",\"locked\":true");
    double at;
    int axis = bat_object_guide(object, &at);
    if (axis >= 0) {
        bat_text_string(text, axis ? ",\"y\":" : ",\"x\":");
        bat_text_number(text, at);
    }
    if (bat_object_is_group(object) || axis >= 0) {
        bat_text_string(text, "}");
        return;
    }
    const bat_picture *picture = bat_object_picture(object);
    if (picture) {
        write_name(text, ",\"picture\":", picture);
        bat_text_string(text, ",\"matrix\":[");
        for (int i = 0; i < 6; i++) {
            if (i > 0) bat_text_string(text, ",");
            bat_text_number(text, bat_object_matrix(object)[i]);
        }
        bat_text_string(text, "],\"opacity\":");
        bat_text_number(text, bat_object_style(object)->opacity);
        bat_text_string(text, "}");
        return;
    }
    bat_text_string(text, ",\n  \"style\":");
    write_style(text, bat_object_style(object));
    if (spline) { /* its curve is made of it, so it is not written twice */
        bat_text_string(text, ",\n  \"spline\":");
        bat_spline_to_json(spline, bat_object_spline_options(object), text);
        bat_text_string(text, "}");
        return;
    }
    bat_text_string(text, ",\n  \"curves\":[");
    for (int i = 0; i < bat_object_curve_count(object); i++) {
        bat_text_string(text, i > 0 ? ",\n   " : "\n   ");
        const bat_shape *shape = bat_object_shape(object, i);
        if (shape) /* its curve follows from it */
            bat_shape_to_json(shape, text);
        else
            bat_curve_to_json(bat_object_curve(object, i), 4, text);
    }
    bat_text_string(text, "]}");
}

/* Each once; nothing when there are none. */
static void write_pictures(const bat_document *document, bat_text *text) {
    bat_pictures written = {0};
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_picture *picture = bat_object_picture(bat_document_at(document, i));
        int before = written.count;
        if (!picture) continue;
        if (bat_pictures_add(&written, picture) != BAT_OK) text->failed = true;
        if (written.count == before) continue;
        bat_text_string(text, before ? ",\n " : ",\n\"pictures\":[");
        bat_picture_to_json(picture, text);
    }
    if (written.count) bat_text_string(text, "]");
    bat_pictures_free(&written);
}

void bat_document_to_json(const bat_document *document, bool pictures, bat_text *text) {
    double page[4];
    bat_document_page(document, page);
    bat_text_string(text, "{\"batten\":1,\n\"page\":[");
    for (int i = 0; i < 4; i++) {
        if (i > 0) bat_text_string(text, ",");
        bat_text_number(text, page[i]);
    }
    bat_text_string(text, "],\n\"next\":");
    bat_text_integer(text, bat_document_next(document));
    if (pictures) write_pictures(document, text);
    bat_text_string(text, ",\n\"objects\":[");
    for (int i = 0; i < bat_document_count(document); i++) {
        bat_text_string(text, i > 0 ? ",\n " : "\n ");
        bat_object_to_json(bat_document_at(document, i), text);
    }
    bat_text_string(text, "]}\n");
}

bat_status bat_document_write(const bat_document *document, char **text, size_t *size) {
    if (!document || !text || !size) return BAT_ARGUMENT;
    bat_text buffer = {0};
    bat_document_to_json(document, true, &buffer);
    return bat_text_finish(&buffer, text, size);
}
