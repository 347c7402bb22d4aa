/* Containers: groups, and layers, which lie at the top level or in other layers. */
#include "kinds/kinds.h"

const bat_kind_type bat_kind_of_group = {.number = BAT_KIND_GROUP, .name = "group", .traits = BAT_HOLDS};
const bat_kind_type bat_kind_of_layer = {
    .number = BAT_KIND_LAYER, .name = "layer", .traits = BAT_HOLDS | BAT_LAYER};

bat_status bat_object_create_group(bat_id id, const char *name, bool layer, bat_object **out) {
    return bat_object_make(layer ? &bat_kind_of_layer : &bat_kind_of_group, id, name, NULL, NULL, 0, NULL,
                           out);
}
