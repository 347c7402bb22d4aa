/* Where the copies of an array lie: in a row, in a grid, or on a circle. */
#ifndef BATTEN_EDITOR_EDIT_ARRAY_H
#define BATTEN_EDITOR_EDIT_ARRAY_H

#include <stdbool.h>

/* In the order of the property's choices. */
typedef enum bat_array_shape {
    BAT_ARRAY_ROW,
    BAT_ARRAY_GRID,
    BAT_ARRAY_CIRCLE,
    BAT_ARRAY_SHAPES
} bat_array_shape;

typedef struct bat_array {
    bat_array_shape shape;
    int count, rows; /* with what is copied; rows: of a grid */
    double
        gap[2]; /* between boxes, to the right and down, document units; the first also of a row, along it */
    double direction; /* of a row, degrees clockwise: 0 to the right */
    double radius;    /* of the circle, whose centre lies below what is copied */
    double
        angle; /* degrees clockwise to the last copy; from 360 on, one turn in which the last is as far from the first as all are */
    bool turns; /* copies on a circle turn with it; otherwise they stay upright */
} bat_array;

/* How many there are, with what is copied. */
int bat_array_count(const bat_array *array);
/* Whether copies would lie where others lie, because what separates them is nothing. box: around what is copied. */
bool bat_array_is_heap(const bat_array *array, const double box[4]);
/* How copy i, from 1, lies to what is copied. */
void bat_array_place(const bat_array *array, const double box[4], int i, double matrix[6]);

#endif
