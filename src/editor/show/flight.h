/* Where the camera that is looked at is, what it sees, and how it is shown. */
#ifndef BATTEN_EDITOR_SHOW_FLIGHT_H
#define BATTEN_EDITOR_SHOW_FLIGHT_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include <batten/camera.h>

/* The camera of the move that is looked at; NULL: there is none. */
const bat_camera *bat_flight_camera(const bat_context *c);
/* How many seconds the move takes that is looked at, of a camera or of a skeleton; 0: there is none. */
double bat_flight_duration(const bat_context *c);
/* What moves by itself stands in the scene as it does at the playhead. */
void bat_flight_stand(const bat_context *c);
/* What the camera sees at the playhead, in the window as it is. False: there is no camera, or nothing can be seen by it. */
bool bat_flight_view(const bat_context *c, bat_viewpoint *out);
/* The same in a window of that size. */
bool bat_flight_sees(const bat_context *c, const double size[2], bat_viewpoint *out);
/* Its pyramid at the playhead, and faint ones every half second. */
void bat_flight_show(const bat_context *c, bat_overlay *overlay);

#endif
