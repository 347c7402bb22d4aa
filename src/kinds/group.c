/* Containers: groups, and layers, which lie at the top level or in other layers. */
#include "format/json/fields.h"
#include "kinds/kinds.h"
#include "text/text.h"

static void write(const bat_object *object, bat_text *text) {
    if (bat_object_style(object)->opacity == 1) return;
    bat_text_string(text, ",\"opacity\":");
    bat_text_number(text, bat_object_style(object)->opacity);
}

static bat_status read(const bat_kind_type *type, const bat_fields *f, uint32_t node, bat_id id,
                       const char *name, bat_object **out) {
    bat_style style = bat_style_defaults();
    const bat_status status = bat_fields_number(f, node, "opacity", 0, 1, "a number from 0 to 1",
                                                &style.opacity);
    if (status != BAT_OK) return status;
    return bat_fields_say(f, node, bat_object_make(type, id, name, &style, NULL, 0, NULL, out));
}

static bat_status read_group(const bat_fields *f, uint32_t node, bat_id id, const char *name,
                             bat_object **out) {
    return read(&bat_kind_of_group, f, node, id, name, out);
}

static bat_status read_layer(const bat_fields *f, uint32_t node, bat_id id, const char *name,
                             bat_object **out) {
    return read(&bat_kind_of_layer, f, node, id, name, out);
}

const bat_kind_type bat_kind_of_group = {
    .number = BAT_KIND_GROUP, .name = "group", .traits = BAT_HOLDS, .write = write, .read = read_group};
const bat_kind_type bat_kind_of_layer = {.number = BAT_KIND_LAYER,
                                         .name = "layer",
                                         .traits = BAT_HOLDS | BAT_LAYER,
                                         .write = write,
                                         .read = read_layer};

bat_status bat_object_create_group(bat_id id, const char *name, bool layer, bat_object **out) {
    return bat_object_make(layer ? &bat_kind_of_layer : &bat_kind_of_group, id, name, NULL, NULL, 0, NULL,
                           out);
}
