#include "format/json/bound.h"
#include "document/kind.h"
#include "format/json/blend.h"
#include "format/json/curve.h"
#include "format/json/function.h"
#include "format/json/word.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What is read: the wires own their curves. */
typedef struct reading {
    int count;
    bat_id ids[BAT_BOUND_WIRES], domains[BAT_BOUND_WIRES];
    bat_wire wires[BAT_BOUND_WIRES];
    bat_wire_options options;
    bool flat;
    double *rest;
} reading;

static void clear(reading *r) {
    for (int i = 0; i < r->count; i++) {
        bat_curve_free((bat_curve *)r->wires[i].reference), bat_curve_free((bat_curve *)r->wires[i].domain);
        bat_function_clear(&r->wires[i].radius), bat_function_clear(&r->wires[i].scale);
    }
    free(r->rest);
}

static bat_status read_curve(const bat_fields *f, uint32_t node, const char *name, bool needed,
                             const bat_curve **out) {
    const uint32_t member = bat_json_member(f->json, node, name);
    bat_curve *curve = NULL;
    if (!member && !needed) return BAT_OK;
    if (!member) return bat_fields_complain(f, node, name, "a curve");
    const bat_status status = bat_curve_from_json(f->json, member, &curve, f->problem);
    *out = curve;
    return status;
}

static bat_status read_wire(const bat_fields *f, uint32_t node, reading *r) {
    bat_wire *wire = &r->wires[r->count];
    bat_id *domain = &r->domains[r->count], *id = &r->ids[r->count++];
    *wire = (bat_wire){.scale = bat_function_of(1)};
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node, "wires", "an object");
    bat_status status = bat_fields_id(f, node, "curve", BAT_ID_MAX, id);
    if (status == BAT_OK && *id == 0) status = bat_fields_complain(f, node, "curve", "the id of an object");
    for (int i = 0; i + 1 < r->count && status == BAT_OK; i++)
        if (r->ids[i] == *id)
            status = bat_fields_complain(f, bat_json_member(f->json, node, "curve"), "curve",
                                         "an object that is no other wire");
    if (status == BAT_OK) status = read_curve(f, node, "reference", true, &wire->reference);
    if (status == BAT_OK) status = read_curve(f, node, "domain", false, &wire->domain);
    if (status == BAT_OK) status = bat_fields_id(f, node, "domain_curve", BAT_ID_MAX, domain);
    if (status == BAT_OK && *domain && !wire->domain)
        status = bat_fields_complain(f, node, "domain", "a curve");
    if (status == BAT_OK) status = bat_fields_function(f, node, "radius", &wire->radius);
    if (status == BAT_OK) status = bat_fields_function(f, node, "scale", &wire->scale);
    if (status == BAT_OK) status = bat_turn_read(f, node, &wire->turn);
    return status;
}

static bat_status read_wires(const bat_fields *f, uint32_t node, reading *r) {
    const uint32_t list = bat_json_member(f->json, node, "wires");
    const uint32_t count = bat_json_count(f->json, list);
    if (count == 0 || count > BAT_BOUND_WIRES)
        return bat_fields_complain(f, list ? list : node, "wires", "a list of 1 to 16 wires");
    bat_status status = BAT_OK;
    for (uint32_t at = bat_json_first(f->json, list); at && status == BAT_OK; at = f->json->nodes[at].next)
        status = read_wire(f, at, r);
    return status;
}

/* Four numbers: which point, and where it was. */
static bat_status read_place(const bat_fields *f, uint32_t node, size_t count, double *rest) {
    static const char expected[] = "lists of four numbers: a point, x, y, z";
    double numbers[4];
    int k = 0;
    for (uint32_t at = bat_json_first(f->json, node); at; at = f->json->nodes[at].next) {
        if (k == 4 || bat_json_type_of(f->json, at) != BAT_JSON_NUMBER)
            return bat_fields_complain(f, node, "rest", expected);
        numbers[k++] = f->json->nodes[at].value.number;
    }
    if (k < 4 || !(numbers[0] >= 0 && numbers[0] < (double)count) || numbers[0] != floor(numbers[0]))
        return bat_fields_complain(f, node, "rest", expected);
    for (k = 1; k < 4; k++)
        if (!(fabs(numbers[k]) <= BAT_COORDINATE_MAX))
            return bat_fields_complain(f, node, "rest", "numbers up to 1e75");
    memcpy(rest + 3 * (size_t)numbers[0], numbers + 1, 3 * sizeof *rest);
    return BAT_OK;
}

static bat_status read_rest(const bat_fields *f, uint32_t node, size_t count, const double *points,
                            reading *r) {
    const uint32_t list = bat_json_member(f->json, node, "rest");
    r->rest = malloc((3 * count + 1) * sizeof *r->rest);
    if (!r->rest) return bat_fields_say(f, node, BAT_MEMORY);
    memcpy(r->rest, points, 3 * count * sizeof *points);
    bat_status status = BAT_OK;
    for (uint32_t at = bat_json_first(f->json, list); at && status == BAT_OK; at = f->json->nodes[at].next)
        status = read_place(f, at, count, r->rest);
    return status;
}

static bat_status read_bound(const bat_fields *f, uint32_t node, size_t count, const double *points,
                             bat_bound **out) {
    reading r = {.count = 0};
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node, "bound", "an object");
    bat_status status = read_wires(f, node, &r);
    if (status == BAT_OK) status = bat_blend_read(f, node, &r.options);
    if (status == BAT_OK) status = bat_fields_flag(f, node, "flat", &r.flat);
    if (status == BAT_OK) status = read_rest(f, node, count, points, &r);
    if (status == BAT_OK) {
        status = bat_bound_create((size_t)r.count, r.wires, r.ids, r.domains, &r.options, count, r.rest,
                                  r.flat, out, NULL);
        if (status == BAT_PARAMETER)
            status = bat_fields_complain(f, bat_json_member(f->json, node, "wires"), "radius",
                                         "one above 0 everywhere");
        else if (status != BAT_OK)
            bat_fields_say(f, node, status);
    }
    clear(&r);
    return status;
}

/* domain: the id of the object whose curve its domain curve is, 0: of none. */
static void write_wire(const bat_wire *wire, bat_id id, bat_id domain, bat_text *text) {
    bat_text_string(text, "{\"curve\":");
    bat_text_integer(text, id);
    bat_text_string(text, ",\"radius\":");
    bat_function_to_json(&wire->radius, text);
    if (wire->scale.curve || wire->scale.constant != 1) {
        bat_text_string(text, ",\"scale\":");
        bat_function_to_json(&wire->scale, text);
    }
    bat_turn_write(wire->turn, text);
    bat_text_string(text, ",\n   \"reference\":");
    bat_curve_to_json(wire->reference, 4, text);
    if (wire->domain) {
        bat_text_string(text, ",\n   \"domain\":");
        bat_curve_to_json(wire->domain, 4, text);
    }
    if (domain) bat_text_string(text, ",\n   \"domain_curve\":"), bat_text_integer(text, domain);
    bat_text_string(text, "}");
}

static void write_rest(const bat_bound *bound, const double *points, bat_text *text) {
    bool any = false;
    for (size_t i = 0; i < bound->point_count; i++) {
        const double *rest = bound->rest + 3 * i;
        if (memcmp(rest, points + 3 * i, 3 * sizeof *rest) == 0) continue;
        bat_text_string(text, any ? "],[" : ",\n  \"rest\":[[");
        bat_text_integer(text, i);
        for (int k = 0; k < 3; k++) bat_text_string(text, ","), bat_text_number(text, rest[k]);
        any = true;
    }
    if (any) bat_text_string(text, "]]");
}

static void write_bound(const bat_bound *bound, const double *points, bat_text *text) {
    int next = bound->count; /* of the sources that are domain curves */
    bat_text_string(text, "{\"wires\":[");
    for (int i = 0; i < bound->count; i++) {
        const bool follows = next < bound->source_count && bound->bounds[next] == i;
        if (i > 0) bat_text_string(text, ",\n  ");
        write_wire(&bound->wires[i], bound->ids[i], follows ? bound->ids[next++] : 0, text);
    }
    bat_text_string(text, "],\n  \"blend\":");
    bat_blend_write(&bound->options, text);
    if (bound->flat) bat_text_string(text, ",\"flat\":true");
    write_rest(bound, points, text);
    bat_text_string(text, "}");
}

/* Where the points of an object are; the caller frees them. */
static double *points_of(const bat_object *object, size_t *count) {
    const bat_kind_type *type = bat_object_type(object);
    *count = type->points(object, NULL);
    double *points = malloc((3 * *count + 1) * sizeof *points);
    if (points) type->points(object, points);
    return points;
}

bat_status bat_bound_read(const bat_fields *f, uint32_t node, bat_object **object) {
    const uint32_t member = bat_json_member(f->json, node, "bound");
    bat_hold hold = {.bound = NULL};
    bat_object *made = NULL;
    size_t count;
    if (!member) return BAT_OK;
    double *now = points_of(*object, &count);
    bat_status status = now ? read_bound(f, member, count, now, &hold.bound)
                            : bat_fields_say(f, member, BAT_MEMORY);
    if (status == BAT_OK)
        status = bat_fields_say(f, member, bat_object_type(*object)->put(*object, now, &hold, &made));
    bat_object_release(*object);
    *object = made; /* NULL after a failure */
    bat_bound_release(hold.bound);
    free(now);
    return status;
}

void bat_bound_write(const bat_object *object, bat_text *text) {
    const bat_hold *hold = bat_object_hold(object);
    size_t count;
    if (!hold) return;
    double *now = points_of(object, &count);
    if (!now) {
        text->failed = true;
        return;
    }
    bat_text_string(text, ",\n  \"bound\":");
    write_bound(hold->bound, now, text);
    free(now);
}
