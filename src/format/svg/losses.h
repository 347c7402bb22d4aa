/* What a file holds that a document can not: counted kinds, as journals keep them. */
#ifndef BATTEN_FORMAT_SVG_LOSSES_H
#define BATTEN_FORMAT_SVG_LOSSES_H

#include "text/json.h"
#include "text/text.h"

#include <batten/format.h>

/* {"gradients":3,"texts":1}, and back: what is none of ours, or no count, is skipped. */
void bat_losses_to_json(const bat_losses *losses, bat_text *text);
void bat_losses_from_json(const bat_json *json, uint32_t node, bat_losses *losses);

#endif
