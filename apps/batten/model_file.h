/* Files of other programs that hold shapes in space: which of them a name means, and how they are written. */
#ifndef BATTEN_APPS_MODEL_FILE_H
#define BATTEN_APPS_MODEL_FILE_H

#include <batten/document.h>
#include <batten/format.h>

typedef struct model_kind {
    const char *ending; /* with its point */
    /* What is written comes back as it was; or: */
    bat_status (*write)(const bat_model *model, char **bytes, size_t *size);
    /* Faces, of which one side is the outer one. */
    bat_status (*divide)(const bat_model *model, double tolerance, char **bytes, size_t *size);
    const char *holds;
    double unit;      /* of the file, in millimetres */
    bool up_is_y;     /* else up is z */
    bool of_drawings; /* whether `batten convert` makes it of a drawing */
} model_kind;

/* NULL: the name ends in none of them. */
const model_kind *model_kind_of(const char *name);
/* Writes the file; in: the name that failures are reported under. Returns 0, or an exit status. */
int model_put(const char *in, const char *out, const model_kind *kind, const bat_model *model,
              double tolerance);

/* Turns the surfaces that are closed in a direction whose normals point inward, by exchanging u and v. On failure some are not. */
bat_status model_face_outward(bat_model *model);

/* How the page stands in a room: as a wall, its up is up; as a floor, up is towards the eye. */
typedef enum page_stand { PAGE_IS_WALL, PAGE_IS_FLOOR } page_stand;
/* A floor where a plane stands on it at right angles, else a wall. */
page_stand page_stand_of(const bat_document *document);
/*
 * What is seen of a drawing in space: surfaces, meshes (as one) and curves, in the file's unit and the file's up; closed
 * surfaces with their normals outward. flat: the curves that lie on the page, which are left out. BAT_COUNT: nothing is in
 * space. Released by bat_model_clear.
 */
bat_status model_of_drawing(const bat_document *document, const model_kind *kind, page_stand stand,
                            bat_model *out, int *flat);

#endif
