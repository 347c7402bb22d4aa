/* What a file holds that a document cannot: counts by kind, as stored in journals. */
#ifndef BATTEN_FORMAT_JSON_LOSSES_H
#define BATTEN_FORMAT_JSON_LOSSES_H

#include "text/json.h"
#include "text/text.h"

#include <batten/format.h>

/* Writes {"gradients":3,"texts":1}; the second call reads it back and skips unknown names and values that are
 * not counts. */
/* True if what has such a loss may look otherwise than in the file; false for what makes no picture: metadata, titles, settings of
 * other programs, unused definitions, what is hidden. */
bool bat_loss_is_seen(bat_loss kind);
/* Those of them that are seen; the others are 0. */
bat_losses bat_losses_seen(const bat_losses *losses);
/* What to tell the user: how many things overwriting the file would lose; where the document keeps its file, how many objects look
 * otherwise than in it, or, where there is none of them, how many other things do. */
int bat_losses_told(const bat_losses *losses, const bat_document *document);

void bat_losses_to_json(const bat_losses *losses, bat_text *text);
void bat_losses_from_json(const bat_json *json, uint32_t node, bat_losses *losses);

#endif
