/*
 * What the levels tool and the level strip know: the chosen curve, which of its levels is the active one, and
 * what is under way with it. Levels are counted from the base, which is 0.
 */
#ifndef BATTEN_EDITOR_TOOLS_LEVELS_STATE_H
#define BATTEN_EDITOR_TOOLS_LEVELS_STATE_H

#include "editor/session/context.h"
#include "editor/show/handles.h"
#include "editor/tables/tables.h"
#include <batten/editor.h>

typedef struct bat_leveling {
    bat_id object; /* the chosen curve; 0: none */
    int curve;
    bat_id adopted; /* the selection that has been taken up */
    int level;      /* the active one */
    int chosen;     /* a control point of it; -1: none */

    bool hovering;
    bat_device device;
    double hover[2]; /* view pixels */
    bat_handle hot;  /* what would be dragged: a control point of the active level, or the curve */

    /* between down and up */
    bool pressed, dragging, due;
    bat_handle grip;
    double start[2], at[2]; /* view pixels */
    bool fading;            /* a hand on a fader holds the transaction */
    bat_shape *base;        /* the shape as the fader found it, owned */
    bat_shape_live *live;   /* the drag's session, owned */

    bat_shape *apart; /* the curve taken apart, shown until Enter or Esc; owned */
    uint64_t apart_revision;
    bool copying; /* the next tap chooses the curve that gets the detail */

    uint32_t version; /* of what the strip shows */
    uint64_t shown;
    char *strip; /* JSON, made when asked for */
} bat_leveling;

void bat_leveling_free(bat_leveling *leveling);
/* Takes up the selection, forgets what is gone. */
void bat_leveling_settle(bat_context *c);
void bat_leveling_choose(bat_context *c, bat_id object, int curve);
/* The chosen curve and its levels; NULL: none. */
const bat_curve *bat_leveling_curve(const bat_context *c);
const bat_shape *bat_leveling_shape(const bat_context *c);
/* The chosen curve with this shape, within the open transaction, or as a step of its own. Takes the shape over,
 * whatever it returns. */
bat_status bat_leveling_put(bat_context *c, bat_shape *shape);
bat_status bat_leveling_commit(bat_context *c, bat_shape *shape, bat_string label);
/* A hand on a fader is taken off, and what it did taken back; false: there was none. */
bool bat_leveling_let_go(bat_context *c);
/* Whether the strip is to be seen, and the number of what it shows then; 0: not. */
uint32_t bat_leveling_version(bat_context *c);

/* Taking apart: the preview anew, dropped (false: there was none), made so. */
bat_status bat_apart_make(bat_context *c);
/* As many points as are left when every other knot goes, `levels` times; no fewer than a base has. */
int bat_apart_halved(const bat_curve *curve, int levels);
bool bat_apart_drop(bat_context *c);
bool bat_apart_accept(bat_context *c);
/* Properties of levels: what follows from a new value; what FRAME_RULE is. */
bat_status bat_leveling_set(bat_context *c, bat_property_id id, double value);
/* Detail of the chosen curve to another. */
bat_status bat_leveling_copy_to(bat_context *c, bat_id object, int curve);
/* Of the tool. */
bat_leveling *bat_leveling_of(const bat_context *c);

#endif
