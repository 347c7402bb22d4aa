/* The tangents tool's state, and what its files share: tangents.c (events), state.c (what it knows of its spline), and
 * the files named below. Places and directions are in space; those of the page have z = 0. */
#ifndef BATTEN_EDITOR_TOOLS_TANGENTS_STATE_H
#define BATTEN_EDITOR_TOOLS_TANGENTS_STATE_H

#include "base/vec.h"
#include "curve/mirror.h"
#include "editor/view/stage.h"
#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"
#include "editor/tools/tangents/draft.h"

typedef enum bat_splining_state {
    BAT_SPLINING_IDLE,
    BAT_SPLINING_PRESSED, /* the pen is down and has not moved */
    BAT_SPLINING_DRAGGING /* it has moved or placed a point; a transaction is open unless that was the first */
} bat_splining_state;

typedef enum bat_tangents_part {
    BAT_PART_NOTHING,
    BAT_PART_POINT,
    BAT_PART_DIRECTION, /* the circle around a point, or the arrow in it */
    BAT_PART_LEFT,      /* the ends of the handles */
    BAT_PART_RIGHT,
    BAT_PART_CURVE,  /* the curve of the chosen spline */
    BAT_PART_FIRST,  /* the first point, which closes the curve */
    BAT_PART_OTHER,  /* another spline */
    BAT_PART_OUTLINE /* a selected curve that is no spline */
} bat_tangents_part;

typedef struct bat_spline_hit {
    bat_tangents_part part;
    int point;
    int segment; /* CURVE: segment numbered as in bat_tangents, and where on it */
    double t;
    bat_id object; /* OTHER, OUTLINE */
    int curve;     /* OUTLINE: which of its curves, and where on it */
    double u;
} bat_spline_hit;

typedef struct bat_splining {
    bat_id object;     /* the chosen spline; 0: none */
    int point;         /* its chosen point; -1: none */
    bool on_direction; /* keys turn the direction at the point instead of moving the point */
    bool placing;      /* the next tap adds a point; with no object: `first` is the only one yet */
    double first[3], first_direction[3];
    int dimension; /* of what is being placed while `first` is its only point */

    bat_splining_state state;
    bat_device device;
    bat_spline_hit press; /* what the pen has grabbed */
    bat_string step;      /* the label of the resulting step */
    bat_draft draft;
    double start[2], at[2], travelled; /* view pixels */
    double base[3], base_tension[2];   /* of the point at the start of the drag */
    double plane[3], rise[3]; /* normals: of the plane that the point moves in (none: across the gaze) or its
                                        * direction turns in; of the direction that Alt moves it in */
    bat_mirror mirror;        /* on: points i and pair_sum - i of the draft mirror each other */
    int pair_sum;
    bool due, failed; /* the document lacks the draft's last change; putting it there failed */
    bool snapped;
    double guide[3]; /* the direction that was snapped to */

    double tap_time, tap_at[2]; /* of the last tap, for double taps */
    bat_spline_hit tap;

    bool hovering, hover_changed;
    double hover[2]; /* view pixels */
    bat_spline_hit over;
    int near; /* the point whose circle shows because the pen is near; -1: none */
    uint64_t over_revision;
    bat_stage over_stage;

    bat_joint *joints; /* of the chosen spline as of joints_revision */
    bat_id joints_object;
    uint64_t joints_revision;
} bat_splining;

/* View pixels: the radius of the prompt's circle; the radius beyond which pulling the arrow sets the tension. */
#define BAT_PROMPT_RADIUS 44.0
#define BAT_TENSION_RADIUS 62.0

void bat_splining_free(bat_splining *s); /* resets everything */
/* The chosen spline, or NULL; deselects one that is gone. */
const bat_spline *bat_splining_spline(bat_context *c);
/* How the next spline is made; how the chosen one is, or without one the next. */
bat_tangents_options bat_splining_next_options(const bat_context *c);
bat_tangents_options bat_splining_options(const bat_context *c);
/* How it passes through its points, or the next spline will. */
bat_tangents_mode bat_splining_mode(const bat_context *c);
/* Whether it is of even curvature: there are no directions then. */
bool bat_splining_is_even(const bat_context *c);
/* Its object. */
const bat_object *bat_splining_object(const bat_context *c);
/* Its joints; NULL: no spline, or out of memory. */
const bat_joint *bat_splining_joints(bat_context *c);
vec bat_splining_point(const bat_spline *spline, int point);
/* The direction of the curve at a point, of length 1. */
vec bat_splining_direction(const bat_spline *spline, const bat_joint *joints, int point);
/* The chord from a point to its neighbour, of length 1; false at the end of an open spline. */
bool bat_splining_chord(const bat_spline *spline, const bat_joint *joints, int point, int step, vec *out);
/* The normal of the plane of the chords at a point, turned away from the eye; where they have none, of the whole
 * spline's plane, or else the gaze. */
vec bat_splining_normal(bat_context *c, const bat_spline *spline, const bat_joint *joints, int point);
/* A direction turned about that which is at right angles to it in an axis of length 1; positive turns are clockwise on the page. */
vec bat_splining_turned(vec direction, vec axis, double cosine, double sine);

/* Where a place is seen, drawing coordinates; where a direction there is seen to go, of length 1 (0 0: at the eye). */
void bat_splining_seen(const bat_context *c, vec at, double out[2]);
void bat_splining_seen_way(const bat_context *c, vec at, vec direction, double out[2]);

/* show.c */
void bat_splining_overlay(bat_context *c, bat_overlay *overlay);
/* find.c: what lies under a view pixel; notes the point whose circle is near. */
bat_spline_hit bat_splining_find(bat_context *c, const double pixel[2], bat_device device);

/* change.c: loading the chosen spline's values into the draft, and committing them as one step. */
bat_status bat_splining_load(bat_context *c);
bat_status bat_splining_commit(bat_context *c, bat_string step);
/* whole.c: finds out whether the draft as loaded is its own mirror image; the point that mirrors another (-1: it is
 * not); after a change of a point, the one that mirrors it follows. */
void bat_splining_pair(bat_context *c);
/* The segment that mirrors another; -1: none does. */
int bat_splining_twin_segment(bat_context *c, int segment);
/* The draft becomes `longer`, which has a point more at t on a segment, and the one that mirrors it; *index: of the
 * first, which that may move. */
bat_status bat_splining_insert_twin(bat_context *c, const bat_spline *longer, int segment, double t,
                                    const bat_tangents_options *options, int *index);
int bat_splining_partner(const bat_splining *s, int point);
void bat_splining_follow(bat_splining *s, int point);
/* Notifies the user of what was done, or why it was not. */
void bat_splining_tell(bat_context *c, bat_status status, bat_string done);
double bat_splining_tension(double value); /* clamped to its limits */
/* Adds a point on the curve to the draft; *index: its index; *deviation may be NULL. */
bat_status bat_splining_draft_insert(bat_context *c, int segment, double t, int *index, double *deviation);
/* Each makes one step and notifies the user. */
bat_status bat_splining_insert(bat_context *c, int segment, double t);
bat_status bat_splining_remove_point(bat_context *c, int point);
bat_status bat_splining_default(bat_context *c, int point);
bat_status bat_splining_close(bat_context *c);
/* Makes a new object and chooses it; without a notice. */
bat_status bat_splining_make(bat_context *c, const bat_spline *spline);
bat_status bat_splining_give_free(bat_context *c);
/* The mode of the chosen spline changes, in one step; without one only that of the next. */
bat_status bat_splining_set_mode(bat_context *c, double mode);

/* tangents.c: stops placing points; false: none were being placed. keys.c: commands of the tool. */
bool bat_splining_stop(bat_context *c);
bat_status bat_splining_command(bat_context *c, bat_command_id id);
/* The state of the tool. */
bat_splining *bat_splining_of(const bat_context *c);

#endif
