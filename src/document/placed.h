/* What the kinds have in common that show a picture: its own part begins with this. */
#ifndef BATTEN_DOCUMENT_PLACED_H
#define BATTEN_DOCUMENT_PLACED_H

#include "document/picture.h"

typedef struct bat_placed {
    double matrix[6]; /* from the picture's pixels to the document */
    bat_picture *picture;
} bat_placed;

/* Fills *out without a reference to the picture; -0 becomes 0, so that equal objects have equal bits. BAT_NUMBER: the matrix flattens,
 * or leads too far. */
bat_status bat_placed_set(const bat_picture *picture, const double matrix[6], bat_placed *out);
void bat_placed_corners(const bat_placed *placed, double corners[8]); /* as bat_object_corners */
/* As bat_kind_type has it. */
void bat_placed_bounds(const void *own, double box[4]);

#endif
