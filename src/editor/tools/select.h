/* The Select tool's state. */
#ifndef BATTEN_EDITOR_TOOLS_SELECT_H
#define BATTEN_EDITOR_TOOLS_SELECT_H

#include "editor/session/context.h"
#include "editor/choice/selection.h"
#include "editor/pick/snap.h"

typedef enum bat_selecting_state {
    BAT_SELECTING_IDLE,
    BAT_SELECTING_PRESSED, /* down on something, not moved yet */
    BAT_SELECTING_MARQUEE,
    BAT_SELECTING_MOVING,
    BAT_SELECTING_SCALING,
    BAT_SELECTING_ROTATING
} bat_selecting_state;

/* The eight handles lie around the box, from the top left on clockwise; then the one that rotates. */
enum { BAT_GRIP_ROTATE = 8, BAT_GRIP_NONE = -1, BAT_SNAP_SOURCES = 40 };

typedef struct bat_selecting {
    bat_selecting_state state;
    bat_device device;
    double start[2], at[2]; /* view pixels: where the pointer came down, where it is */
    bool hovering;
    bat_id hovered; /* what a click would select; 0: nothing */
    int handle;     /* under the pointer, or held */

    bat_id pressed;    /* 0: on nothing */
    bool was_selected; /* before the press: a click then selects it alone */
    bool replaced;     /* the press has begun another selection; `earlier` is the one before */
    bat_selection earlier;
    bat_id entered; /* before the press */
    double box[4];  /* of the selection, when the drag began */
    int *indices;   /* of the paths that the drag changes, and what they were */
    bat_object **before;
    int count;
    bat_id *originals; /* a drag of copies: what was selected before; else NULL */
    int original_count;
    bool due; /* the drag has moved on since the objects were last changed */

    double clicked[2], clicked_at;             /* view pixels, time: of the last press, for a double click */
    bat_snap_source sources[BAT_SNAP_SOURCES]; /* of what moves: what may snap; when the drag began */
    int source_count;

    double point[2]; /* document units: the last place that was clicked; where to split */
    bool has_point;
} bat_selecting;

/* Of the tool. */
bat_selecting *bat_selecting_of(const bat_context *c);

#endif
