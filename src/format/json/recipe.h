/* Internal: how a surface is made from curves, in JSON: {"by":"sweep","from":[3,4],"stand":"across","twist":90,"scale":0.5}. */
#ifndef BATTEN_FORMAT_JSON_RECIPE_H
#define BATTEN_FORMAT_JSON_RECIPE_H

#include "format/json/fields.h"
#include "text/text.h"
#include <batten/document.h>

/* ids: room for BAT_RECIPE_CURVES. */
bat_status bat_recipe_from_json(const bat_fields *f, uint32_t node, bat_recipe *recipe, bat_id *ids,
                                int *count);
void bat_recipe_to_json(const bat_recipe *recipe, int count, const bat_id *ids, bat_text *text);

#endif
