/* The engine as a whole: the storage of its parts. Only the source files in this folder see it. */
#ifndef BATTEN_EDITOR_EDITOR_H
#define BATTEN_EDITOR_EDITOR_H

#include "editor/session/context.h"
#include "editor/choice/choice.h"
#include "editor/commands/simplify.h"
#include "editor/commands/tuning.h"
#include "editor/edit/clipboard.h"
#include "editor/input/input.h"
#include "editor/panels/panels.h"
#include "editor/pick/snap.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/inspect.h"
#include "editor/show/moves.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tools/toolbox.h"
#include "editor/view/casters.h"
#include "editor/view/stage.h"
#include "editor/view/views.h"

enum { BAT_HINT_ROOM = 512 };

struct bat_editor {
    bat_context context; /* points to all the members that follow */
    bat_problem problem; /* why the last call by name was refused */
    bat_settings settings;
    bat_session session;
    bat_notices notices;
    bat_stage stage;
    bat_casters casters;
    bat_views views;
    bat_input input;
    bat_choice choice;
    bat_clipboard clipboard;
    bat_scene scene;
    bat_snap snap;
    bat_moves moves;
    bat_insight insight;
    bat_simplifying simplifying;
    bat_tuning tuning;
    bat_panels panels;
    bat_toolbox toolbox;
    bat_overlay overlay;
    char hint[BAT_HINT_ROOM];
    bat_frame frame;
};

#endif
