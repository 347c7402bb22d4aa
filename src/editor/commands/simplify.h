/* Simplifying the selection. Until something else is done, the tolerance and how the spans meet can be chosen anew: what
 * that gives is shown, and then takes the place of the step. */
#ifndef BATTEN_EDITOR_COMMANDS_SIMPLIFY_H
#define BATTEN_EDITOR_COMMANDS_SIMPLIFY_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"

/* How the spans of the result meet; kept for the next time. */
typedef enum bat_joints {
    BAT_JOINTS_C2, /* fewest points */
    BAT_JOINTS_G1, /* fewest cubics, as path editors count them */
    BAT_JOINTS_COUNT
} bat_joints;

/* Of all their curves, before and after. */
typedef struct bat_simplified {
    size_t points[2], cubics[2]; /* cubics: spans, of whatever degree they are */
    int changed;                 /* curves */
} bat_simplified;

typedef struct bat_simplifying {
    int count;           /* 0: nothing can be chosen anew */
    bat_object **before; /* the objects as they were, retained */
    bool stepped;        /* a step has changed them; otherwise they are as they were */
    double tolerance;    /* as the command was given, document units */
    double amount;       /* 0, many points, to 1, few; as the command left it: 1/2 */
    bat_joints joints;
    bat_simplified sum;
    int shown; /* curves that are only shown, owned */
    bat_curve **fit;
    uint64_t revision; /* when all this was made */
    uint32_t selection, version;
    bat_tool_id tool;
} bat_simplifying;

void bat_simplify_free(bat_simplifying *simplifying);
/* Whether simplifying the selection is still the last thing done. */
bool bat_simplify_holds(const bat_context *c);
/* A number that changes when what the slider shows changes; 0: there is nothing to choose. */
uint32_t bat_simplify_version(const bat_context *c);
/* Where the slider belongs: the lower right corner of the box around the objects, document units. */
void bat_simplify_place(const bat_context *c, double at[2]);
/* Takes another amount. done: in place of the step; otherwise only shown. BAT_STATE: no longer; BAT_ARGUMENT: not
 * from 0 to 1; failures leave everything as it was. */
bat_status bat_simplify_again(bat_context *c, double amount, bool done);
/* Takes other joints, in place of the step. BAT_STATE: no longer; BAT_ARGUMENT: no such joints; failures leave everything
 * as it was. */
bat_status bat_simplify_joined(bat_context *c, int joints);
/* Gives the objects back as they were; Enter keeps them. False: there was nothing to choose. */
bool bat_simplify_cancel(bat_context *c);
bool bat_simplify_accept(bat_context *c);
void bat_simplify_show(bat_context *c, bat_overlay *overlay);

#endif
