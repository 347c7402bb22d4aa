/* The axis of symmetry in lines of the journal (docs/journal.md). */
#ifndef BATTEN_EDITOR_EDIT_MIRROR_RECORD_H
#define BATTEN_EDITOR_EDIT_MIRROR_RECORD_H

#include "curve/mirror.h"
#include "text/json.h"
#include "text/text.h"

/* The member "mirror" after others; nothing when it is off. */
void bat_mirror_write(const bat_mirror *mirror, bat_text *line);
/* Without the member: off. */
bat_status bat_mirror_read(const bat_json *json, uint32_t object, bat_mirror *out, bat_problem *problem);

#endif
