/* The sketch tool's state. */
#ifndef BATTEN_EDITOR_TOOLS_SKETCH_SKETCHING_H
#define BATTEN_EDITOR_TOOLS_SKETCH_SKETCHING_H

#include "editor/session/context.h"
#include "editor/edit/stroke.h"
#include "editor/pick/pick.h"
#include "editor/input/stabiliser.h"
#include "editor/show/followers.h"
#include "editor/tools/sketch/again.h"
#include "editor/tools/sketch/hairs.h"
#include "editor/tools/sketch/hold.h"
#include "editor/tools/sketch/kept.h"
#include "editor/tools/sketch/meaning.h"

typedef enum bat_sketching_state {
    BAT_SKETCHING_IDLE,    /* pen hovering or away */
    BAT_SKETCHING_DRAWING, /* the pen is down */
    BAT_SKETCHING_PENDING  /* a fit that misses the tolerance awaits yes or no */
} bat_sketching_state;

/* The result of the last frame's preview; zero when not valid. */
typedef struct bat_sketching_preview {
    bat_status status;
    bat_curve *curve; /* owned; NULL: nothing to show */
    bool converges;   /* it is what several careless strokes mean together */
    bat_sketch_report report;
    bat_followers followers; /* of the curve */
    size_t stop_count;       /* the width along it that the pen's pressure means; 0: none */
    bat_width_stop stops[BAT_PRESSED_STOPS];
} bat_sketching_preview;

typedef struct bat_sketching {
    bat_sketching_state state;
    bool hovering, hover_changed; /* the pen is above; the pick below is out of date */
    bat_device device;
    double hover[2];        /* view pixels; while drawing, where the pen is */
    bat_pick pick;          /* IDLE: what would be redrawn */
    uint64_t pick_revision; /* of the document it was picked from */
    bat_stage pick_stage;
    bat_stage over; /* what a stroke would land on */

    /* DRAWING */
    bat_edit edit;           /* made by the stroke under the pen */
    bat_steady steady;       /* between the pen and the samples */
    bat_sketch_hold hold;    /* a stroke held at its end offers a figure */
    bool forced;             /* its meaning was given in advance */
    bat_meaning meaning;     /* its possible meanings */
    double tap[2], tap_time; /* of the last dot: view pixels, ms */
    uint64_t tap_revision;   /* of the document after it */
    bool tap_touched;        /* it was made by a finger, or by a palm */
    bool nothing;            /* none of its possible meanings is allowed */
    bool smoothing;          /* Alt was held at some point of the stroke */
    size_t dropped;          /* samples that do not land on the ground */
    double travelled;        /* pixels, the greatest distance from the first sample */
    bat_sketch_live *live;   /* NULL: none yet (it starts when needed) */
    size_t fed;              /* samples fed to the session */
    bool preview_due;
    bat_sketching_preview preview;
    size_t predicted_count;
    double predicted[2 * 16]; /* document units */

    bat_hairs hairs; /* the last careless strokes over one line */
    bat_again again; /* IDLE: other readings of the last stroke */
    bat_kept kept;   /* strokes that can still be refitted */

    /* PENDING, and DRAWING over it while it may still be a tap */
    bool has_pending;
    bat_edit pending; /* with its own samples */
    bat_edit_result pending_result;
    bat_sketch_report pending_report;
} bat_sketching;

/* The state of the tool in this editor. */
bat_sketching *bat_sketching_of(const bat_context *c);
/* Whether the last stroke has other readings; and takes it as one of them (again.h). */
bool bat_sketching_readings(const bat_context *c, const bat_sketching *s);
bat_status bat_sketching_read_as(bat_context *c, bat_sketching *s, int reading);
/* The stroke that the selection offers to refit, when that is not the last one; NULL: none. */
const bat_kept_stroke *bat_sketching_offered(const bat_context *c, const bat_sketching *s);
void bat_sketching_show_kept(const bat_context *c, bat_overlay *overlay);
/* Fits that stroke, or else the last one, closer or fairer. */
bat_status bat_sketching_refit(bat_context *c, bat_sketching *s, double amount, bool done);

#endif
