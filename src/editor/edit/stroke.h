/*
 * An edit: one change of the document with everything needed to make it again, anywhere, with the same result. Tools
 * make edits, the journal keeps them, replay performs them: all three through the same two calls. A new kind of edit
 * adds a row to KINDS in stroke_record.c, its case in bat_edit_commit, and its strings in strings.def.
 */
#ifndef BATTEN_EDITOR_EDIT_STROKE_H
#define BATTEN_EDITOR_EDIT_STROKE_H

#include "curve/mirror.h"
#include "editor/edit/dashes.h"
#include "editor/session/context.h"
#include "editor/input/samples.h"
#include "editor/tables/tables.h"
#include "hands/sketch/intent.h"
#include "hands/sketch/meant.h"
#include <batten/width.h>

typedef enum bat_edit_kind {
    BAT_EDIT_NEW,
    BAT_EDIT_REDRAW,
    BAT_EDIT_SMOOTH,
    BAT_EDIT_JOIN,
    BAT_EDIT_LEVEL,
    BAT_EDIT_EXTEND,
    BAT_EDIT_CLOSE,
    BAT_EDIT_SEVERAL,
    BAT_EDIT_BLEND, /* a new curve between two ends, in the style of the first curve */
    BAT_EDIT_COUNT
} bat_edit_kind;

/* What a stroke over a curve with levels does when it does not name a level. */
typedef enum bat_level_choice {
    BAT_LEVEL_AUTO = -1, /* the coarsest level that comes within the tolerance follows the stroke */
    BAT_LEVEL_FREE = -2, /* the base is redrawn with its knots, details are kept */
    BAT_LEVEL_BARE = -3  /* the same, but details under the stroke are dropped */
} bat_level_choice;

enum { BAT_EDIT_PARTS = BAT_INTENT_PARTS };

/* One of several touching curves, redrawn by its part of the stroke. */
typedef struct bat_edit_part {
    bat_id object;
    int curve;
    bat_sketch_meaning meaning;
    double end[BAT_DIMENSION_MAX]; /* where the stroke is cut after this part, document units */
} bat_edit_part;

typedef struct bat_edit {
    bat_edit_kind kind;
    bat_id object; /* the changed object; NEW: the id it gets */
    int curve;
    int level;    /* LEVEL: the redrawn level, or a bat_level_choice */
    bat_id other; /* JOIN: the object joined to it; BLEND: that it leads to, which may be the same */
    int other_curve;
    bat_sketch_meaning meaning; /* NEW, REDRAW, EXTEND */
    int part_count;             /* SEVERAL; object and curve are the first part's */
    bat_edit_part part[BAT_EDIT_PARTS];
    bat_stage stage; /* the stroke's samples are in its pixels and lie on its ground */
    bat_sketch_options options;
    bat_style style;    /* NEW */
    bat_id parent;      /* NEW: the layer it goes into; 0: none */
    bat_dashing dashes; /* NEW */
    bool pressed;       /* NEW: the pen's pressure becomes the width along it */
    bat_mirror mirror;  /* on: the edit is made on both sides of this axis */
    bool on_extremes;   /* the curves become cubics that meet at extremes, in whole numbers */
    bool accepted;      /* the user accepted a fit that misses the tolerance */
    bat_samples samples;
} bat_edit;

/* The object's curve with that number, if strokes on the edit's ground can apply to it; otherwise NULL. */
const bat_curve *bat_edit_curve(const bat_document *document, const bat_edit *edit, bat_id object, int curve);

const char *bat_edit_name(bat_edit_kind kind);
bat_edit_kind bat_edit_named(const char *name); /* BAT_EDIT_COUNT: none */
bat_string bat_edit_label(bat_edit_kind kind);

/* What an edit makes of a document. Computed once; then shown, kept until it is accepted, or committed. */
typedef struct bat_edit_result {
    int count;                        /* curves: SEVERAL: one for each part; else 1; 0: there is no result */
    bat_curve *curve[BAT_EDIT_PARTS]; /* owned */
    bat_shape *shape;                 /* LEVEL: the levels whose finest curve[0] is, owned; else NULL */
} bat_edit_result;

/*
 * Computes what the edit makes of this document. live: a session that has all the samples and is ended here, or NULL.
 * BAT_OK, or BAT_TOLERANCE with the best that was found; otherwise the result is empty.
 */
bat_status bat_edit_compute(const bat_document *document, const bat_edit *edit, bat_sketch_live *live,
                            bat_edit_result *out, bat_sketch_report *report);
void bat_edit_result_clear(bat_edit_result *result); /* one that is empty stays so */
/* Computes the shape that a LEVEL edit makes: BAT_OK, or BAT_TOLERANCE with the best one found; otherwise none. */
bat_status bat_edit_shape(const bat_document *document, const bat_edit *edit, bat_shape **out,
                          bat_sketch_report *report);
/* Puts the curves of a result in the place of those that the edit changes, within a transaction; empties it, whatever it
 * returns. Not for NEW. */
bat_status bat_edit_put(bat_context *c, const bat_edit *edit, bat_edit_result *result);
/* The width along the curve that the pen's pressure gives a NEW edit's; stops: room for BAT_PRESSED_STOPS. 0: none. */
size_t bat_edit_pressed(const bat_edit *edit, const bat_curve *curve, bat_width_stop *stops);
/* Puts the result into the document as one undo step and one line of the journal, or changes nothing. Empties the
 * result, whatever it returns. */
bat_status bat_edit_commit(bat_context *c, const bat_edit *edit, bat_edit_result *result);

#endif
