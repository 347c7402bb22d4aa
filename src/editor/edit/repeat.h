/* The last transform of the selection, repeated: on the selection, or, after something was copied, on one more copy. */
#ifndef BATTEN_EDITOR_EDIT_REPEAT_H
#define BATTEN_EDITOR_EDIT_REPEAT_H

#include "editor/session/context.h"

/* As one step. Of something else than before it is repeated at the same place of its box. BAT_STATE: there is nothing to repeat, or
 * nothing is selected. */
bat_status bat_repeat(bat_context *c);

#endif
