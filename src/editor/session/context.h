/*
 * What the engine's parts are handed: pointers to the parts, each declared by the room it lives in. A room sees into
 * those that it includes the header of, and these stand below it (tests/house/check_layers.py): so a function may hand
 * on what it can not look into.
 */
#ifndef BATTEN_EDITOR_SESSION_CONTEXT_H
#define BATTEN_EDITOR_SESSION_CONTEXT_H

#include <batten/editor.h>

typedef struct bat_context {
    struct bat_settings *settings; /* tables/settings.h: values of properties, shortcuts, words */
    struct bat_session *session;   /* session/session.h: document, history, journal, the open transaction */
    struct bat_notices *notices;   /* session/notice.h: what the user is told, and the host asked */
    struct bat_stage *stage;       /* view/stage.h: the view, and the ground that the pen draws on */
    struct bat_input *input;       /* input/input.h: contacts, the pen, what is held */
    struct bat_choice *choice;     /* choice/choice.h: selection, active layer, isolation, the tool wanted */
    struct bat_clipboard *clipboard; /* edit/clipboard.h */
    struct bat_scene *scene;         /* scene/scene.h: what is painted, and what can be found */
    struct bat_snap *snap;           /* pick/snap.h: what the last place of a drag snapped to */
    struct bat_insight *insight;     /* show/inspect.h: the curve that was looked at last */
    struct bat_panels *panels;       /* panels/panels.h */
    struct bat_toolbox *toolbox;     /* tools/toolbox.h: the tools, each with its own state */
    uint32_t modifiers;              /* held now */
    double time;                     /* of the event, ms */
} bat_context;

#endif
