/* The native document: {"batten":1, "page":[...], "next":4, "objects":[...]} (docs/format.md). */
#include "format/native/native.h"

#include "document/digest.h"
#include "document/document.h"
#include "document/follow.h"
#include "document/lettering.h"
#include "document/scale.h"
#include "text/base64.h"
#include "format/json/curve.h"
#include "format/json/fields.h"
#include "format/json/clip.h"
#include "format/json/paint.h"
#include "format/json/source.h"
#include "format/native/markers.h"
#include "kinds/kinds.h"
#include "text/json.h"

#include <batten/format.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Versions of the format, of which older programs refuse those that they would not keep whole: drawings with shapes that stay shapes or texts, with masks, with patterns, with markers, with strokes whose width
 * changes, drawings with meshes or with
 * what is bound to wires, drawings with surfaces that are made from curves, drawings with paint beyond styles, drawings that
 * keep the file that they were read from, drawings with something in space, and all others. */
enum {
    PLAIN = 1,
    SPATIAL = 2,
    SOURCED = 3,
    PAINTED = 4,
    MADE = 5,
    BOUND = 6,
    WIDENED = 7,
    MARKED = 8,
    PATTERNED = 9,
    MASKED = 10,
    BESIDE = 11, /* what stands beside a drawing (held.h) */
    NEWEST = 12  /* shapes, texts */
};

/* Replaces *object with `made`, or reports what went wrong (fault NULL: with the status's own message). */
static bat_status exchange(const bat_fields *f, uint32_t node, bat_status status, const char *fault,
                           bat_object *made, bat_object **object) {
    if (status != BAT_OK)
        return bat_json_say(f->json, node, status, fault ? fault : bat_status_message(status), f->problem);
    bat_object_release(*object);
    *object = made;
    return BAT_OK;
}

static bat_status read_object(const bat_fields *f, uint32_t node, bat_object **out);

/* Reads group, visibility and lock; takes `object` over. */
static bat_status place_object(const bat_fields *f, uint32_t node, bat_object *object, bat_object **out) {
    bat_id parent = 0;
    bool hidden = false, locked = false;
    bat_object *placed = NULL;
    bat_status status = bat_fields_id(f, node, "parent", BAT_ID_MAX, &parent);
    if (status == BAT_OK) status = bat_fields_flag(f, node, "hidden", &hidden);
    if (status == BAT_OK) status = bat_fields_flag(f, node, "locked", &locked);
    if (status == BAT_OK && bat_json_member(f->json, node, "paint"))
        status = bat_paint_from_json(f, node, &object);
    if (status == BAT_OK && bat_json_member(f->json, node, "clip"))
        status = bat_clip_from_json(f, node, &object);
    if (status == BAT_OK && bat_json_member(f->json, node, "markers"))
        status = bat_markers_from_json(f, node, read_object, &object);
    if (status == BAT_OK && parent > 0) {
        status = bat_object_with_parent(object, parent, &placed);
        status = exchange(f, node, status, "parent: not itself", placed, &object);
    }
    if (status == BAT_OK && (hidden || locked)) {
        status = bat_object_with_state(object, hidden, locked, &placed);
        status = exchange(f, node, status, NULL, placed, &object);
    }
    if (status != BAT_OK)
        bat_object_release(object);
    else
        *out = object;
    return status;
}

static bat_status read_object(const bat_fields *f, uint32_t node, bat_object **out) {
    const bat_json *json = f->json;
    if (bat_json_type_of(json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node, "objects", "an object");
    uint32_t kind = bat_json_member(json, node, "kind");
    const char *word = bat_json_text(json, kind);
    if (!word) return bat_fields_complain(f, kind ? kind : node, "kind", "a text");
    const bat_kind_type *type = bat_kind_named(word);
    if (!type) {
        char words[BAT_KINDS_WORDS];
        bat_kinds_words(words);
        return bat_json_complain(json, kind, BAT_UNSUPPORTED, "kind", words, f->problem);
    }
    bat_id id = 0;
    bat_status status = bat_fields_id(f, node, "id", BAT_ID_MAX, &id);
    if (status != BAT_OK) return status;
    if (id == 0) return bat_fields_complain(f, node, "id", "a whole number");
    uint32_t named = bat_json_member(json, node, "name");
    const char *name = named ? bat_json_text(json, named) : "";
    if (!name) return bat_fields_complain(f, named, "name", "a text");
    bat_object *object = NULL;
    if (type->read)
        status = type->read(f, node, id, name, &object);
    else
        status = bat_fields_say(f, node, bat_object_make(type, id, name, NULL, NULL, 0, NULL, &object));
    return status == BAT_OK ? place_object(f, node, object, out) : status;
}

bat_status bat_object_from_json(const bat_json *json, uint32_t node, const bat_pictures *pictures,
                                bat_object **out, bat_problem *problem) {
    return read_object(&(bat_fields){json, pictures, problem}, node, out);
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

static bat_status read_objects(const bat_fields *f, uint32_t list, bat_document *document) {
    if (bat_json_type_of(f->json, list) != BAT_JSON_LIST)
        return bat_fields_complain(f, list ? list : 1, "objects", "a list");
    uint32_t room = bat_json_count(f->json, list);
    bat_object **objects = malloc(((size_t)room + 1) * sizeof *objects);
    if (!objects) return bat_json_say(f->json, list, BAT_MEMORY, bat_status_message(BAT_MEMORY), f->problem);
    int count = 0;
    bat_status status = BAT_OK;
    for (uint32_t at = bat_json_first(f->json, list); at && status == BAT_OK; at = f->json->nodes[at].next) {
        status = read_object(f, at, &objects[count]);
        if (status == BAT_OK) count++;
    }
    if (status == BAT_OK) {
        status = bat_document_fill(document, count, objects);
        if (status != BAT_OK)
            bat_json_say(f->json, list, status,
                         status == BAT_ARGUMENT ? "objects: expected different ids, found one twice"
                                                : bat_status_message(status),
                         f->problem);
    }
    if (status != BAT_OK)
        while (count > 0) bat_object_release(objects[--count]);
    free(objects);
    if (status == BAT_OK && bat_document_has_followers(document)) {
        status = bat_document_follow(document);
        if (status != BAT_OK)
            bat_json_say(f->json, list, status,
                         status == BAT_ARGUMENT ? "follows, from: expected an object with a curve, found none"
                                                : bat_status_message(status),
                         f->problem);
        if (status != BAT_OK) return status;
    }
    const char *wrong = status == BAT_OK ? bat_document_check_nesting(document) : NULL;
    if (wrong) status = bat_json_say(f->json, list, BAT_ARGUMENT, wrong, f->problem);
    return status;
}

static bat_status read_page(const bat_fields *f, uint32_t list, bat_document *document) {
    if (!list) return BAT_OK;
    double *page;
    size_t count;
    bat_status status = bat_numbers_from_json(f->json, list, "page", &page, &count, f->problem);
    if (status != BAT_OK) return status;
    status = count == 4 ? bat_document_set_page(document, page) : BAT_COUNT;
    free(page);
    if (status == BAT_OK) return BAT_OK;
    return bat_json_complain(f->json, list, status, "page",
                             "x, y, width and height, none of them negative width or height", f->problem);
}

/* "unit" and "scale", both or none. */
static bat_status read_scale(const bat_fields *f, bat_document *document) {
    const uint32_t named = bat_json_member(f->json, 1, "unit");
    const char *word = bat_json_text(f->json, named);
    bat_unit unit = BAT_UNIT_PX;
    if (!named) return BAT_OK;
    if (!word || !bat_unit_of_word(word, &unit))
        return bat_json_complain(f->json, named, BAT_UNSUPPORTED, "unit", "px, mm, cm, in, pt, pc or none",
                                 f->problem);
    double scale = bat_unit_millimetres(unit);
    const bat_status status = bat_fields_number(f, 1, "scale", 1e-12, 1e12, "millimetres from 1e-12 to 1e12",
                                                &scale);
    return status == BAT_OK ? bat_fields_say(f, named, bat_document_set_scale(document, scale, unit))
                            : status;
}

static bat_status read_stand(const bat_fields *f, bat_document *document) {
    const uint32_t named = bat_json_member(f->json, 1, "stand");
    const bat_stand stand = bat_stand_of_word(bat_json_text(f->json, named));
    if (named && !stand)
        return bat_json_complain(f->json, named, BAT_UNSUPPORTED, "stand", "wall or floor", f->problem);
    bat_document_set_stand(document, stand);
    return BAT_OK;
}

/* Adds the document's own pictures to those already known. */
static bat_status read_pictures(const bat_fields *f, uint32_t list, bat_pictures *pictures) {
    bat_status status = BAT_OK;
    if (list && bat_json_type_of(f->json, list) != BAT_JSON_LIST)
        return bat_fields_complain(f, list, "pictures", "a list");
    for (uint32_t at = bat_json_first(f->json, list); at && status == BAT_OK; at = f->json->nodes[at].next)
        status = bat_picture_from_json(f->json, at, pictures, f->problem);
    return status;
}

static bat_status read_document(const bat_fields *f, bat_document *document, bool *left) {
    uint32_t version = bat_json_member(f->json, 1, "batten");
    if (bat_json_type_of(f->json, version) != BAT_JSON_NUMBER)
        return bat_fields_complain(f, version ? version : 1, "batten", "the version of the format, a number");
    const double number = f->json->nodes[version].value.number;
    if (!(number >= PLAIN && number <= NEWEST && number != BESIDE && number == floor(number)))
        return bat_json_complain(f->json, version, BAT_UNSUPPORTED, "batten", "version 1 to 10, or 12",
                                 f->problem);
    bat_id next = 0;
    bat_status status = read_page(f, bat_json_member(f->json, 1, "page"), document);
    if (status == BAT_OK) status = read_scale(f, document);
    if (status == BAT_OK) status = read_stand(f, document);
    if (status == BAT_OK) status = read_objects(f, bat_json_member(f->json, 1, "objects"), document);
    if (status == BAT_OK) status = bat_fields_id(f, 1, "next", BAT_ID_MAX + 1, &next);
    if (status == BAT_OK)
        status = bat_source_from_json(f, bat_json_member(f->json, 1, "source"), document, left);
    if (status == BAT_OK) bat_document_raise_next(document, next);
    return status;
}

bat_status bat_document_read(const char *text, size_t size, bat_document **out, bat_problem *problem) {
    bat_pictures none = {0};
    bat_status status = bat_document_read_with(text, size, &none, out, NULL, problem);
    bat_pictures_free(&none);
    return status;
}

bat_status bat_document_read_with(const char *text, size_t size, bat_pictures *pictures, bat_document **out,
                                  bool *left, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    bat_fields f = {&json, pictures, problem};
    bat_document *document = NULL;
    bool without = false;
    status = read_pictures(&f, bat_json_member(&json, 1, "pictures"), pictures);
    if (status == BAT_OK && (status = bat_document_create(&document)) != BAT_OK)
        bat_problem_set(problem, status, "", bat_status_message(status));
    if (status == BAT_OK) status = read_document(&f, document, &without);
    bat_json_free(&json);
    if (status != BAT_OK)
        bat_document_free(document);
    else
        *out = document;
    if (left) *left = without;
    return status;
}

void bat_picture_to_json(const bat_picture *picture, bat_text *text) {
    size_t size;
    char digest[17];
    const void *bytes = bat_picture_bytes(picture, &size);
    bat_digest_print(bat_picture_digest(picture), digest);
    bat_text_string(text, "{\"picture\":");
    bat_text_json_string(text, digest);
    bat_text_string(text, ",\"data\":\"");
    bat_base64_write(text, bytes, size);
    bat_text_string(text, "\"}");
}

void bat_object_to_json(const bat_object *object, bat_text *text) {
    const bat_kind_type *type = bat_object_type(object);
    bat_text_string(text, "{\"id\":");
    bat_text_integer(text, bat_object_id(object));
    bat_text_string(text, ",\"kind\":\"");
    bat_text_string(text, type->name);
    bat_text_string(text, "\",\"name\":");
    bat_text_json_string(text, bat_object_name(object));
    if (bat_object_parent(object)) {
        bat_text_string(text, ",\"parent\":");
        bat_text_integer(text, bat_object_parent(object));
    }
    if (bat_object_is_hidden(object)) bat_text_string(text, ",\"hidden\":true");
    if (bat_object_is_locked(object)) bat_text_string(text, ",\"locked\":true");
    if (bat_object_paint(object)) bat_paint_to_json(bat_object_paint(object), text);
    if (bat_object_clip(object)) bat_clip_to_json(bat_object_clip(object), text);
    if (bat_object_markers(object)) bat_markers_to_json(bat_object_markers(object), bat_object_to_json, text);
    if (type->write) type->write(object, text);
    bat_text_string(text, "}");
}

/* Writes each picture once; writes nothing when there are none. all: those of images, too. */
static void write_pictures(const bat_document *document, bool all, bat_text *text) {
    bat_pictures written = {0};
    for (int i = 0; i < BAT_OBJECT_PICTURES * bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i / BAT_OBJECT_PICTURES);
        const bat_picture *picture = bat_object_picture_at(object, i % BAT_OBJECT_PICTURES);
        int before = written.count;
        if (!picture || !(all || i % BAT_OBJECT_PICTURES || bat_object_is_foreign(object))) continue;
        if (bat_pictures_add(&written, picture) != BAT_OK) text->failed = true;
        if (written.count == before) continue;
        bat_text_string(text, before ? ",\n " : ",\n\"pictures\":[");
        bat_picture_to_json(picture, text);
    }
    if (written.count) bat_text_string(text, "]");
    bat_pictures_free(&written);
}

/* Whether it came with the last version. What has no sources is not asked for wires: that would fetch the second part of the
 * module while a drawing is opened. */
static bool is_new(const bat_object *object) {
    const bat_paint *paint = bat_object_paint(object);
    return (paint && paint->stroke_first) || bat_object_is(object, BAT_NEW) || bat_object_relief(object) ||
           bat_object_clip(object) ||
           (bat_object_is_group(object) && bat_object_style(object)->opacity != 1) ||
           (bat_object_sources(object, NULL) > 0 && bat_object_wires(object, NULL, NULL) > 0);
}

static bool is_masked(const bat_object *object) {
    const bat_clip *clip = bat_object_clip(object);
    while (clip && !bat_clip_picture(clip)) clip = bat_clip_within(clip);
    return clip != NULL;
}

static uint64_t version_of(const bat_document *document, bool whole) {
    uint64_t version = whole && bat_document_origin(document) ? SOURCED : PLAIN;
    for (int i = 0; i < bat_document_count(document); i++)
        if (bat_object_is(bat_document_at(document, i), BAT_PLAIN) ||
            bat_object_lettering(bat_document_at(document, i)))
            return NEWEST;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        const bat_paint *paint = bat_object_paint(object);
        if (is_masked(object) || version == MASKED) {
            version = MASKED;
            continue;
        }
        if ((paint && (paint->fill.tile || paint->stroke.tile)) || version == PATTERNED) {
            version = PATTERNED;
            continue;
        }
        if (bat_object_markers(object) || version == MARKED) {
            version = MARKED;
            continue;
        }
        if ((paint && paint->width_count) || version == WIDENED) {
            version = WIDENED;
            continue;
        }
        if (is_new(object) || version == BOUND) {
            version = BOUND;
            continue;
        }
        if (bat_object_sources(object, NULL) > 0)
            version = MADE;
        else if (bat_object_paint(object) && version < PAINTED)
            version = PAINTED;
        if (bat_object_is(object, BAT_SPACE) && version < SPATIAL) version = SPATIAL;
    }
    return version;
}

void bat_document_to_json(const bat_document *document, bool pictures, bat_text *text) {
    double page[4];
    bat_document_page(document, page);
    bat_text_string(text, "{\"batten\":");
    bat_text_integer(text, version_of(document, pictures));
    bat_text_string(text, ",\n\"page\":[");
    for (int i = 0; i < 4; i++) {
        if (i > 0) bat_text_string(text, ",");
        bat_text_number(text, page[i]);
    }
    bat_text_string(text, "]");
    if (bat_unit_is_kept(document)) {
        bat_text_string(text, ",\n\"unit\":\"");
        bat_text_string(text, bat_unit_word(bat_document_unit(document)));
        bat_text_string(text, "\",\"scale\":");
        bat_text_number(text, bat_document_scale(document));
    }
    if (bat_document_stand(document)) {
        bat_text_string(text, ",\n\"stand\":");
        bat_text_json_string(text, bat_stand_word(bat_document_stand(document)));
    }
    bat_text_string(text, ",\n\"next\":");
    bat_text_integer(text, bat_document_next(document));
    write_pictures(document, pictures, text);
    if (pictures && bat_document_origin(document)) {
        bat_text_string(text, ",\n\"source\":");
        bat_source_to_json(bat_document_origin(document), text);
    }
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
