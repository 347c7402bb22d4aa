/*
 * The context passed around the engine: pointers to its parts, each declared in the room it belongs to. A room can
 * look into only those parts whose headers it includes, which lie below it (tests/house/check_layers.py); a function
 * may pass on parts that it cannot look into.
 */
#ifndef BATTEN_EDITOR_SESSION_CONTEXT_H
#define BATTEN_EDITOR_SESSION_CONTEXT_H

#include <batten/editor.h>

typedef struct bat_context {
    struct bat_settings *settings;   /* tables/settings.h: values of properties, shortcuts, words */
    struct bat_session *session;     /* session/session.h: document, history, journal, the open transaction */
    struct bat_notices *notices;     /* session/notice.h: notices for the user, requests to the host */
    struct bat_stage *stage;         /* view/stage.h: the view, and the ground that the pen draws on */
    struct bat_views *views;         /* view/views.h: views that were left, the way home */
    struct bat_input *input;         /* input/input.h: contacts, the pen, keys held */
    struct bat_choice *choice;       /* choice/choice.h: selection, active layer, isolation, requested tool */
    struct bat_clipboard *clipboard; /* edit/clipboard.h */
    struct bat_scene *scene;         /* scene/scene.h: what is painted and can be hit */
    struct bat_snap *snap;           /* pick/snap.h: what the last position of a drag snapped to */
    struct bat_moves *moves;         /* show/moves.h: the camera move that is looked at */
    struct bat_insight *insight;     /* show/inspect.h: the curve inspected last */
    struct bat_simplifying *simplifying; /* commands/simplify.h */
    struct bat_tuning *tuning;           /* commands/tuning.h: what can still be done otherwise */
    struct bat_panels *panels;           /* panels/panels.h */
    struct bat_toolbox *toolbox;         /* tools/toolbox.h: the tools, each with its own state */
    uint32_t modifiers;                  /* held at present */
    double time;                         /* of the event, ms */
} bat_context;

#endif
