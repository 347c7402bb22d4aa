/* Internal: moves that are laid through views. */
#ifndef BATTEN_FORM_CAMERA_VIEWS_H
#define BATTEN_FORM_CAMERA_VIEWS_H

#include <batten/camera.h>

/* Whether it can go through another view: its gaze is free, path and base are open, and each either a cubic or what a camera is made of that stands
 * still. */
bool bat_camera_takes_views(const bat_camera *camera);
typedef struct bat_view_report {
    size_t views; /* how many there are now */
    bool sudden;  /* two neighbours have one eye, and others have not */
} bat_view_report;

/*
 * A camera that goes through all views of another one and then through one more, with a knot at each: its path is the natural
 * cubic through the eyes; rotations and fields of view are C1 cubics that swing past no view. The views of a camera are its poses,
 * without levels, at the knots of path and base; neighbours that are the same are one. Levels, timing and duration stay. Where
 * two neighbours have one eye on a path of some length it turns in next to no time, since time goes by the way. BAT_STATE: the last view is this one; BAT_COUNT: BAT_CAMERA_KEYS_MAX there are; BAT_UNSUPPORTED: it
 * does not take views. O(views).
 */
bat_status bat_camera_with_view(const bat_camera *from, const bat_camera_pose *view, bat_camera **out,
                                bat_view_report *report);

#endif
