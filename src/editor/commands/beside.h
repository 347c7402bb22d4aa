/* What the commands share that make objects beside those selected. */
#ifndef BATTEN_EDITOR_COMMANDS_BESIDE_H
#define BATTEN_EDITOR_COMMANDS_BESIDE_H

#include "document/document.h"
#include "editor/session/context.h"
#include "editor/tables/tables.h"

/* What came of all objects: how many the command is for, and how many new ones were made. */
typedef struct bat_beside {
    int fit, count;
} bat_beside;

/* Makes what there is to make from the object at the index, within a transaction. */
typedef bat_status bat_beside_maker(bat_context *c, int index, bat_beside *made);

/* Makes from each member of the selection, the topmost first, as one step of that name; what is made is selected. Where nothing comes
 * of it nothing changes, and a notice says why; unfit: that the command is for none of them. */
bat_status bat_beside_each(bat_context *c, bat_beside_maker *make, bat_string label, bat_string unfit);
/* Within it: a copy of the object, with an id of its own, at that index. */
bat_status bat_beside_insert(bat_context *c, int index, const bat_object *object, bat_beside *made);

#endif
