/* What is held of a camera, and which of its keys is chosen. */
#ifndef BATTEN_EDITOR_TOOLS_GAZES_STATE_H
#define BATTEN_EDITOR_TOOLS_GAZES_STATE_H

#include "editor/session/context.h"

#include <batten/camera.h>
#include <batten/document.h>

typedef enum bat_gaze_hold {
    BAT_GAZE_NOTHING,
    BAT_GAZE_END,    /* of the ray of a key */
    BAT_GAZE_TARGET, /* what the camera looks at */
    BAT_GAZE_EDGE,   /* of the picture at the playhead */
    BAT_GAZE_PATH,
    BAT_GAZE_JOINT /* of a skeleton; key: which */
} bat_gaze_hold;

typedef struct bat_gazing {
    bool on, moved, due, failed;
    bat_gaze_hold part;
    bat_id camera;          /* of what is held, or of the chosen key */
    long chosen;            /* key, from 0; -1: none */
    long key;               /* that is held */
    double u;               /* where it is, or where the path was pressed */
    double start[2], at[2]; /* view pixels */
    double base[3];         /* the handle when it was taken */
    bat_object *before;     /* NULL: the drag has not begun */
    bat_pointer pressed;
    bat_object *fading;  /* what a panel's control changes, as it was; owned. NULL: nothing */
    bool path;           /* of that the path's levels, not the gaze's */
    bool correcting;     /* it is corrected in the picture that it sees, with: */
    bat_object *bending; /* what it follows, as it was; owned. NULL: nothing, or what is out of reach */
    double time, far;    /* of the playhead then; how far away is what was taken hold of, 0: not yet known */
} bat_gazing;

/* The state of the mode. */
bat_gazing *bat_gazing_of(const bat_context *c);

#endif
