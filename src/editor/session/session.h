/* What is being drawn on: the document, what leads to it and back, and the journal of it. */
#ifndef BATTEN_EDITOR_SESSION_SESSION_H
#define BATTEN_EDITOR_SESSION_SESSION_H

#include "curve/mirror.h"
#include "document/picture.h"
#include "editor/session/context.h"
#include "editor/session/history.h"
#include "editor/session/journal.h"
#include "editor/session/transaction.h"
#include "format/svg/losses.h"
#include "text/text.h"

typedef struct bat_session {
    bat_document *document;
    char *name;
    uint64_t revision; /* grows with every change of the document */
    bat_history history;
    uint64_t saved_state,
        asked_state; /* states of the history: on disk; when the host last took a save request */
    bool asked;
    bat_transaction transaction;
    bat_journal journal;
    bat_pictures pictures;           /* whose bytes the journal holds */
    bat_mirror axis;                 /* of symmetry, when one was chosen */
    bat_losses losses;               /* of the file that was opened: what the document does not hold */
    bool busy;                       /* the tool is between down and up: set after each event */
    void (*stepped)(bat_context *c); /* called after each step that was made or taken back */
    bat_status (*mirror)(bat_context *c,
                         bat_string step); /* called before a tool's step is made, while symmetry is on */
    bool read_only;
    bool refused; /* this event would have changed something, which the user is told */
    bool freed;   /* this event has made a plain curve of a spline, which the user is told before all else */
} bat_session;

/* Takes the document over, with a journal that begins with it. On failure all is as it was. */
bat_status bat_session_open(bat_session *session, bat_document *document, const char *name);
void bat_session_free(bat_session *session);
/* The document is read-only, and the user is told: whatever the event has to say besides. */
bool bat_session_refuses(bat_context *c);

/* A journal's first line, and the pictures it holds. On failure the caller frees both. */
bat_status bat_session_begin_journal(const bat_document *document, const char *name, bat_journal *journal,
                                     bat_pictures *pictures);
/* A journal's line, given without the digest and the closing brace; frees it. document: as it is after it. */
bat_status bat_session_log(bat_session *session, bat_text *line, const bat_document *document);
/* Sees to it that the journal holds the picture's bytes, as a line of their own. What bat_pictures_add says. */
bat_status bat_session_keep_picture(bat_session *session, const bat_picture *picture);
/* Notes them, in the journal too. NULL: none. */
bat_status bat_session_set_losses(bat_session *session, const bat_losses *losses);
/* The axis of symmetry, in the journal too. Off: none is chosen. BAT_NUMBER: no axis. */
bat_status bat_session_set_axis(bat_session *session, const bat_mirror *axis);
/* The journal made short: what bat_editor_compact says. */
bat_status bat_session_compact(bat_session *session);

#endif
