/* Undoes or redoes one step, and adds its line to the journal, so that replay arrives at the same state. */
#ifndef BATTEN_EDITOR_SESSION_UNDO_H
#define BATTEN_EDITOR_SESSION_UNDO_H

#include "editor/session/context.h"

/* BAT_STATE: there is no such step, or the document is read-only. */
bat_status bat_session_step(bat_context *c, bool back);

#endif
