/*
 * A line of a surface, redrawn by a stroke: one change with everything needed to make it again, anywhere, with the same
 * result. The tool makes it, the journal keeps it, replay performs it: all three through the same two calls.
 */
#ifndef BATTEN_EDITOR_EDIT_SURFACE_LINE_H
#define BATTEN_EDITOR_EDIT_SURFACE_LINE_H

#include "editor/edit/surface_pair.h"
#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include "text/json.h"
#include "text/text.h"
#include <batten/document.h>
#include <batten/relief.h>
#include <batten/view.h>

#define BAT_LINE_EDIT "surface-redraw" /* its name in the journal */
enum { BAT_LINE_EDGES = 4, BAT_LOCK_MOST = 3, BAT_LINE_PIXELS = 1 << 16 };

typedef struct bat_line_edit {
    bat_id object;
    bat_direction direction; /* BAT_U: the line at u = at */
    double at;
    bat_viewpoint seen; /* the stroke is in its pixels */
    double along
        [3]; /* of the ruled surface that the stroke is cast on; zero: as bat_surface_sketch chooses it */
    double reach;     /* parameter units; 0: the usual one */
    double tolerance; /* document units */
    int lock
        [BAT_LINE_EDGES]; /* what stays at the edges u low, u high, v low, v high: 0 nothing, 1 the place, 2 the tangents,
                           * too, 3 the curvature, too; directions that are closed have none */
    int level;         /* of a surface with levels: the one that is redrawn, 0 is the base; else no matter */
    bat_mirror mirror; /* on: the line's mirror image is redrawn, too, if there is one */
    size_t count;
    const double *pixels; /* x y; borrowed */
} bat_line_edit;

/* What an edit makes: the surface and, where another is its mirror image, that. */
typedef struct bat_line_made {
    bat_surface *surface;
    bat_id twin;        /* 0: none */
    bat_surface *image; /* the twin as it becomes; NULL: none */
    bat_relief *relief; /* with levels: all of them, of which the surface is the finest; NULL: it has none */
    bat_surface_way way;
} bat_line_made;

void bat_line_made_clear(bat_line_made *made);
/* The edit performed on copies, which the caller clears. Of a surface with levels the level is redrawn on its own knots, and
 * what lies above rides along; there is no symmetry. Statuses as bat_surface_sketch and bat_surface_redraw_image;
 * BAT_ARGUMENT: the document has no such surface. The report is filled in as far as the call came;
 * where the surface is its own image, redraw.moved holds both lines'. */
bat_status bat_line_edit_compute(const bat_document *document, const bat_line_edit *edit, bat_line_made *out,
                                 bat_surface_sketch_report *report);
/* Puts what was made into the document as one undo step and one line of the journal, or changes nothing. */
bat_status bat_line_edit_commit(bat_context *c, const bat_line_edit *edit, const bat_line_made *made);
/* The edit with what is locked at one edge locked at its image, too. */
bat_line_edit bat_line_edit_paired(const bat_line_edit *edit, const bat_surface_pair *pair);
/* How far an edit of this line would reach; as bat_surface_redraw, which it calls with the line as it is. */
bat_status bat_line_edit_probe(const bat_surface *surface, const bat_line_edit *edit,
                               bat_surface_redraw_report *report);

/* The line of the journal without its digest and closing brace. */
void bat_line_edit_write(const bat_line_edit *edit, bat_text *line);
/* *pixels: the stroke's, which the caller frees, even after a failure. */
bat_status bat_line_edit_read(const bat_json *json, bat_line_edit *out, double **pixels,
                              bat_problem *problem);
/* Performs the edit on a line of the journal. */
bat_status bat_line_edit_perform(bat_context *c, const bat_json *json, bat_problem *problem);

#endif
