/* A camera's keys in words. */
#ifndef BATTEN_EDITOR_TOOLS_GAZES_WORDS_H
#define BATTEN_EDITOR_TOOLS_GAZES_WORDS_H

#include "editor/session/context.h"

#include <batten/camera.h>

enum { BAT_KEY_ROOM = 120 };

/* "key 3 of 6, 1.25 s, looks 12 degrees down" */
void bat_key_in_words(const bat_context *c, const bat_camera *camera, size_t key, char text[BAT_KEY_ROOM]);
/* Selects the camera, chooses a key of it, and moves the playhead there. BAT_ARGUMENT: no such key; BAT_STATE: the camera is
 * locked or hidden. */
bat_status bat_key_choose(bat_context *c, bat_id camera, int key);

#endif
