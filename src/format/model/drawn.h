/* Internal to formats: what of a drawing is in space, as models of other programs hold it. */
#ifndef BATTEN_FORMAT_DRAWN_H
#define BATTEN_FORMAT_DRAWN_H

#include "document/document.h"
#include <batten/format.h>

/* As the drawing says; else a floor where a plane stands on it at right angles, else a wall. O(objects). */
bat_stand bat_stand_of(const bat_document *document);

/* The room that a model is put into. */
typedef struct bat_room {
    bat_stand stand;
    double unit;  /* millimetres */
    bool up_is_y; /* else up is z */
} bat_room;
/* Three rows: where x, y and z of the room come from on the page. A rotation by right angles. */
void bat_room_way(const bat_room *room, double way[9]);
/*
 * What is seen of a drawing in space: surfaces, meshes (as one) and curves, in the room's unit and the room's up; closed
 * surfaces with their normals outward. flat: the curves that lie on the page, which are left out. BAT_COUNT: nothing is in
 * space. Released by bat_model_clear.
 */
bat_status bat_model_of_drawing(const bat_document *document, const bat_room *room, bat_model *out,
                                int *flat);
/* Turns the surfaces that are closed in a direction whose normals point inward, by exchanging u and v. On failure some are not. */
bat_status bat_model_face_outward(bat_model *model);

#endif
