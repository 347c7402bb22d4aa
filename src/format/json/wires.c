/* WIRES as JSON: {"wires":[{"reference":CURVE, "curve":CURVE, "radius":FUNCTION, "scale":FUNCTION, "domain":CURVE,
 * "turn":"tangent"}, ...], "blend":{"kind":"cross", "exponent":1}}. */
#include "format/json/blend.h"
#include "format/json/curve.h"
#include "format/json/function.h"
#include "format/json/word.h"

#include <batten/format.h>
#include <batten/format_space.h>

#include <math.h>
#include <stdlib.h>

static const char *const CURVES[BAT_WIRE_CURVES] = {"reference", "curve", "domain"};

void bat_wires_source_clear(bat_wires_source *source) {
    if (!source) return;
    for (size_t i = 0; source->wires && i < source->count; i++) {
        bat_function_clear(&source->wires[i].radius);
        bat_function_clear(&source->wires[i].scale);
    }
    for (size_t i = 0; source->owned && i < BAT_WIRE_CURVES * source->count; i++)
        bat_curve_free(source->owned[i]);
    free(source->wires), free(source->curves), free(source->owned);
    *source = (bat_wires_source){.count = 0};
}

/* A radius that is a number has to be above 0; of others bat_wires_bind says so. */
static bat_status read_functions(const bat_fields *f, uint32_t node, bat_wire *out) {
    const uint32_t radius = bat_json_member(f->json, node, "radius");
    if (!radius) return bat_fields_complain(f, node, "radius", "a number above 0, or a function");
    bat_status status = bat_fields_function(f, node, "radius", &out->radius);
    if (status == BAT_OK) status = bat_fields_function(f, node, "scale", &out->scale);
    if (status == BAT_OK && !out->radius.curve && !(out->radius.constant > 0))
        status = bat_json_complain(f->json, radius, BAT_PARAMETER, "radius", "a number above 0", f->problem);
    return status;
}

/* The curve's domain and closedness have to be those of the reference. */
static bat_status compare(const bat_fields *f, uint32_t node, const bat_curve *reference,
                          const bat_curve *curve) {
    double a[2], b[2];
    bat_curve_domain(reference, a);
    bat_curve_domain(curve, b);
    if (bat_curve_is_closed(reference) != bat_curve_is_closed(curve))
        return bat_json_say(f->json, node, BAT_ARGUMENT,
                            "curve: expected one that is closed as the reference is, found the opposite",
                            f->problem);
    if (a[0] == b[0] && a[1] == b[1]) return BAT_OK;
    return bat_json_say(f->json, node, BAT_PARAMETER,
                        "curve: expected the domain of the reference, found another", f->problem);
}

static bat_status read_wire(const bat_fields *f, uint32_t node, size_t i, bat_wires_source *out) {
    bat_wire *wire = &out->wires[i];
    bat_curve **own = out->owned + BAT_WIRE_CURVES * i;
    *wire = (bat_wire){.scale = bat_function_of(1)};
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node, "wires", "an object");
    for (int k = 0; k < BAT_WIRE_CURVES; k++) {
        const uint32_t curve = bat_json_member(f->json, node, CURVES[k]);
        if (!curve && k < 2) return bat_fields_complain(f, node, CURVES[k], "a curve");
        bat_status status = curve ? bat_curve_from_json(f->json, curve, &own[k], f->problem) : BAT_OK;
        if (status != BAT_OK) return status;
    }
    wire->reference = own[0], out->curves[i] = own[1], wire->domain = own[2];
    bat_status status = compare(f, bat_json_member(f->json, node, "curve"), own[0], own[1]);
    if (status == BAT_OK) status = read_functions(f, node, wire);
    return status == BAT_OK ? bat_turn_read(f, node, &wire->turn) : status;
}

static bat_status read_wires(const bat_fields *f, bat_wires_source *out) {
    const uint32_t list = bat_json_member(f->json, 1, "wires");
    const size_t count = bat_json_count(f->json, list);
    if (count == 0)
        return bat_json_complain(f->json, list ? list : 1, BAT_SYNTAX, "wires", "a list of wires",
                                 f->problem);
    out->wires = calloc(count, sizeof *out->wires);
    out->curves = calloc(count, sizeof *out->curves);
    out->owned = calloc(BAT_WIRE_CURVES * count, sizeof *out->owned);
    if (!out->wires || !out->curves || !out->owned) return bat_fields_say(f, list, BAT_MEMORY);
    out->count = count;
    bat_status status = BAT_OK;
    size_t i = 0;
    for (uint32_t at = bat_json_first(f->json, list); at && status == BAT_OK; at = f->json->nodes[at].next)
        status = read_wire(f, at, i++, out);
    return status;
}

bat_status bat_wires_read(const char *text, size_t size, bat_wires_source *out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    const bat_fields f = {.json = &json, .problem = problem};
    bat_wires_source source = {.count = 0};
    status = bat_json_type_of(&json, 1) == BAT_JSON_OBJECT
                 ? BAT_OK
                 : bat_json_complain(&json, 1, BAT_SYNTAX, "wires", "an object", problem);
    if (status == BAT_OK) status = read_wires(&f, &source);
    if (status == BAT_OK) status = bat_blend_read(&f, 1, &source.options);
    bat_json_free(&json);
    if (status == BAT_OK)
        *out = source;
    else
        bat_wires_source_clear(&source);
    return status;
}
