/* The dispatcher: calls the function of each command in the table. */
#include "editor/commands/dispatch.h"
#include "editor/tables/commands.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/keys.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "editor/view/views.h"
#include <string.h>

typedef struct row {
    bat_command_function *function;
    bat_held_function *held;
} row;

static const row functions[BAT_COMMAND_COUNT] = {
#define COMMAND(id, name, keys, when, function) {function, NULL},
#define HELD(id, name, keys, function) {NULL, function},
#include "editor/tables/commands.def"
};

bool bat_command_faces(const bat_context *c, bat_command_id id) {
    if (bat_command_at(id)->when != BAT_WHEN_FACE_ON) return true;
    /* A tool that works in a tilted view knows what its commands mean there. */
    return functions[id].function == bat_command_to_tool ? bat_toolbox_faces(c) : !bat_stage_tilted(c->stage);
}

bat_status bat_command_run(bat_context *c, bat_command_id id, bool down) {
    if (bat_command_at(id)->when != BAT_WHEN_ANYTIME && (bat_toolbox_busy(c) || c->session->transaction.open))
        return BAT_STATE;
    if (!bat_command_faces(c, id)) return BAT_STATE;
    bat_views_arrive(c->views, &c->stage->view);
    c->session->freed = BAT_STRING_COUNT;
    c->session->refused = false;
    if (id == c->notices->offer) bat_notice_taken(c);
    return functions[id].held ? functions[id].held(c, down) : functions[id].function(c, id);
}

bat_status bat_command_do(bat_context *c, const char *name) {
    bat_command_id id = bat_command_named(name);
    if (id == BAT_COMMAND_COUNT) return BAT_UNSUPPORTED;
    bat_status status = bat_command_run(c, id, true);
    if (status == BAT_STATE && !bat_command_faces(c, id)) bat_notice_tilted(c);
    /* Called by name, the command acts at once; while its key is held, its reach is shown. */
    return id == BAT_COMMAND_CALM && status == BAT_OK ? bat_command_run(c, id, false) : status;
}

bat_status bat_command_bind(bat_context *c, const char *command, const char *keys) {
    bat_command_id id = bat_command_named(command);
    if (id == BAT_COMMAND_COUNT) return BAT_UNSUPPORTED;
    if (!keys) keys = bat_command_at(id)->keys;
    if (!bat_keys_valid(keys)) return BAT_ARGUMENT;
    memcpy(c->settings->keys[id], keys, strlen(keys) + 1);
    return BAT_OK;
}
