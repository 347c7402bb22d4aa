/*
 * The room around the page, which lies in it as a floor or stands as a wall: the eye turns about the room's upright, so that
 * what is upright stays so.
 *
 * The pose of a view in its room is that of view.h's table top, three angles in degrees: how far the room has turned, how
 * far the eye has come down, from straight above (0) by level (90) to straight below (180), and the roll. On a floor it is
 * that of the page; the page as a wall is seen face-on from 0 90 0.
 */
#ifndef BATTEN_EDITOR_VIEW_ROOM_H
#define BATTEN_EDITOR_VIEW_ROOM_H

#include <batten/document.h>

#include "editor/view/view.h"

typedef struct bat_attitude {
    double turn, tilt, roll;
} bat_attitude;

/* Whether the page is a wall; a drawing of which nothing is in space lies on the floor. O(objects). */
bool bat_room_is_wall(const bat_document *document);
/* The room's x, y and z on the page, three numbers each: right, towards the eye, down. */
void bat_room_axes(bool wall, double axes[9]);
bat_attitude bat_room_attitude(const bat_view *view, bool wall);
/* About the pivot, as bat_view_pose. */
void bat_room_take(bat_view *view, bool wall, const bat_attitude *pose);
/* Turns by degrees, and lets the eye come down; over the room's poles it goes on with the head down. held, NULL or 0 at first:
 * how far a drag that comes to a pole has gone on since; the first degrees beyond it do nothing, so that it is met. */
void bat_room_orbit(bat_view *view, bool wall, double turn, double down, double *held);
/* Looks along a direction, upright. */
void bat_room_look_along(bat_view *view, bool wall, const double ahead[3]);
/* Looks along a direction, with this seen going up; one along the gaze is as none: without a roll. */
void bat_view_look_along(bat_view *view, const double ahead[3], const double up[3]);

#endif
