/* What a file holds that a document cannot: counts by kind, as stored in journals. */
#ifndef BATTEN_FORMAT_JSON_LOSSES_H
#define BATTEN_FORMAT_JSON_LOSSES_H

#include "text/json.h"
#include "text/text.h"

#include <batten/format.h>

/* Writes {"gradients":3,"texts":1}; the second call reads it back and skips unknown names and values that are
 * not counts. */
void bat_losses_to_json(const bat_losses *losses, bat_text *text);
void bat_losses_from_json(const bat_json *json, uint32_t node, bat_losses *losses);

#endif
