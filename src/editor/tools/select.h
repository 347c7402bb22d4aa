/* The Select tool's state. */
#ifndef BATTEN_EDITOR_TOOLS_SELECT_H
#define BATTEN_EDITOR_TOOLS_SELECT_H

#include "editor/session/context.h"
#include "editor/choice/selection.h"
#include "editor/pick/snap.h"
#include "editor/view/gizmo.h"

typedef enum bat_selecting_state {
    BAT_SELECTING_IDLE,
    BAT_SELECTING_PRESSED, /* pen down on something, not moved yet */
    BAT_SELECTING_MARQUEE,
    BAT_SELECTING_MOVING,
    BAT_SELECTING_SCALING,
    BAT_SELECTING_ROTATING,
    BAT_SELECTING_PLACING, /* by the gizmo */
    BAT_SELECTING_SHAPING  /* a number of the shape that is selected alone */
} bat_selecting_state;

/* The eight handles of the box, clockwise from the top left; the handle that rotates; those of the gizmo, in a tilted view; those of a shape's numbers. */
enum {
    BAT_GRIP_ROTATE = 8,
    BAT_GRIP_GIZMO,
    BAT_GRIP_SHAPE = BAT_GRIP_GIZMO + BAT_GIZMO_PARTS,
    BAT_GRIP_NONE = -1,
    BAT_SNAP_SOURCES = 40
};

typedef struct bat_selecting {
    bat_selecting_state state;
    bat_device device;
    double start[2], at[2]; /* view pixels: where the pointer went down; where it is */
    bool hovering;
    bat_id hovered; /* what a click would select; 0: nothing */
    int handle;     /* under the pointer, or grabbed */

    bat_id pressed;    /* 0: on nothing */
    bool twice;        /* it is the second of a double click */
    bool was_selected; /* before the press: a click then selects it alone */
    bool below;        /* with Alt: a click selects what lies below */
    bool replaced;     /* the press has begun a new selection; `earlier` is the previous one */
    bat_selection earlier;
    bat_id entered; /* before the press */
    double box[4];  /* of the selection, at the start of the drag */
    int *indices;   /* of the paths that the drag changes, and the paths before it */
    bat_object **before;
    int count;
    bat_id *originals; /* when dragging copies: the previous selection; otherwise NULL */
    int original_count;
    double matrix[6]; /* how the drag maps them at present */
    bat_gizmo gizmo;  /* where it was when a part of it was taken hold of */
    double by[3];     /* how far that part has come */
    bool due;         /* the drag has moved since the objects were last updated */

    double clicked[2], clicked_at;             /* view pixels, time: of the last press, for double clicks */
    bat_snap_source sources[BAT_SNAP_SOURCES]; /* what may snap of the moving objects */
    int source_count;

    double point[2]; /* document units: the last clicked place, where to split */
    bool has_point;
} bat_selecting;

/* The state of the tool. */
bat_selecting *bat_selecting_of(const bat_context *c);

#endif
