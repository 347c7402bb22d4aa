/* A rectangle, an ellipse or a polygon whose numbers stay editable and give its one curve. */
#include "base/pose.h"
#include "kinds/primitive.h"
#include "curve/curve.h"
#include "document/digest.h"
#include "format/json/fields.h"
#include "format/json/style.h"
#include "format/json/word.h"
#include "kinds/kinds.h"
#include "text/text.h"

static const char *const kind_words[] = {"rectangle", "ellipse", "polygon", NULL};
static const char *const ends_words[] = {"pie", "chord", "open", NULL};

static bat_status make(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                       const bat_primitive *primitive, bat_object **out) {
    bat_curve *curve = NULL;
    bat_status status = bat_primitive_curve(primitive, &curve);
    if (status != BAT_OK) return status;
    status = object ? bat_object_remake(object, &bat_kind_of_primitive, primitive, 1, &curve, out)
                    : bat_object_make(&bat_kind_of_primitive, id, name, style, primitive, 1, &curve, out);
    if (status != BAT_OK) bat_curve_free(curve);
    return status;
}

bat_status bat_object_create_primitive(bat_id id, const char *name, const bat_style *style,
                                       const bat_primitive *primitive, bat_object **out) {
    return style && primitive && out ? make(NULL, id, name, style, primitive, out) : BAT_ARGUMENT;
}

bat_status bat_object_with_primitive(const bat_object *object, const bat_primitive *primitive,
                                     bat_object **out) {
    if (!object || !primitive || !out || !bat_object_is_made_of_curves(object)) return BAT_ARGUMENT;
    return make(object, 0, NULL, NULL, primitive, out);
}

const char *bat_primitive_name(const bat_primitive *p) { return kind_words[p->kind]; }

const bat_primitive *bat_object_primitive(const bat_object *object) {
    return bat_object_own(object, &bat_kind_of_primitive);
}

static uint64_t digest(uint64_t digest, const void *own) {
    const bat_primitive *p = own;
    digest = bat_digest_number(digest, (uint64_t)p->kind);
    for (int i = 0; i < 6; i++) digest = bat_digest_double(digest, p->place[i]);
    for (int i = 0; i < 2; i++) digest = bat_digest_double(digest, p->radii[i]);
    digest = bat_digest_double(bat_digest_double(digest, p->start), p->sweep);
    digest = bat_digest_number(bat_digest_number(digest, (uint64_t)p->ends), (uint64_t)p->sides);
    return bat_digest_double(bat_digest_double(digest, p->depth), p->roundness);
}

static const char *check(const bat_object *object) {
    bat_curve *again = NULL;
    const bat_status status = bat_primitive_curve(bat_object_primitive(object), &again);
    if (status == BAT_MEMORY) return NULL;
    if (status != BAT_OK) return "the numbers of a shape are out of range";
    const bool same = bat_object_curve_count(object) == 1 &&
                      bat_curve_is_equal(bat_object_curve(object, 0), again);
    bat_curve_free(again);
    return same ? NULL : "the curve of a shape is not the one its numbers give";
}

static bat_status transform(const bat_object *object, const double rows[12], bat_object **out) {
    bat_primitive image;
    double m[6];
    *out = NULL;
    if (!bat_pose_in_plane(rows, m) || !bat_primitive_map(bat_object_primitive(object), m, &image))
        return BAT_OK;
    const bat_status status = make(object, 0, NULL, NULL, &image, out);
    return status == BAT_MEMORY ? status : BAT_OK;
}

/* ---- files: numbers that are as they mostly are, are left out ---- */

/* Those that are one number each, of which kind, and their range. */
static const struct {
    const char *name, *expected;
    bat_primitive_kind of;
    double usual, low, high;
} numbers[] = {{"start", "degrees from 0 to 360", BAT_ELLIPSE, 0, 0, 360},
               {"sweep", "degrees from 0 to 360", BAT_ELLIPSE, 360, 0, 360},
               {"sides", "a whole number from 3 to 1000", BAT_POLYGON, 6, BAT_SIDES_MIN, BAT_SIDES_MAX},
               {"depth", "a share from 0 to 1", BAT_POLYGON, 0, 0, 1},
               {"roundness", "a share from 0 to 1", BAT_POLYGON, 0, 0, 1}};
enum { NUMBERS = sizeof numbers / sizeof *numbers };

static bat_status read_numbers(const bat_fields *f, uint32_t node, bat_primitive *p) {
    double values[NUMBERS] = {0};
    int ends = BAT_ARC_PIE;
    bat_status status = bat_fields_numbers(f, node, "place", 6, "six numbers", p->place);
    if (status == BAT_OK && p->kind == BAT_RECTANGLE && bat_json_member(f->json, node, "radii"))
        status = bat_fields_numbers(f, node, "radii", 2, "two numbers", p->radii);
    if (status == BAT_OK)
        status = bat_word_from_json(f->json, node, "ends", ends_words, "\"pie\", \"chord\" or \"open\"",
                                    &ends, f->problem);
    for (int i = 0; i < NUMBERS && status == BAT_OK; i++) {
        if (numbers[i].of != p->kind) continue;
        values[i] = numbers[i].usual;
        status = bat_fields_number(f, node, numbers[i].name, numbers[i].low, numbers[i].high,
                                   numbers[i].expected, &values[i]);
    }
    if (status != BAT_OK) return status;
    p->start = values[0], p->sweep = values[1], p->sides = (int)values[2];
    p->depth = values[3], p->roundness = values[4];
    p->ends = (bat_arc_ends)ends;
    return BAT_OK;
}

static bat_status read(const bat_fields *f, uint32_t node, bat_id id, const char *name, bat_object **out) {
    static const char expected[] = "\"rectangle\", \"ellipse\" or \"polygon\"";
    bat_style style = bat_style_defaults();
    bat_primitive p = {0};
    int kind = BAT_PRIMITIVE_KINDS;
    bat_status status = bat_style_from_json(f, node, &style);
    const uint32_t member = bat_json_member(f->json, node, "primitive");
    if (status != BAT_OK) return status;
    if (!member) return bat_fields_complain(f, node, "primitive", "an object");
    status = bat_word_from_json(f->json, member, "is", kind_words, expected, &kind, f->problem);
    if (status == BAT_OK && kind == BAT_PRIMITIVE_KINDS)
        return bat_fields_complain(f, member, "is", expected);
    p.kind = (bat_primitive_kind)kind;
    if (status == BAT_OK) status = read_numbers(f, member, &p);
    if (status != BAT_OK) return status;
    return bat_fields_say(f, member, bat_object_create_primitive(id, name, &style, &p, out));
}

static void write(const bat_object *object, bat_text *text) {
    const bat_primitive *p = bat_object_primitive(object);
    const double values[NUMBERS] = {p->start, p->sweep, p->sides, p->depth, p->roundness};
    bat_text_string(text, ",\n  \"style\":");
    bat_style_to_json(bat_object_style(object), text);
    bat_text_string(text, ",\n  \"primitive\":{\"is\":\"");
    bat_text_string(text, bat_primitive_name(p));
    bat_text_numbers(text, "\",\"place\":", p->place, 6);
    if (p->radii[0] > 0 || p->radii[1] > 0) bat_text_numbers(text, ",\"radii\":", p->radii, 2);
    for (int i = 0; i < NUMBERS; i++) {
        if (numbers[i].of != p->kind || values[i] == numbers[i].usual) continue;
        bat_text_string(text, ",\"");
        bat_text_string(text, numbers[i].name);
        bat_text_string(text, "\":");
        bat_text_number(text, values[i]);
    }
    if (p->ends != BAT_ARC_PIE) {
        bat_text_string(text, ",\"ends\":\"");
        bat_text_string(text, ends_words[p->ends]);
        bat_text_string(text, "\"");
    }
    bat_text_string(text, "}");
}

const bat_kind_type bat_kind_of_primitive = {.number = BAT_KIND_PRIMITIVE,
                                             .name = "primitive",
                                             .traits = BAT_DRAWN | BAT_CURVES | BAT_MADE | BAT_PLAIN,
                                             .size = sizeof(bat_primitive),
                                             .check = check,
                                             .digest = digest,
                                             .transform = transform,
                                             .write = write,
                                             .read = read};
