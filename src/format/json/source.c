#include "format/json/source.h"

#include "document/digest.h"
#include "format/json/style.h"

#include "text/xml.h"

#include <batten/format.h>

#include <stdlib.h>
#include <string.h>

enum { ELEMENT_MAX = 1 << 22 };
static const double SAME[6] = {1, 0, 0, 1, 0, 0};

static bat_status read_digest(const bat_fields *f, uint32_t object, const char *name, uint64_t *digest) {
    const uint32_t node = bat_json_member(f->json, object, name);
    const char *text = bat_json_text(f->json, node);
    if (text && bat_digest_scan(text, digest)) return BAT_OK;
    return bat_fields_complain(f, node ? node : object, name, "16 hexadecimal digits");
}

static bat_status read_matrix(const bat_fields *f, uint32_t object, const char *name, double m[6]) {
    if (!bat_json_member(f->json, object, name)) return BAT_OK;
    return bat_fields_numbers(f, object, name, 6, "six numbers", m);
}

/* ["0123456789abcdef", ...], of the fill, the stroke and its line; left out: none has anything but a style. */
static bat_status read_paint(const bat_fields *f, uint32_t node, bat_sourced *entry) {
    const uint32_t list = bat_json_member(f->json, node, "paint");
    uint32_t at = bat_json_first(f->json, list);
    if (!list) return BAT_OK;
    for (int k = 0; k < BAT_PAINT_PARTS; k++, at = at ? f->json->nodes[at].next : 0)
        if (!at || !bat_json_text(f->json, at) ||
            !bat_digest_scan(bat_json_text(f->json, at), &entry->paint[k]))
            return bat_fields_complain(f, list, "paint", "three digests");
    return BAT_OK;
}

/* ["clips", ...]; what is not known is skipped. */
static void read_lost(const bat_fields *f, uint32_t node, bat_sourced *entry) {
    const uint32_t list = bat_json_member(f->json, node, "lost");
    for (uint32_t at = bat_json_first(f->json, list); at; at = f->json->nodes[at].next)
        for (int kind = 0; kind < BAT_LOSS_RULE; kind++)
            if (bat_json_text(f->json, at) &&
                !strcmp(bat_json_text(f->json, at), bat_loss_key((bat_loss)kind)))
                entry->lost |= 1u << kind;
}

static const char *const declared[] = {"shape", "matrix", "singly", "box", "important"};
enum { DECLARED = sizeof declared / sizeof *declared };

/* ["shape", ...]; what is not known is skipped. */
static void read_declared(const bat_fields *f, uint32_t node, bat_sourced *entry) {
    const uint32_t list = bat_json_member(f->json, node, "declared");
    for (uint32_t at = bat_json_first(f->json, list); at; at = f->json->nodes[at].next)
        for (int k = 0; k < DECLARED; k++)
            if (bat_json_text(f->json, at) && !strcmp(bat_json_text(f->json, at), declared[k]))
                entry->declared |= (uint8_t)(1u << k);
}

static bat_status read_entry(const bat_fields *f, uint32_t node, uint32_t above, bat_sourced *entry) {
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node, "elements", "an object");
    *entry = (bat_sourced){.opacity = 1, .own = 1, .style = bat_style_defaults()};
    bat_id element = 0;
    memcpy(entry->outer, SAME, sizeof SAME);
    bat_status status = bat_fields_id(f, node, "element", ELEMENT_MAX, &element);
    if (status == BAT_OK && (element == 0 || element < above))
        return bat_fields_complain(f, node, "element", "numbers that do not fall");
    entry->element = (uint32_t)element;
    if (status == BAT_OK) status = bat_fields_id(f, node, "id", BAT_ID_MAX, &entry->id);
    if (status == BAT_OK) status = bat_fields_flag(f, node, "copied", &entry->copied);
    if (status == BAT_OK) status = bat_fields_flag(f, node, "part", &entry->part);
    if (status == BAT_OK) status = read_matrix(f, node, "outer", entry->outer);
    memcpy(entry->inner, entry->outer, sizeof entry->inner);
    if (status == BAT_OK) status = read_matrix(f, node, "inner", entry->inner);
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "opacity", 0, 1, "a number from 0 to 1", &entry->opacity);
    if (status != BAT_OK || entry->id == 0) return status;
    status = read_digest(f, node, "shape", &entry->shape);
    if (status == BAT_OK) status = read_digest(f, node, "name", &entry->name);
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "own", 0, 1, "a number from 0 to 1", &entry->own);
    if (status == BAT_OK) status = bat_style_from_json(f, node, &entry->style);
    if (status == BAT_OK) status = read_paint(f, node, entry);
    if (status == BAT_OK && bat_json_member(f->json, node, "clip"))
        status = read_digest(f, node, "clip", &entry->clip);
    if (status == BAT_OK && bat_json_member(f->json, node, "markers"))
        status = read_digest(f, node, "markers", &entry->markers);
    if (status == BAT_OK) status = bat_fields_flag(f, node, "boxed", &entry->boxed);
    if (status == BAT_OK) status = bat_fields_flag(f, node, "hidden", &entry->hidden);
    if (status == BAT_OK) status = bat_fields_flag(f, node, "locked", &entry->locked);
    read_lost(f, node, entry);
    read_declared(f, node, entry);
    return status;
}

/* A file of that text would be no SVG, so the document goes without. */
static bat_status keep_sound(const bat_source *source, bat_document *document, bool *left) {
    size_t size;
    const char *text = bat_source_text(source, &size);
    const bat_status status = bat_xml_check(text, size);
    *left = status == BAT_SYNTAX;
    if (status == BAT_OK) bat_document_set_origin(document, source);
    return *left ? BAT_OK : status;
}

bat_status bat_source_from_json(const bat_fields *f, uint32_t node, bat_document *document, bool *left) {
    *left = false;
    if (!node) return BAT_OK;
    const uint32_t named = bat_json_member(f->json, node, "text"),
                   list = bat_json_member(f->json, node, "elements");
    const char *text = bat_json_text(f->json, named);
    uint64_t digest = 0;
    double page[4];
    if (!text) return bat_fields_complain(f, named ? named : node, "text", "a text");
    if (bat_json_type_of(f->json, list) != BAT_JSON_LIST)
        return bat_fields_complain(f, list ? list : node, "elements", "a list");
    bat_status status = bat_fields_numbers(f, node, "page", 4, "x, y, width and height", page);
    if (status == BAT_OK) status = read_digest(f, node, "digest", &digest);
    if (status != BAT_OK) return status;
    bat_sourced *entries = malloc(((size_t)bat_json_count(f->json, list) + 1) * sizeof *entries);
    if (!entries) return bat_fields_say(f, list, BAT_MEMORY);
    int count = 0;
    for (uint32_t at = bat_json_first(f->json, list); at && status == BAT_OK; at = f->json->nodes[at].next) {
        status = read_entry(f, at, count > 0 ? entries[count - 1].element : 1, &entries[count]);
        count += status == BAT_OK;
    }
    bat_source *source = NULL;
    if (status == BAT_OK)
        status = bat_fields_say(f, node,
                                bat_source_create(text, strlen(text), page, digest, count, entries, &source));
    free(entries);
    if (status == BAT_OK) status = bat_fields_say(f, named, keep_sound(source, document, left));
    bat_source_release(source);
    return status;
}

static void write_digest(bat_text *text, const char *member, uint64_t digest) {
    char digits[17];
    bat_digest_print(digest, digits);
    bat_text_string(text, member);
    bat_text_string(text, digits);
    bat_text_string(text, "\"");
}

static bool is_equal(const double *a, const double *b) {
    for (int i = 0; i < 6; i++)
        if (a[i] != b[i]) return false;
    return true;
}

static void write_paint(const bat_sourced *entry, bat_text *text) {
    bool any = false;
    for (int k = 0; k < BAT_PAINT_PARTS; k++) any = any || entry->paint[k];
    for (int k = 0; k < BAT_PAINT_PARTS && any; k++)
        write_digest(text, k > 0 ? ",\"" : ",\"paint\":[\"", entry->paint[k]);
    if (any) bat_text_string(text, "]");
    if (entry->clip) write_digest(text, ",\"clip\":\"", entry->clip);
    if (entry->markers) write_digest(text, ",\"markers\":\"", entry->markers);
    if (entry->boxed && (any || entry->clip)) bat_text_string(text, ",\"boxed\":true");
}

static void write_lost(uint32_t lost, bat_text *text) {
    bat_text_string(text, ",\"lost\":");
    for (int kind = 0, made = 0; kind < BAT_LOSS_RULE; kind++) {
        if (!(lost & 1u << kind)) continue;
        bat_text_string(text, made++ ? "," : "[");
        bat_text_json_string(text, bat_loss_key((bat_loss)kind));
    }
    bat_text_string(text, "]");
}

static void write_declared(const bat_sourced *entry, bat_text *text) {
    for (int k = 0, made = 0; k < DECLARED; k++) {
        if (!(entry->declared & 1u << k)) continue;
        bat_text_string(text, made++ ? "," : ",\"declared\":[");
        bat_text_json_string(text, declared[k]);
    }
    if (entry->declared) bat_text_string(text, "]");
}

static void write_entry(const bat_sourced *entry, bat_text *text) {
    bat_text_string(text, "{\"element\":");
    bat_text_integer(text, entry->element);
    if (entry->copied) bat_text_string(text, ",\"copied\":true");
    if (entry->part) bat_text_string(text, ",\"part\":true");
    if (!is_equal(entry->outer, SAME)) bat_text_numbers(text, ",\"outer\":", entry->outer, 6);
    if (!is_equal(entry->inner, entry->outer)) bat_text_numbers(text, ",\"inner\":", entry->inner, 6);
    if (entry->opacity != 1) {
        bat_text_string(text, ",\"opacity\":");
        bat_text_number(text, entry->opacity);
    }
    if (entry->id) {
        bat_text_string(text, ",\"id\":");
        bat_text_integer(text, entry->id);
        write_digest(text, ",\"shape\":\"", entry->shape);
        write_digest(text, ",\"name\":\"", entry->name);
        bat_text_string(text, ",\"style\":");
        bat_style_to_json(&entry->style, text);
        write_paint(entry, text);
        if (entry->own != 1) {
            bat_text_string(text, ",\"own\":");
            bat_text_number(text, entry->own);
        }
        if (entry->hidden) bat_text_string(text, ",\"hidden\":true");
        if (entry->locked) bat_text_string(text, ",\"locked\":true");
        if (entry->lost) write_lost(entry->lost, text);
        write_declared(entry, text);
    }
    bat_text_string(text, "}");
}

void bat_source_to_json(const bat_source *source, bat_text *text) {
    size_t size;
    bat_text_string(text, "{\"text\":");
    bat_text_json_string(text, bat_source_text(source, &size));
    bat_text_numbers(text, ",\n\"page\":", bat_source_page(source), 4);
    write_digest(text, ",\"digest\":\"", bat_source_digest(source));
    bat_text_string(text, ",\n\"elements\":[");
    for (int i = 0; i < bat_source_count(source); i++) {
        bat_text_string(text, i > 0 ? ",\n " : "\n ");
        write_entry(bat_source_at(source, i), text);
    }
    bat_text_string(text, "]}");
}
