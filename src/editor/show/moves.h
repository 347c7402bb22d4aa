/* The move that is looked at, of a camera or of a skeleton: which one, where its playhead is, whether it plays. No part of the document, the
 * history or the journal: playing is not editing. */
#ifndef BATTEN_EDITOR_SHOW_MOVES_H
#define BATTEN_EDITOR_SHOW_MOVES_H

#include "editor/session/context.h"

typedef struct bat_moves {
    bat_id camera; /* or the skeleton; 0: there is none in the drawing */
    int count;     /* of the cameras and skeletons in it */
    double at;     /* of the playhead: seconds since the move's start */
    bool playing;  /* the host says when (bat_editor_play) */
    double since;  /* ms: when the playhead was there; below 0: not yet known */
    bool through;  /* the drawing is seen through the camera */
    int level[2]; /* that drags change, of its path and of its gaze; what is above the finest is the finest */
    int joint, angle; /* of a skeleton: the one that is chosen, and which of its angles the graph shows */
    uint32_t version; /* grows whenever any of this changes */
    uint64_t revision;
    uint32_t selection; /* of the document and the selection, as last seen */
    bool seen;
} bat_moves;

/* Finds the camera: the selected one, else the one before, else the first in the drawing. A change of the drawing stops what
 * plays. O(objects) after a change. */
void bat_moves_sync(bat_context *c);
/* Forgets all when another document is opened. */
void bat_moves_forget(bat_moves *moves);
/* Plays, or stops; false: there is no camera. */
bool bat_moves_toggle(bat_context *c);
/* Back from looking through the camera; false: it was not so. */
bool bat_moves_leave(bat_context *c);
/* Another number whenever the time strip shows something else; 0: no strip. */
uint32_t bat_moves_version(const bat_context *c);

#endif
