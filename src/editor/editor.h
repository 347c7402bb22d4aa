/* The engine's state, and the calls between its parts. */
#ifndef BATTEN_SRC_EDITOR_H
#define BATTEN_SRC_EDITOR_H

#include "editor/session/history.h"
#include "editor/session/journal.h"
#include "document/picture.h"
#include "editor/tools/brushing.h"
#include "editor/input/contacts.h"
#include "editor/panels/first_hints.h"
#include "editor/tools/modes/guides.h"
#include "editor/show/inspect.h"
#include "editor/choice/isolation.h"
#include "editor/tools/levels/state.h"
#include "editor/session/journal_line.h"
#include "editor/panels/in_words.h"
#include "editor/show/overlay.h"
#include "editor/tools/pointing.h"
#include "editor/tools/modes/range.h"
#include "editor/scene/scene.h"
#include "editor/tools/selecting.h"
#include "editor/choice/selection.h"
#include "editor/tools/sketch/sketching.h"
#include "editor/pick/snap.h"
#include "editor/tools/tangents/state.h"
#include "editor/tables/tables.h"
#include "editor/input/taps.h"
#include "editor/tools/tool.h"
#include "editor/edit/pictures.h"
#include "editor/session/transaction.h"
#include "editor/view/unit.h"
#include "editor/view/view.h"
#include "editor/tools/modes/waypoints.h"
#include <batten/editor.h>

enum { BAT_KEYS_ROOM = 64, BAT_FIT_MARGIN = 32, BAT_NOTICE_ROOM = 160 };

/* The zoom tool between down and up; view pixels. */
typedef struct bat_zooming {
    bool down;
    double start[2], at[2];
} bat_zooming;

struct bat_editor {
    bat_document *document;
    char *name;
    uint64_t revision; /* grows with every change of the document */

    bat_history history;
    uint64_t saved_state,
        asked_state; /* states of the history: on disk; when the host last took a save request */
    bool asked;
    bat_transaction transaction;
    bat_selection selection; /* what commands act on; never part of the document, history or journal */
    bat_id entered;          /* the group whose members a click selects; 0: none */
    bat_id layer;            /* the active one, where new curves go; 0: none */
    bat_journal journal;
    bat_pictures pictures; /* whose bytes the journal holds */

    double values[BAT_PROPERTY_COUNT];
    char keys[BAT_COMMAND_COUNT][BAT_KEYS_ROOM]; /* shortcuts as they are now */
    bat_tool_id tool;
    bat_sketching sketching;
    bat_splining splining;
    bat_leveling leveling;
    bat_pointing pointing;
    bat_brushing brushing;
    bat_zooming zooming;
    bat_insight insight;
    bat_selecting selecting;
    bat_spanning spanning;
    bat_range range; /* these two lie over the chosen tool while they are on */
    bat_waypoints waypoints;
    bat_guiding guiding; /* this one too */
    bat_isolation isolation;
    bat_snap snap; /* what the last place of a drag snapped to */

    bat_view view;
    bool fit_wanted; /* the view is to be fitted as soon as the window has a size */
    bat_contacts contacts;
    bat_taps taps;
    uint32_t modifiers;
    double time;
    uint32_t followed; /* of the first hints, bits */
    bool holding_pan, pen_seen;
    double pen_time; /* of the last event of a pen */
    bool pen_near;   /* a pointer is over the drawing */
    double pen[2];   /* where it was last, view pixels */
    bool erasing;    /* the pen's other end is down */
    bool calming;    /* the key that calms is held */

    bat_scene scene;
    bat_overlay overlay;
    uint32_t requests;
    int pastes;          /* of what was copied last */
    uint64_t pasted;     /* digest of what was pasted last; 0: something was copied since */
    bool paste_in_place; /* the next one, whatever is held */
    bat_string notice;   /* BAT_STRING_COUNT: none */
    char notice_text[BAT_NOTICE_ROOM];
    bool read_only, refused; /* refused: this event would have changed something, which the user is told */
    bool freed; /* this event has made a free curve of a spline, which the user is told before all else */
    char number_text[BAT_UNIT_ROOM]; /* what bat_editor_number hands out */
    uint32_t notice_version;
    bat_frame frame;
    bat_told told;
    char *actions;                   /* names, made when asked for */
    char *tables, *layers, *outline; /* JSON, made when asked for */
    const char *
        *words; /* of another language, by bat_string; NULL in it: English. One block with its texts */
};

/* editor.c */
const bat_tool *bat_editor_tool(const bat_editor *editor);
bool bat_editor_busy(const bat_editor *editor); /* the tool is between down and up */
void bat_editor_notice(bat_editor *editor, bat_string text);
/* The text with its first "%" replaced by the value. */
void bat_editor_notice_value(bat_editor *editor, bat_string text, const char *value);
void bat_editor_notice_failure(bat_editor *editor, bat_status status); /* out of memory, or no curve */
const char *bat_editor_text(const bat_editor *editor, bat_string text);
/* The style that new curves get. */
bat_style bat_editor_new_style(const bat_editor *editor);
/* After a step: what is gone is no longer selected, nor the active layer. */
void bat_editor_follow(bat_editor *editor);
/* Sees to it that the journal holds the picture's bytes, as a line of their own. What bat_pictures_add says. */
/* A journal's first line, and the pictures it holds. On failure the caller frees both. */
bat_status bat_editor_begin_journal(const bat_document *document, const char *name, bat_journal *journal,
                                    bat_pictures *pictures);
/* A journal's line, given without the digest and the closing brace; frees it. document: as it is after it. */
bat_status bat_editor_log(bat_editor *editor, bat_text *line, const bat_document *document);
bat_status bat_editor_keep_picture(bat_editor *editor, const bat_picture *picture);
/* Brings the scene up to date before it is asked something. */
void bat_editor_sync(bat_editor *editor);
/* Hidden and locked objects, as the last picture had them, are not for tools. */
bool bat_editor_out_of_reach(const bat_editor *editor, int at);
/* Ends every contact and whatever the tool has under way. */
void bat_editor_interrupt(bat_editor *editor);
/* The document is read-only, and the user is told: whatever the event has to say besides. */
bool bat_editor_refuses(bat_editor *editor);

/* commands.c */
bat_status bat_command_run(bat_editor *editor, bat_command_id id, bool down);

/* view commands need the document's box: fit.c's one rule for what "all" is. False: nothing to fit to. */
bool bat_editor_fit(bat_editor *editor);

/* pressure.c: of an event; 1 but for a pen that is down. */
double bat_pressure_of(const bat_editor *editor, const bat_pointer *event);

/* keys.c */
bool bat_keys_valid(const char *keys);
bool bat_keys_match(const char *keys, const char *key, uint32_t modifiers);

#endif
