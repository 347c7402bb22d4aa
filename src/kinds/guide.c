/* A guide: an infinite vertical or horizontal line that paints nothing. */
#include "base/pose.h"
#include "document/digest.h"
#include "format/json/fields.h"
#include "kinds/kinds.h"
#include "text/text.h"

#include <math.h>

typedef struct guide {
    int axis; /* 0: the line x = at; 1: y = at */
    double at;
} guide;

bat_status bat_object_create_guide(bat_id id, int axis, double at, bat_object **out) {
    if (axis < 0 || axis > 1) return BAT_ARGUMENT;
    if (!(fabs(at) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    return bat_object_make(&bat_kind_of_guide, id, NULL, NULL, &(guide){axis, at}, 0, NULL, out);
}

bat_status bat_object_with_guide(const bat_object *object, double at, bat_object **out) {
    const guide *g = object ? bat_object_own(object, &bat_kind_of_guide) : NULL;
    if (!g) return BAT_ARGUMENT;
    if (!(fabs(at) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    return bat_object_remake(object, &bat_kind_of_guide, &(guide){g->axis, at}, 0, NULL, out);
}

int bat_object_guide(const bat_object *object, double *at) {
    const guide *g = bat_object_own(object, &bat_kind_of_guide);
    if (g) *at = g->at;
    return g ? g->axis : -1;
}

static uint64_t digest_guide(uint64_t digest, const void *own) {
    const guide *g = own;
    return bat_digest_double(bat_digest_number(digest, (uint64_t)g->axis), g->at);
}

/* A guide stays vertical or horizontal even when the matrix rotates. */
static bat_status transform(const bat_object *object, const double rows[12], bat_object **out) {
    const guide *g = bat_object_own(object, &bat_kind_of_guide);
    return bat_object_with_guide(object, g->at * rows[5 * g->axis] + rows[4 * g->axis + 3], out);
}

static void write(const bat_object *object, bat_text *text) {
    const guide *g = bat_object_own(object, &bat_kind_of_guide);
    bat_text_string(text, g->axis ? ",\"y\":" : ",\"x\":");
    bat_text_number(text, g->at);
}

static bat_status read(const bat_fields *f, uint32_t node, bat_id id, const char *name, bat_object **out) {
    guide g = {bat_json_member(f->json, node, "x") ? 0 : 1, NAN};
    bat_status status = bat_fields_number(f, node, g.axis ? "y" : "x", -BAT_COORDINATE_MAX,
                                          BAT_COORDINATE_MAX, "a number", &g.at);
    if (status != BAT_OK) return status;
    if (isnan(g.at)) return bat_fields_complain(f, node, "guide", "x or y");
    status = bat_object_make(&bat_kind_of_guide, id, name, NULL, &g, 0, NULL, out);
    return bat_fields_say(f, node, status);
}

const bat_kind_type bat_kind_of_guide = {.number = BAT_KIND_GUIDE,
                                         .name = "guide",
                                         .size = sizeof(guide),
                                         .digest = digest_guide,
                                         .transform = transform,
                                         .write = write,
                                         .read = read};
