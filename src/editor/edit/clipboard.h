/* Cut, copy and paste: the clipboard holds documents of their own in the native format. */
#ifndef BATTEN_EDITOR_EDIT_CLIPBOARD_H
#define BATTEN_EDITOR_EDIT_CLIPBOARD_H

#include "editor/session/context.h"

typedef struct bat_clipboard {
    int pastes;          /* pastes since the last copy */
    uint64_t pasted;     /* digest of the last paste; 0: something was copied since */
    bool paste_in_place; /* for the next paste, whatever is held */
} bat_clipboard;

bat_status bat_clipboard_copy(bat_context *c, bool cut, char **text, size_t *size);
bat_status bat_clipboard_paste(bat_context *c, const bat_document *document, bool own);

#endif
