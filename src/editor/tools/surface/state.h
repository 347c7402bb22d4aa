/*
 * The state of the surface tool: the parameter line that is lit, and what the pen is doing to it. The lit line runs
 * through a place of the surface, where its grip is; the line in the other direction through the same place is shown,
 * too.
 */
#ifndef BATTEN_EDITOR_TOOLS_SURFACE_STATE_H
#define BATTEN_EDITOR_TOOLS_SURFACE_STATE_H

#include "editor/edit/surface_line.h"
#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"
#include "editor/view/stage.h"
#include <batten/editor.h>
#include <batten/view.h>

enum { BAT_LINE_SAMPLES = 193 }; /* of a line, where its picture is measured or shown */

/* A line of a surface in the document; object 0: none. */
typedef struct bat_line {
    bat_id object;
    bat_direction direction; /* BAT_U: the line at u */
    double at[2];            /* u and v of the grip; the line is at at[direction] */
} bat_line;

typedef enum bat_lining {
    BAT_LINING_NOT,    /* the pen is up */
    BAT_LINING_STROKE, /* it draws a marking */
    BAT_LINING_DRAW,   /* it redraws the lit line */
    BAT_LINING_SLIDE,  /* it drags the grip */
    BAT_LINING_TURN    /* it drags the handle of the sheet for strokes */
} bat_lining;

/* What decides how far an edit of the lit line reaches, and what was found. */
typedef struct bat_line_reach {
    bat_line line;
    uint64_t revision;
    int lock[BAT_LINE_EDGES]; /* with those of the image's edges */
    double radius;
    bool known;      /* false: the line cannot move */
    double moved[2]; /* of the crossing parameter: where movement ends */
} bat_line_reach;

typedef struct bat_surfacing {
    bat_line lit;
    bat_lining doing;
    bat_device device;
    bool hovering;
    double hover[2], start[2]; /* view pixels */
    bat_line before;           /* as it was when the grip was taken */
    double free[3];            /* the direction of the sheet that was chosen last; zero: none was */
    double ruling_before, free_before[3]; /* as they were when the handle was taken */
    bat_viewpoint seen;                   /* at pen down */
    double *pixels;                       /* of the stroke, owned */
    size_t count, room;
    /* what the stroke makes of the surface */
    bool due; /* it has gone on since */
    bat_status status;
    bat_line_made made; /* owned; without a surface: nothing */
    /* with symmetry, the image of its surface as it was when it was looked for */
    bat_surface_pair pair;
    bat_id paired;
    uint64_t paired_revision;
    bat_mirror paired_in;
    bat_surface_sketch_report report;
    bat_sketch_report said; /* the part of it that is shown to the user */
    bat_line_reach reach;
} bat_surfacing;

/* The surface of the lit line as it is in the document; NULL: there is none, and no line is lit. */
const bat_surface *bat_surfacing_surface(bat_context *c, bat_surfacing *s);
/* How the view shows a surface: as bat_stage_viewpoint, with the eye before the whole surface. */
bat_status bat_surfacing_view(const bat_context *c, const bat_surface *surface, bat_viewpoint *out);
/* Where a point of a surface is seen, view pixels; where it is to be drawn, drawing coordinates. */
bool bat_surfacing_pixel(const bat_viewpoint *view, const double point[3], double pixel[2]);
bool bat_surfacing_seen(const bat_context *c, const bat_viewpoint *view, const double point[3], double at[2]);
/* `count` points of the line at `value`, evenly from `from` to `to` of the parameter along it. */
void bat_surfacing_trace(const bat_surface *surface, bat_direction direction, double value, double from,
                         double to, int count, double *points);
/* The distance in view pixels of a pixel from the line at `value`, as it is seen. */
double bat_surfacing_distance(const bat_viewpoint *view, const bat_surface *surface, bat_direction direction,
                              double value, const double pixel[2]);

/* Whether the grip of the lit line is there. */
bool bat_surfacing_on_grip(bat_context *c, bat_surfacing *s, const double pixel[2]);
/* Which of the two lines through the grip is there, the lit one first. 0: neither, 1: the lit one, 2: the other. */
int bat_surfacing_line_there(bat_context *c, bat_surfacing *s, const double pixel[2]);
/* Whether a stroke that begins there redraws the lit line; s->seen becomes the view of its surface. */
bool bat_surfacing_at_line(bat_context *c, bat_surfacing *s, const double pixel[2]);
/* Whether a stroke that began under the pen would redraw the lit line. */
bool bat_surfacing_near(bat_context *c, bat_surfacing *s);
/* Where the padlock of an edge is: beside the edge's middle, view pixels; false: the edge is none, or not seen. */
bool bat_surfacing_padlock(bat_context *c, bat_surfacing *s, int edge, double pixel[2]);

/* ruling.c: the direction of the sheet for strokes as it was chosen; zero: the surface's own. */
void bat_surfacing_along(const bat_context *c, const bat_surfacing *s, double along[3]);
/* Where the grip and the handle of the sheet are seen, view pixels; false: no line is lit, or not seen. */
bool bat_surfacing_handle(bat_context *c, bat_surfacing *s, double grip[2], double pixel[2]);
/* The same of its image in a mirror; NULL: of itself. */
bool bat_surfacing_handle_in(bat_context *c, bat_surfacing *s, const bat_mirror *mirror, double grip[2],
                             double pixel[2]);
/* show.c: the same with symmetry; false, too: it has no image. */
bool bat_surfacing_image_handle(bat_context *c, bat_surfacing *s, double grip[2], double pixel[2]);
bool bat_surfacing_on_handle(bat_context *c, bat_surfacing *s, const double pixel[2]);
/* The handle is taken; it goes with the pen; it is let go, or was tapped; all is as it was before. */
void bat_surfacing_turn_begin(const bat_context *c, bat_surfacing *s);
void bat_surfacing_turn(bat_context *c, bat_surfacing *s);
void bat_surfacing_turn_end(bat_context *c, bat_surfacing *s);
void bat_surfacing_turn_back(bat_context *c, bat_surfacing *s);

/* The line that a marking means, or a tap chooses; object 0: the stroke is on no surface. BAT_MEMORY. */
bat_status bat_surfacing_pick(bat_context *c, const bat_stroke *marking, bool tap, bat_line *out);
/* Moves the line to the place under the pixel; it stops at the edges, the middle and knots unless it is `loose`. */
void bat_surfacing_slide(bat_context *c, const bat_surface *surface, const double pixel[2], bool loose,
                         bat_line *line);
/* Finds where an edit of the lit line would end; false: the line cannot move. */
bool bat_surfacing_reach(bat_context *c, bat_surfacing *s);

/* With symmetry, the image of the lit line's surface; image 0: none. */
const bat_surface_pair *bat_surfacing_pair(bat_context *c, bat_surfacing *s);

/* The stroke so far as an edit of the lit line; false: there is none. */
bool bat_surfacing_edit(bat_context *c, bat_surfacing *s, bat_line_edit *out);
/* Brings the preview up to date; drops it; puts it into the document, or says why not. */
void bat_surfacing_follow(bat_context *c, bat_surfacing *s);
void bat_surfacing_drop(bat_surfacing *s);
void bat_surfacing_finish(bat_context *c, bat_surfacing *s);
/* Why the stroke makes nothing; BAT_STRING_COUNT: it does. */
bat_string bat_surfacing_refusal(const bat_surfacing *s);

void bat_surfacing_show(bat_context *c, bat_surfacing *s, bat_overlay *list);

#endif
