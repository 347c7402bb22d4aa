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
/* B-splines of a file whose unit is a millimetre and whose up is z, as a drawing of which one unit is a millimetre: upright before
 * a wall, or where all lie in z = 0 seen from above. A mesh is left out. Statuses as of the reader. */
typedef bat_status bat_model_reader(const char *text, size_t size, bat_model *out, bat_problem *problem);
bat_status bat_model_open(bat_model_reader *reader, const char *text, size_t size, bat_document **out,
                          int *left_out, bat_problem *problem);
/* And back. BAT_COUNT: nothing is in space; the problem says why there is none. */
typedef bat_status bat_model_writer(const bat_model *model, char **bytes, size_t *size);
bat_status bat_model_save(bat_model_writer *writer, const bat_document *document, char **bytes, size_t *size,
                          bat_problem *problem);
/* Turns the surfaces that are closed in a direction whose normals point inward, by exchanging u and v. On failure some are not. */
bat_status bat_model_face_outward(bat_model *model);

#endif
