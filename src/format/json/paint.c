#include "format/json/paint.h"

#include "base/matrix.h"
#include "document/digest.h"
#include "format/json/style.h"

#include <string.h>

static const char *const spread_words[] = {"pad", "reflect", "repeat"};

static bat_status read_spread(const bat_fields *f, uint32_t node, bat_spread *spread) {
    const uint32_t named = bat_json_member(f->json, node, "spread");
    if (!named) return BAT_OK;
    const char *word = bat_json_text(f->json, named);
    for (int i = 0; word && i < 3; i++)
        if (strcmp(word, spread_words[i]) == 0) {
            *spread = (bat_spread)i;
            return BAT_OK;
        }
    return bat_fields_complain(f, named, "spread", "pad, reflect or repeat");
}

/* [[at, "#rrggbbaa"], ...] */
static bat_status read_stops(const bat_fields *f, uint32_t node, bat_stop *stops, size_t *count) {
    const uint32_t list = bat_json_member(f->json, node, "stops");
    const uint32_t room = bat_json_count(f->json, list);
    if (bat_json_type_of(f->json, list) != BAT_JSON_LIST || room < 2 || room > BAT_STOPS_MAX)
        return bat_fields_complain(f, list ? list : node, "stops", "a list of 2 to 256 stops");
    *count = 0;
    for (uint32_t at = bat_json_first(f->json, list); at; at = f->json->nodes[at].next) {
        const uint32_t first = bat_json_first(f->json, at);
        const uint32_t second = first ? f->json->nodes[first].next : 0;
        bat_stop *stop = &stops[(*count)++];
        if (bat_json_type_of(f->json, first) != BAT_JSON_NUMBER ||
            !bat_colour_scan(bat_json_text(f->json, second), &stop->colour))
            return bat_fields_complain(f, at, "stops", "[place, \"#rrggbbaa\"]");
        stop->at = f->json->nodes[first].value.number;
    }
    return BAT_OK;
}

/* The picture of a pattern, if it is one. */
static bat_status read_tile(const bat_fields *f, uint32_t node, const bat_picture **tile) {
    const uint32_t named = bat_json_member(f->json, node, "tile");
    const char *word = bat_json_text(f->json, named);
    uint64_t digest;
    if (!named) return BAT_OK;
    *tile = word && f->pictures && bat_digest_scan(word, &digest) ? bat_pictures_find(f->pictures, digest)
                                                                  : NULL;
    return *tile ? BAT_OK : bat_fields_complain(f, named, "tile", "the digest of one of the pictures");
}

static bat_status read_gradient(const bat_fields *f, uint32_t outer, const char *name, bat_stop *stops,
                                bat_gradient *out) {
    const uint32_t node = bat_json_member(f->json, outer, name);
    if (!node) return BAT_OK;
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node, name, "an object");
    bat_gradient made = {.stops = stops};
    bat_status status = bat_fields_flag(f, node, "radial", &made.radial);
    if (status == BAT_OK) status = read_spread(f, node, &made.spread);
    const size_t numbers = made.radial ? 3 : 2;
    const char *expected = made.radial ? "x, y and radius" : "x and y";
    if (status == BAT_OK) status = bat_fields_numbers(f, node, "from", numbers, expected, made.from);
    if (status == BAT_OK) status = bat_fields_numbers(f, node, "to", numbers, expected, made.to);
    bat_matrix_identity(made.matrix);
    if (status == BAT_OK && bat_json_member(f->json, node, "matrix"))
        status = bat_fields_numbers(f, node, "matrix", 6, "six numbers", made.matrix);
    if (status == BAT_OK) status = read_stops(f, node, stops, &made.count);
    if (status == BAT_OK) status = read_tile(f, node, &made.tile);
    if (status == BAT_OK) *out = made;
    return status;
}

static bat_status read_dashes(const bat_fields *f, uint32_t node, double *dashes, bat_paint *paint) {
    const uint32_t list = bat_json_member(f->json, node, "dashes");
    if (!list) return BAT_OK;
    const uint32_t count = bat_json_count(f->json, list);
    if (count < 1 || count > BAT_DASHES_MAX)
        return bat_fields_complain(f, list, "dashes", "a list of 1 to 64 numbers");
    const bat_status status = bat_fields_numbers(f, node, "dashes", count, "a list of numbers", dashes);
    if (status != BAT_OK) return status;
    paint->dashes = dashes;
    paint->dash_count = count;
    return bat_fields_number(f, node, "dash_offset", -BAT_COORDINATE_MAX, BAT_COORDINATE_MAX, "a number",
                             &paint->dash_offset);
}

/* [[at, share], ...] */
static bat_status read_widths(const bat_fields *f, uint32_t node, bat_width_stop *stops, bat_paint *paint) {
    const uint32_t list = bat_json_member(f->json, node, "widths");
    if (!list) return BAT_OK;
    const uint32_t count = bat_json_count(f->json, list);
    if (bat_json_type_of(f->json, list) != BAT_JSON_LIST || count < 1 || count > BAT_WIDTHS_MAX)
        return bat_fields_complain(f, list, "widths", "a list of 1 to 256 stops");
    for (uint32_t at = bat_json_first(f->json, list); at; at = f->json->nodes[at].next) {
        const uint32_t first = bat_json_first(f->json, at);
        const uint32_t second = first ? f->json->nodes[first].next : 0;
        if (bat_json_type_of(f->json, first) != BAT_JSON_NUMBER ||
            bat_json_type_of(f->json, second) != BAT_JSON_NUMBER)
            return bat_fields_complain(f, at, "widths", "[place, share of the width]");
        stops[paint->width_count++] = (bat_width_stop){f->json->nodes[first].value.number,
                                                       f->json->nodes[second].value.number};
    }
    paint->widths = stops;
    return BAT_OK;
}

bat_status bat_paint_from_json(const bat_fields *f, uint32_t node, bat_object **object) {
    const uint32_t at = bat_json_member(f->json, node, "paint");
    if (bat_json_type_of(f->json, at) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, at, "paint", "an object");
    bat_stop stops[2][BAT_STOPS_MAX];
    double dashes[BAT_DASHES_MAX];
    bat_width_stop widths[BAT_WIDTHS_MAX];
    bat_paint paint = {0};
    bat_status status = read_gradient(f, at, "fill", stops[0], &paint.fill);
    if (status == BAT_OK) status = read_gradient(f, at, "stroke", stops[1], &paint.stroke);
    if (status == BAT_OK) status = read_dashes(f, at, dashes, &paint);
    if (status == BAT_OK && bat_json_member(f->json, at, "pen"))
        status = bat_fields_numbers(f, at, "pen", 4, "four numbers", paint.pen);
    if (status == BAT_OK) status = bat_fields_flag(f, at, "stroke_first", &paint.stroke_first);
    if (status == BAT_OK) status = read_widths(f, at, widths, &paint);
    if (status != BAT_OK) return status;
    bat_object *made = NULL;
    status = bat_fields_say(f, at, bat_object_with_paint(*object, &paint, &made));
    if (status != BAT_OK) return status;
    bat_object_release(*object);
    *object = made;
    return BAT_OK;
}

static void write_gradient(bat_text *text, const char *member, const bat_gradient *g) {
    const int numbers = g->radial ? 3 : 2;
    bat_text_string(text, member);
    if (g->radial) bat_text_string(text, "\"radial\":true,");
    if (g->spread != BAT_SPREAD_PAD) {
        bat_text_string(text, "\"spread\":\"");
        bat_text_string(text, spread_words[g->spread]);
        bat_text_string(text, "\",");
    }
    bat_text_numbers(text, "\"from\":", g->from, numbers);
    bat_text_numbers(text, ",\"to\":", g->to, numbers);
    bat_text_numbers(text, ",\"matrix\":", g->matrix, 6);
    bat_text_string(text, ",\"stops\":");
    for (size_t i = 0; i < g->count; i++) {
        bat_text_string(text, i > 0 ? ",[" : "[[");
        bat_text_number(text, g->stops[i].at);
        bat_colour_write(text, ",", g->stops[i].colour);
        bat_text_string(text, "]");
    }
    bat_text_string(text, "]");
    if (g->tile) {
        char digest[17];
        bat_digest_print(bat_picture_digest(g->tile), digest);
        bat_text_string(text, ",\"tile\":");
        bat_text_json_string(text, digest);
    }
    bat_text_string(text, "}");
}

void bat_paint_to_json(const bat_paint *paint, bat_text *text) {
    const char *comma = "";
    bat_text_string(text, ",\n  \"paint\":{");
    if (paint->fill.count) {
        write_gradient(text, "\"fill\":{", &paint->fill);
        comma = ",";
    }
    if (paint->stroke.count) {
        bat_text_string(text, comma);
        write_gradient(text, "\"stroke\":{", &paint->stroke);
        comma = ",";
    }
    if (paint->dash_count) {
        bat_text_string(text, comma);
        bat_text_numbers(text, "\"dashes\":", paint->dashes, (int)paint->dash_count);
        bat_text_string(text, ",\"dash_offset\":");
        bat_text_number(text, paint->dash_offset);
        comma = ",";
    }
    if (paint->pen[0] != 0 || paint->pen[1] != 0 || paint->pen[2] != 0 || paint->pen[3] != 0) {
        bat_text_string(text, comma);
        bat_text_numbers(text, "\"pen\":", paint->pen, 4);
        comma = ",";
    }
    if (paint->stroke_first) {
        bat_text_string(text, comma);
        bat_text_string(text, "\"stroke_first\":true");
        comma = ",";
    }
    for (size_t i = 0; i < paint->width_count; i++) {
        bat_text_string(text, i > 0 ? ",[" : comma);
        if (i == 0) bat_text_string(text, "\"widths\":[[");
        bat_text_number(text, paint->widths[i].at);
        bat_text_string(text, ",");
        bat_text_number(text, paint->widths[i].share);
        bat_text_string(text, i + 1 < paint->width_count ? "]" : "]]");
    }
    bat_text_string(text, "}");
}
