/*
 * The gizmo: handles about a point in space, by which what lies there is moved along an axis of the drawing, moved in the
 * plane of two, or turned about one. Its arms point to where the eye is. In a view face-on there is none.
 */
#ifndef BATTEN_EDITOR_VIEW_GIZMO_H
#define BATTEN_EDITOR_VIEW_GIZMO_H

#include "editor/view/stage.h"

/* Of each three parts one for x, y, z: what moves along the axis, what moves in the plane at right angles to it, what turns
 * about it. */
enum {
    BAT_GIZMO_ALONG = 0,
    BAT_GIZMO_ACROSS = 3,
    BAT_GIZMO_ABOUT = 6,
    BAT_GIZMO_PARTS = 9,
    BAT_GIZMO_NONE = -1
};
enum { BAT_GIZMO_ARC = 13 };

typedef struct bat_gizmo {
    double middle[3], arms[3];   /* along each axis, document units; signed */
    bool there[BAT_GIZMO_PARTS]; /* what is seen well enough to be dragged */
} bat_gizmo;

/* False: the view is face-on, or the point is behind the eye. */
bool bat_gizmo_place(const bat_stage *stage, const double middle[3], bat_gizmo *out);
/* A point of it by shares of its arms. */
void bat_gizmo_at(const bat_gizmo *gizmo, double x, double y, double z, double at[3]);
/* Where the handle of a part is; the arc of one that turns, its axis being `axis`. */
void bat_gizmo_handle(const bat_gizmo *gizmo, int part, double at[3]);
void bat_gizmo_arc(const bat_gizmo *gizmo, int axis, double points[3 * BAT_GIZMO_ARC]);
/* The part at a pixel: the nearest handle within reach, or else an arm or an arc that is near; BAT_GIZMO_NONE. */
int bat_gizmo_find(const bat_gizmo *gizmo, const bat_stage *stage, const double pixel[2], double reach);
/* What a drag between two pixels does: how far along x, y, z, or, with a part that turns, radians about x, y, z. False: there
 * the pen is too far from where the part leads. */
bool bat_gizmo_drag(const bat_gizmo *gizmo, const bat_stage *stage, int part, const double from[2],
                    const double to[2], double by[3]);
/* That as three rows of four numbers (base/pose.h). */
void bat_gizmo_rows(const bat_gizmo *gizmo, int part, const double by[3], double rows[12]);

#endif
