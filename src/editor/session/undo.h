/* One step of the history back or forth, with its line in the journal, so that replay arrives at the same place. */
#ifndef BATTEN_EDITOR_SESSION_UNDO_H
#define BATTEN_EDITOR_SESSION_UNDO_H

#include "editor/session/context.h"

/* BAT_STATE: there is none, or the document is read-only. */
bat_status bat_session_step(bat_context *c, bool back);

#endif
