/*
 * What was just done to the selection and can still be chosen otherwise: along a slider, or one of a few ways. What is chosen is
 * shown, and then takes the place of the step. It ends with the next thing that is done.
 */
#ifndef BATTEN_EDITOR_COMMANDS_TUNING_H
#define BATTEN_EDITOR_COMMANDS_TUNING_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"
#include "text/text.h"
#include <batten/sweep.h>

/* What is tuned. */
typedef struct bat_tuning_kind {
    bat_string step; /* the name of its step of the history */
    /* Takes another amount, 0 to 1. done: in place of the step; otherwise only shown. A failure leaves everything as it was. */
    bat_status (*again)(bat_context *c, double amount, bool done);
    /* The same with the second slider; NULL: there is one alone. */
    bat_status (*other)(bat_context *c, double amount, bool done);
    /* Takes another way; -1: the one after that in force. BAT_ARGUMENT: there is none. */
    bat_status (*choose)(bat_context *c, int way);
    int (*way)(const bat_context *c); /* the way in force; NULL: there are none */
    /* Writes its members of the readings (panels.h), each with a comma before it. */
    void (*write)(bat_context *c, bat_text *text);
    bat_status (*accept)(
        bat_context *c); /* Enter; NULL: it stays as it is. A failure: it can still be chosen */
    /* Shows it with the properties in force; NULL: it has none. A failure leaves what was shown. */
    bat_status (*show)(bat_context *c);
} bat_tuning_kind;

/* What was last found out about the history of one object. All zero: nothing. */
typedef struct bat_tuning_past {
    bat_id object;
    uint64_t state,
        step; /* serial numbers: of the history's state then; after the last step that changed the shape, or 0 */
} bat_tuning_past;

/* The nearest edges of two objects, the first of which is a surface. */
typedef struct bat_edge_pair {
    const bat_object *object[2];
    bat_side side[2];
} bat_edge_pair;

typedef struct bat_tuning {
    const bat_tuning_kind *kind; /* NULL: nothing can be chosen */
    int count;                   /* of the objects that it is about, as they were, retained */
    bat_object **before;
    bool stepped;         /* a step has changed them; otherwise they are as they were */
    double amount, other; /* 0 to 1; of the second slider */
    double place[2][3];   /* what the two sliders are about, where there are two */
    int way;              /* in force, of kinds that keep it nowhere else */
    bool comb;            /* what is only shown has its curvature comb */
    bat_edge_pair
        edges; /* what it is about, of `before`, where those are edges of surfaces; otherwise NULL */
    int shown; /* curves that are only shown, owned */
    bat_curve **fit;
    double around[4];  /* of all that can be shown */
    bat_string why;    /* nothing is shown, where the kind has a reason */
    uint64_t revision; /* when all this was made */
    uint32_t selection, version;
    bat_tool_id tool;
    bat_tuning_past past;
} bat_tuning;

/* Ends it; what was done stays. */
void bat_tuning_free(bat_tuning *tuning);
/* Drops what is only shown. */
void bat_tuning_unshow(bat_tuning *tuning);
/* Shows one curve more, which is taken over whatever it returns. */
bat_status bat_tuning_add(bat_tuning *tuning, bat_curve *curve);
/* What it is about: the objects that are selected, or in selected groups, as far as they are wanted (NULL: all). BAT_STATE: none. */
bat_status bat_tuning_gather(bat_context *c, bool (*wanted)(const bat_document *document, int index));
/* Begins what is only shown, if what it is about was gathered; else, or when it cannot be shown, refuses. none: of BAT_STATE. */
bat_status bat_tuning_start(bat_context *c, const bat_tuning_kind *kind, bat_status gathered,
                            bat_string none);
/* Shows it anew, after one of its properties has changed; it ends where that fails. */
void bat_tuning_follow(bat_context *c, const bat_tuning_kind *kind);
/* From now on this is the last thing done. */
void bat_tuning_mark(bat_context *c, const bat_tuning_kind *kind, bool stepped);
/* Whether it is still the last thing done. */
bool bat_tuning_holds(const bat_context *c);
/* A number that changes when what the slider shows changes; 0: there is nothing to choose. */
uint32_t bat_tuning_version(const bat_context *c);
/* Gives the objects back as they were; Enter keeps them. False: there was nothing to choose. */
bool bat_tuning_cancel(bat_context *c);
bool bat_tuning_accept(bat_context *c);
void bat_tuning_show(bat_context *c, bat_overlay *overlay);
/* The box in view pixels of a box on the page. */
void bat_tuning_look(const struct bat_stage *stage, const double box[4], double seen[4]);
/* Whether one curve is selected that had another shape. Asked again it looks only through the steps made since. */
bool bat_tuning_has_earlier(bat_context *c);

#endif
