/*
 * The state shared by the levels tool and the level strip: the chosen curve or surface, its active level, and the operation
 * under way. Levels are numbered from the base, which is 0.
 */
#ifndef BATTEN_EDITOR_TOOLS_LEVELS_STATE_H
#define BATTEN_EDITOR_TOOLS_LEVELS_STATE_H

#include "editor/input/double_tap.h"
#include "editor/session/context.h"
#include "editor/show/handles.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"
#include "editor/tools/levels/ladder.h"
#include <batten/editor.h>
#include <batten/levels.h>

/* A place of the chosen curve that drags hold, and perhaps its direction there. */
typedef struct bat_pin {
    double u;
    bool direction;
} bat_pin;

typedef struct bat_leveling {
    bat_id object;  /* the chosen curve or surface; 0: none */
    int curve;      /* of a surface: no matter */
    bat_id adopted; /* the selection already taken into account */
    int level;      /* the active level */
    int chosen;     /* index of its chosen control point; -1: none */

    int pin_count;
    bat_pin pins[BAT_HELD_MAX];
    bat_double_tap tap;

    bool hovering;
    bat_device device;
    double hover[2]; /* view pixels */
    bat_handle hot;  /* what would be dragged: a control point of the active level, or the curve */

    /* between down and up */
    bool pressed, dragging, due;
    bat_handle grip;
    double start[2], at[2];           /* view pixels */
    bool fading;                      /* a fader is being dragged and holds the transaction */
    bat_ladder base;                  /* the levels before the fader was moved, owned */
    bat_shape_live *live;             /* the drag's session, owned */
    struct bat_bent_along *followers; /* what goes along, owned; NULL: nothing */
    bat_relief *carved;               /* a surface's levels before the drag, owned */
    double place[2];                  /* u and v of what is dragged of it */
    double normal[2];                 /* of a curve in the plane, where it is dragged; 0: it has none there */

    bat_ladder apart; /* the curve or surface taken apart, a preview until Enter or Esc; owned */
    uint64_t apart_revision;
    bool copying; /* the next tap chooses the curve that receives the detail */

    uint32_t version; /* of the contents of the strip */
    uint64_t shown;
    char *strip; /* JSON, made on request */
} bat_leveling;

void bat_leveling_free(bat_leveling *leveling);
/* Takes over the selection; drops what is gone. */
void bat_leveling_settle(bat_context *c);
void bat_leveling_choose(bat_context *c, bat_id object, int curve);
/* The same with all that is selected, if the curve is. */
void bat_leveling_take(bat_context *c, bat_id object, int curve);
/* The chosen curve and its levels; NULL: none. */
const bat_curve *bat_leveling_curve(const bat_context *c);
const bat_shape *bat_leveling_shape(const bat_context *c);
/* The chosen surface and its levels; NULL: none. One of curve and surface is NULL. */
const bat_object *bat_leveling_solid(const bat_context *c);
const bat_relief *bat_leveling_relief(const bat_context *c);
/* The levels of either. */
bat_ladder bat_leveling_ladder(const bat_context *c);
/* Gives the chosen curve this shape, within the open transaction or as a step of its own. Takes ownership of the
 * shape, whatever it returns. */
bat_status bat_leveling_put(bat_context *c, bat_shape *shape);
bat_status bat_leveling_commit(bat_context *c, bat_shape *shape, bat_string label);
/* The same with the levels of a curve or a surface. */
bat_status bat_leveling_put_ladder(bat_context *c, bat_ladder ladder);
bat_status bat_leveling_commit_ladder(bat_context *c, bat_ladder ladder, bat_string label);
/* solid.c: gives a surface these levels (NULL: none, as it is) as a step of its own; takes the relief over, whatever it
 * returns. */
bat_status bat_relief_commit(bat_context *c, bat_id object, bat_relief *relief, bat_string label);
/* Drags a place of the chosen surface: at the press; on the way, within the open transaction. */
bat_status bat_relief_grip(bat_context *c);
bat_status bat_relief_pull(bat_context *c);
void bat_relief_show(const bat_context *c, bat_overlay *list);
/* Takes the chosen surface apart; how many points that leaves of n. */
bat_status bat_relief_take_apart(bat_context *c, int levels, int points, bat_relief **out);
/* held.c: whether anything of the chosen curve is held. */
bool bat_leveling_holds(const bat_context *c);
/* The shape of the drag's session as it was at the beginning, with the grip moved by delta and the rest held; the caller's. BAT_TOLERANCE:
 * that cannot be, and the shape, where there is one, is as far on the way as can be. */
bat_status bat_leveling_move_held(const bat_context *c, bat_shape_live *live, const bat_handle *grip,
                                  const double delta[3], bat_shape **out);
/* After what is held has been switched: says when the chosen curve has no symmetry to hold. */
bat_status bat_leveling_told_held(bat_context *c, bat_property_id id);
/* Puts a pin at a parameter of the chosen curve; with one there, holds its direction, too, and then takes it away. */
void bat_leveling_pin(bat_context *c, double u);
void bat_leveling_show_pins(const bat_context *c, bat_overlay *list);
/* follow.c: what goes along with the chosen curve when its level is bent; *out NULL: nothing. Within the transaction, after the
 * curve has its new shape: moves it from where it was. */
typedef struct bat_bent_along bat_bent_along;
bat_status bat_bent_along_gather(bat_context *c, bat_bent_along **out);
bat_status bat_bent_along_move(bat_context *c, const bat_bent_along *followers);
void bat_bent_along_free(bat_bent_along *followers);
/* Ends a fader drag and reverts it; false: there was none. */
bool bat_leveling_let_go(bat_context *c);
/* The version of the strip's contents; 0: the strip is not visible. */
uint32_t bat_leveling_version(bat_context *c);

/* Taking apart: updates the preview; drops it (false: there was none); accepts it. */
bat_status bat_apart_make(bat_context *c);
/* The number of control points left when every other knot is removed, `levels` times; at least that of a base. */
int bat_apart_halved(const bat_curve *curve, int levels);
bool bat_apart_drop(bat_context *c);
bool bat_apart_accept(bat_context *c);
/* Properties of levels: applies a new value; gives the value of FRAME_RULE. */
bat_status bat_leveling_set(bat_context *c, bat_property_id id, double value);
/* Copies the chosen curve's detail to another curve. */
bat_status bat_leveling_copy_to(bat_context *c, bat_id object, int curve);
/* The state of the tool. */
bat_leveling *bat_leveling_of(const bat_context *c);

#endif
