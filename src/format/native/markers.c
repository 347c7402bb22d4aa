#include "format/native/markers.h"

#include <stdlib.h>
#include <string.h>

static const char *const places[] = {"start", "mid", "end"}, *const orders[] = {"last", "first", "between"},
                         *const turns[] = {"fixed", "auto", "reversed"},
                         *const inks[] = {"own", "fill", "stroke"};

/* One of three words; left out: the first. */
static bat_status read_word(const bat_fields *f, uint32_t node, const char *name, const char *const words[3],
                            const char *expected, int *out) {
    const uint32_t at = bat_json_member(f->json, node, name);
    const char *word = bat_json_text(f->json, at);
    *out = 0;
    if (!at) return BAT_OK;
    for (; *out < 3; ++*out)
        if (word && strcmp(word, words[*out]) == 0) return BAT_OK;
    return bat_fields_complain(f, at, name, expected);
}

typedef bat_status reader(const bat_fields *f, uint32_t node, bat_object **out);

static bat_status read_part(const bat_fields *f, uint32_t node, reader *read, bat_marker_part *out) {
    int fill = 0, stroke = 0;
    bat_object *object = NULL;
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node, "parts", "an object");
    bat_status status = read_word(f, node, "fill", inks, "own, fill or stroke", &fill);
    if (status == BAT_OK) status = read_word(f, node, "stroke", inks, "own, fill or stroke", &stroke);
    const uint32_t at = bat_json_member(f->json, node, "object");
    if (status == BAT_OK && !at) return bat_fields_complain(f, node, "object", "an object");
    if (status == BAT_OK) status = read(f, at, &object);
    if (status == BAT_OK) *out = (bat_marker_part){object, (bat_marker_ink)fill, (bat_marker_ink)stroke};
    return status;
}

static bat_status read_place(const bat_fields *f, uint32_t node, bat_marking *m) {
    int turn = 0;
    bat_status status = read_word(f, node, "turn", turns, "fixed, auto or reversed", &turn);
    m->turn = (bat_marker_turn)turn;
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "angle", -BAT_COORDINATE_MAX, BAT_COORDINATE_MAX, "degrees",
                                   &m->angle);
    if (status == BAT_OK) status = bat_fields_flag(f, node, "by_width", &m->by_width);
    if (status == BAT_OK && bat_json_member(f->json, node, "matrix"))
        status = bat_fields_numbers(f, node, "matrix", 6, "six numbers", m->matrix);
    if (status != BAT_OK || !bat_json_member(f->json, node, "clip")) return status;
    m->clipped = true;
    return bat_fields_numbers(f, node, "clip", 4, "x, y, width and height", m->clip);
}

static bat_status read_marker(const bat_fields *f, uint32_t node, reader *read, bat_marker **out) {
    const uint32_t list = bat_json_member(f->json, node, "parts"), count = bat_json_count(f->json, list);
    bat_marking m = {.matrix = {1, 0, 0, 1, 0, 0}};
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT ||
        bat_json_type_of(f->json, list) != BAT_JSON_LIST || count > BAT_MARKER_PARTS_MAX)
        return bat_fields_complain(f, list ? list : node, "parts", "a list of at most 256 parts");
    bat_marker_part *parts = malloc(((size_t)count + 1) * sizeof *parts);
    if (!parts) return bat_fields_say(f, node, BAT_MEMORY);
    bat_status status = read_place(f, node, &m);
    for (uint32_t at = bat_json_first(f->json, list); at && status == BAT_OK; at = f->json->nodes[at].next) {
        status = read_part(f, at, read, &parts[m.count]);
        m.count += status == BAT_OK;
    }
    m.parts = parts;
    if (status == BAT_OK) status = bat_fields_say(f, node, bat_marker_create(&m, out));
    for (int i = 0; i < m.count; i++) bat_object_release((bat_object *)parts[i].object);
    free(parts);
    return status;
}

/* A word says that it is the same as in that place. */
static bat_status read_place_of(const bat_fields *f, uint32_t node, int place, reader *read,
                                bat_marked *marked) {
    const uint32_t at = bat_json_member(f->json, node, places[place]);
    const char *word = bat_json_text(f->json, at);
    if (!at) return BAT_OK;
    if (!word) return read_marker(f, at, read, &marked->markers[place]);
    for (int k = 0; k < place; k++)
        if (strcmp(word, places[k]) == 0) {
            marked->markers[place] = bat_marker_retain(marked->markers[k]);
            return BAT_OK;
        }
    return bat_fields_complain(f, at, places[place], "a marker, or a place before it");
}

bat_status bat_markers_from_json(const bat_fields *f, uint32_t node, reader *read, bat_object **object) {
    const uint32_t at = bat_json_member(f->json, node, "markers");
    bat_marked marked = {.frame = {1, 0, 0, 1}};
    bat_markers *markers = NULL;
    bat_object *made = NULL;
    int order = 0;
    if (bat_json_type_of(f->json, at) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, at, "markers", "an object");
    bat_status status = read_word(f, at, "order", orders, "last, first or between", &order);
    marked.order = (bat_marker_order)order;
    if (status == BAT_OK && bat_json_member(f->json, at, "frame"))
        status = bat_fields_numbers(f, at, "frame", 4, "four numbers", marked.frame);
    for (int k = 0; k < BAT_MARKER_PLACES && status == BAT_OK; k++)
        status = read_place_of(f, at, k, read, &marked);
    if (status == BAT_OK) status = bat_fields_say(f, at, bat_markers_create(&marked, &markers));
    if (status == BAT_OK) status = bat_fields_say(f, at, bat_object_with_markers(*object, markers, &made));
    for (int k = 0; k < BAT_MARKER_PLACES; k++) bat_marker_release(marked.markers[k]);
    bat_markers_release(markers);
    if (status != BAT_OK) return status;
    bat_object_release(*object);
    *object = made;
    return BAT_OK;
}

/* ---- writing ---- */

static void write_word(bat_text *text, const char *member, const char *const words[3], int word) {
    if (word == 0) return;
    bat_text_string(text, member);
    bat_text_string(text, words[word]);
    bat_text_string(text, "\"");
}

typedef void writer(const bat_object *object, bat_text *text);

static void write_marker(bat_text *text, const bat_marking *m, writer *write) {
    bat_text_numbers(text, "{\"matrix\":", m->matrix, 6);
    write_word(text, ",\"turn\":\"", turns, (int)m->turn);
    if (m->angle != 0) {
        bat_text_string(text, ",\"angle\":");
        bat_text_number(text, m->angle);
    }
    if (m->by_width) bat_text_string(text, ",\"by_width\":true");
    if (m->clipped) bat_text_numbers(text, ",\"clip\":", m->clip, 4);
    bat_text_string(text, ",\"parts\":[");
    for (int i = 0; i < m->count; i++) {
        bat_text_string(text, i > 0 ? ",\n   {\"object\":" : "\n   {\"object\":");
        write(m->parts[i].object, text);
        write_word(text, ",\"fill\":\"", inks, (int)m->parts[i].fill);
        write_word(text, ",\"stroke\":\"", inks, (int)m->parts[i].stroke);
        bat_text_string(text, "}");
    }
    bat_text_string(text, "]}");
}

void bat_markers_to_json(const bat_markers *markers, writer *write, bat_text *text) {
    const bat_marked *m = bat_markers_marked(markers);
    bat_text_numbers(text, ",\n  \"markers\":{\"frame\":", m->frame, 4);
    write_word(text, ",\"order\":\"", orders, (int)m->order);
    for (int k = 0; k < BAT_MARKER_PLACES; k++) {
        int same = 0;
        if (!m->markers[k]) continue;
        while (m->markers[same] != m->markers[k]) same++;
        bat_text_string(text, ",\n  \"");
        bat_text_string(text, places[k]);
        bat_text_string(text, "\":");
        if (same == k)
            write_marker(text, bat_marker_marking(m->markers[k]), write);
        else
            bat_text_json_string(text, places[same]);
    }
    bat_text_string(text, "}");
}
