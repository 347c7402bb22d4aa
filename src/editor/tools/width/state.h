/* The width tool's state, and what its files share: width.c (events), and the files named below. */
#ifndef BATTEN_EDITOR_TOOLS_WIDTH_STATE_H
#define BATTEN_EDITOR_TOOLS_WIDTH_STATE_H

#include "editor/edit/breadth_levels.h"
#include "editor/input/double_tap.h"
#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"
#include <batten/panels.h>

/* What a press would take hold of. */
typedef struct bat_breadth_hit {
    bat_id object; /* 0: nothing */
    int curve;
    int stop;    /* -1: between stops */
    bool middle; /* on the curve, not on a handle beside it */
    double at;   /* 0..1, share of the length */
} bat_breadth_hit;

/* A place along a stroke. */
typedef struct bat_breadth_spot {
    double point[2], across[2]; /* on the page; across: of length 1 */
    double half;                /* half the width, document units */
    double seen[3][2];          /* middle, and the two sides: drawing coordinates */
} bat_breadth_spot;

/* What the faders of levels have made of the width of a curve since they were first moved. */
typedef struct bat_damping {
    bat_id object; /* 0: nothing */
    int curve;
    bat_breadths base, made; /* as it was, and as it is in the document */
    double gain[BAT_BREADTH_LEVELS + 1];
    bool muted[BAT_BREADTH_LEVELS + 1];
} bat_damping;

/* A level, as the strip has it. */
typedef struct bat_breadth_level {
    int points;
    double gain;
    bool muted, active;
} bat_breadth_level;

typedef struct bat_broadening {
    bool hovering;
    bat_device device;
    double hover[2]; /* view pixels */
    bat_breadth_hit hot;
    bat_id object; /* the curve whose stops stay displayed; 0: the one under the pen */
    int curve;
    bat_id adopted; /* the selection already taken over */
    bool chosen;    /* a stop is, or a place between stops */
    int stop;       /* -1: at `place` there is none yet */
    double place;

    /* between down and up */
    bool pressed, dragging, sliding, due;
    bat_breadth_hit grip;
    double start[2], at[2]; /* view pixels */
    double from, half; /* at the press: how far across the pen was, with its side's sign; half the width */
    bat_breadths base; /* before the drag, with the stop that is held */
    int held;

    int level; /* that is pulled; one more than its number, 0: the finest */
    bat_damping damping;
    bool fading; /* a fader is being dragged and holds the transaction */
    int faded;
    double gain_before;
    uint32_t version; /* of the contents of the strip */
    uint64_t shown;

    bat_double_tap tap;
} bat_broadening;

/* state.c */
bat_broadening *bat_broadening_of(const bat_context *c);
/* The object with that curve, if its width can be changed; NULL otherwise. */
const bat_object *bat_broadening_object(const bat_context *c, bat_id object, int curve);
void bat_broadening_choose(bat_context *c, bat_broadening *b, bat_id object, int curve);
/* Undo and other commands may have removed what was chosen. */
void bat_broadening_settle(bat_context *c, bat_broadening *b);
void bat_broadening_choose_at(bat_broadening *b, int stop, double place);
/* After a change to these, of which one is chosen: even strokes keep none. */
void bat_broadening_keep(const bat_context *c, bat_broadening *b, const bat_breadths *breadths, int stop);
/* The stops of the chosen curve, with one where a place between them is chosen; the index of what is chosen, -1: nothing is. */
int bat_broadening_chosen(const bat_context *c, const bat_broadening *b, bat_breadths *out);
void bat_broadening_load(const bat_object *object, int curve, bat_breadths *out);
double bat_broadening_length(const bat_object *object, int curve);
/* The share of the length at a parameter. */
double bat_broadening_share(const bat_object *object, int curve, double u);
/* False: it is not seen. share: of the style's width. */
bool bat_broadening_spot(const bat_context *c, const bat_object *object, int curve, double at, double share,
                         bat_breadth_spot *out);

/* find.c: stops of the displayed curve before curves. */
bat_breadth_hit bat_broadening_find(bat_context *c, const bat_broadening *b, const double pixel[2]);

/* drag.c */
void bat_broadening_begin_drag(bat_context *c, bat_broadening *b);
void bat_broadening_drag(bat_context *c, bat_broadening *b);
void bat_broadening_release(bat_broadening *b);

/* levels.c: as the level strip has it. The number of the level that is pulled, or of one beyond the finest. */
int bat_broadening_pulled(const bat_broadening *b);
/* The finest level of the chosen curve's width; 0: there are no levels. */
int bat_broadening_top(const bat_context *c);
bat_breadth_level bat_broadening_row(const bat_context *c, int level);
/* The widths whose levels these are, without gains. False: there are none. */
bool bat_broadening_told(const bat_context *c, bat_breadths *out);
/* Another number whenever these change; 0: there are none. */
uint32_t bat_broadening_levels_version(bat_context *c);
/* As bat_editor_level. */
bat_status bat_broadening_fade(bat_context *c, bat_level_act act, int level, double value, bool done);
/* Ends a fader's drag and takes it back; false: there was none. */
bool bat_broadening_let_go(bat_context *c);
/* The next level is pulled, 1: a finer one, -1: a coarser one. */
bat_status bat_broadening_step_level(bat_context *c, bat_broadening *b, int direction);

/* keys.c */
bat_status bat_broadening_add(bat_context *c, bat_broadening *b, double at);
bat_status bat_broadening_command(bat_context *c, void *state, bat_command_id id);
/* The width at the stop that is chosen, or how far along the curve it is: document units. False: none is chosen. */
bool bat_broadening_number(bat_context *c, bool place, double *value);
bat_status bat_broadening_enter(bat_context *c, bool place, double value);

/* show.c */
void bat_broadening_overlay(bat_context *c, void *state, bat_overlay *list);

#endif
