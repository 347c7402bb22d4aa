/* The sketch tool's state. */
#ifndef BATTEN_EDITOR_TOOLS_SKETCH_SKETCHING_H
#define BATTEN_EDITOR_TOOLS_SKETCH_SKETCHING_H

#include "editor/session/context.h"
#include "editor/edit/stroke.h"
#include "editor/pick/pick.h"
#include "editor/input/stabiliser.h"
#include "editor/tools/sketch/again.h"
#include "editor/tools/sketch/hairs.h"
#include "editor/tools/sketch/hold.h"
#include "editor/tools/sketch/meaning.h"

typedef enum bat_sketching_state {
    BAT_SKETCHING_IDLE,    /* hovering or away */
    BAT_SKETCHING_DRAWING, /* the pen is down */
    BAT_SKETCHING_PENDING  /* a fit that misses the tolerance waits for yes or no */
} bat_sketching_state;

/* What the last frame's preview found; zero when it is not valid. */
typedef struct bat_sketching_preview {
    bat_status status;
    bat_curve *curve; /* owned; NULL: nothing to show */
    bat_sketch_report report;
    double *blends; /* the two transitions' points, x y, owned */
    size_t blend_counts[2];
} bat_sketching_preview;

typedef struct bat_sketching {
    bat_sketching_state state;
    bool hovering, hover_changed; /* the pen is above; the pick below is out of date */
    bat_device device;
    double hover[2];        /* view pixels; while drawing, where the pen is */
    bat_pick pick;          /* IDLE: what would be redrawn */
    uint64_t pick_revision; /* of the document it was picked from */
    bat_stage pick_stage;

    /* DRAWING */
    bat_edit edit;         /* of the stroke under the pen */
    bat_steady steady;     /* between the pen and the samples */
    bat_hold hold;         /* held at its end it becomes a figure */
    bool forced;           /* what it means was said beforehand */
    bat_meaning meaning;   /* what it may mean */
    bool nothing;          /* it means none of what it may mean */
    bool smoothing;        /* Alt was held at some moment of the stroke */
    double travelled;      /* pixels, the greatest distance from the first sample */
    bat_sketch_live *live; /* NULL: no session (it is begun when it is needed) */
    size_t fed;            /* samples the session has */
    bool preview_due;
    bat_sketching_preview preview;
    size_t predicted_count;
    double predicted[2 * 16]; /* document units */

    bat_hairs hairs; /* careless strokes over one line, the last ones done */
    bat_again again; /* IDLE: what the last stroke could mean besides */

    /* PENDING, and DRAWING over it while it may still be a tap */
    bool has_pending;
    bat_edit pending; /* with its own samples */
    bat_curve *pending_curve;
    bat_sketch_report pending_report;
} bat_sketching;

/* Of the tool in this editor. */
bat_sketching *bat_sketching_of(const bat_context *c);
/* Whether the last stroke can be read again; takes it as another of its readings (again.h). */
bool bat_sketching_readings(const bat_context *c, const bat_sketching *s);
bat_status bat_sketching_read_as(bat_context *c, bat_sketching *s, int reading);
/* Fits it closer or fairer. */
bat_status bat_sketching_refit(bat_context *c, bat_sketching *s, double amount, bool done);

#endif
