#include "editor/tools/gazes/words.h"
#include "base/quat.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/moves.h"
#include "editor/tables/tables.h"
#include "editor/tools/gazes/find.h"
#include "editor/tools/toolbox.h"
#include "form/camera/camera.h"

#include <math.h>
#include <stdio.h>

/* How far it looks down, in degrees: up from the page is against z. */
static double dip_of(const bat_camera_pose *pose) {
    const vec ahead = quat_turn(quat_load(pose->rotation), (vec){0, 0, -1});
    return bat_atan2(ahead.z, bat_hypot(ahead.x, ahead.y)) * 180 / BAT_PI;
}

void bat_key_in_words(const bat_context *c, const bat_camera *camera, size_t key, char text[BAT_KEY_ROOM]) {
    bat_camera_pose pose;
    char values[4][24];
    const double u = bat_gazing_place(camera, key);
    bat_camera_at(camera, u, &pose);
    const double dip = round(dip_of(&pose));
    snprintf(values[0], sizeof values[0], "%d", (int)key + 1);
    snprintf(values[1], sizeof values[1], "%d", (int)bat_gazing_keys(camera));
    snprintf(values[2], sizeof values[2], "%.2f", bat_camera_time_of(camera, u));
    snprintf(values[3], sizeof values[3], "%.0f", fabs(dip));
    const char *const filled[4] = {values[0], values[1], values[2], values[3]};
    const bat_string words = dip > 0   ? BAT_STRING_KEY_DOWN
                             : dip < 0 ? BAT_STRING_KEY_UP
                                       : BAT_STRING_KEY_LEVEL;
    bat_word_fill(c, words, 4, filled, text, BAT_KEY_ROOM);
}

bat_status bat_key_choose(bat_context *c, bat_id id, int key) {
    const int at = bat_document_find(c->session->document, id);
    const bat_camera *camera = at < 0 ? NULL : bat_object_camera(bat_document_at(c->session->document, at));
    if (!camera || key < 0 || (size_t)key >= bat_gazing_keys(camera)) return BAT_ARGUMENT;
    if (!(bat_tool_at(c->choice->tool)->traits & BAT_CHOOSES))
        bat_toolbox_choose(c, bat_tool_that(BAT_CHOOSES));
    bat_selection_clear(&c->choice->selection);
    if (bat_seen_out_of_reach(c, at) || bat_selection_add(&c->choice->selection, id) != BAT_OK)
        return BAT_STATE;
    bat_moves_sync(c);
    if (!bat_gazing_object(c)) return BAT_STATE;
    bat_gazing *g = bat_gazing_of(c);
    g->camera = id;
    g->chosen = key;
    c->moves->at = bat_camera_time_of(camera, bat_gazing_place(camera, (size_t)key));
    c->moves->playing = false;
    c->moves->version++;
    return BAT_OK;
}
