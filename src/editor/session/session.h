/* What is being worked on: the document, its history, and its journal. */
#ifndef BATTEN_EDITOR_SESSION_SESSION_H
#define BATTEN_EDITOR_SESSION_SESSION_H

#include "curve/mirror.h"
#include "document/picture.h"
#include "editor/session/context.h"
#include "editor/session/history.h"
#include "editor/session/journal.h"
#include "editor/session/transaction.h"
#include "format/json/losses.h"
#include "text/text.h"

typedef struct bat_session {
    bat_document *document;
    char *name;
    uint64_t revision; /* grows with every change of the document */
    bat_history history;
    uint64_t saved_state,
        asked_state; /* states of the history: saved last; when the host last accepted a save request */
    bool asked;
    bat_transaction transaction;
    bat_journal journal;
    bat_pictures pictures;           /* those whose bytes the journal holds */
    bat_mirror axis;                 /* of symmetry, when one is chosen */
    bat_losses losses;               /* what the document does not hold of the file that was opened */
    bool busy;                       /* the tool is between pen down and pen up; set after each event */
    void (*stepped)(bat_context *c); /* called after each step that was made or undone */
    bat_status (*mirror)(bat_context *c,
                         bat_string step); /* called before a tool's step is made, while symmetry is on */
    bool partly; /* a journal is replayed of which steps may have been left out (record_replay.c) */
    bool read_only;
    bool refused;      /* this event would have changed a read-only document; the user is notified */
    uint64_t followed; /* the revision for which bat_transaction_follow was called last */
    bat_string
        freed; /* this event made a spline a plain curve, or freed a surface: the notice, which comes before all
                        * others; BAT_STRING_COUNT: neither */
} bat_session;

/* Takes ownership of the document, with a journal that begins with it. On failure everything is unchanged. */
bat_status bat_session_open(bat_session *session, bat_document *document, const char *name);
void bat_session_free(bat_session *session);
/* True when the document is read-only; also tells the user so, whatever else the event has to say. */
bool bat_session_refuses(bat_context *c);

/* Writes a journal's first line and lists the pictures the journal holds. On failure the caller frees both. */
bat_status bat_session_begin_journal(const bat_document *document, const char *name, bat_journal *journal,
                                     bat_pictures *pictures);
/* Appends a line to the journal, given without the digest and the closing brace, and frees it. document: its state
 * after the change. */
bat_status bat_session_log(bat_session *session, bat_text *line, const bat_document *document);
/* Makes sure that the journal holds the picture's bytes, on a line of their own. Returns as bat_pictures_add. */
bat_status bat_session_keep_picture(bat_session *session, const bat_picture *picture);
/* The same for all pictures of an object; NULL: none. */
bat_status bat_session_keep_pictures(bat_session *session, const bat_object *object);
/* Records the losses, in the journal too. NULL: none. */
bat_status bat_session_set_losses(bat_session *session, const bat_losses *losses);
/* Sets the axis of symmetry, in the journal too. Off: no axis is chosen. BAT_NUMBER: not a valid axis. */
bat_status bat_session_set_axis(bat_session *session, const bat_mirror *axis);
/* Compacts the journal: see bat_editor_compact. */
bat_status bat_session_compact(bat_session *session);

#endif
