#include "editor/edit/array.h"
#include "base/matrix.h"
#include "base/real.h"
#include <math.h>

static const double TURN = 360; /* degrees */

int bat_array_count(const bat_array *array) {
    return array->shape == BAT_ARRAY_GRID ? array->count * array->rows : array->count;
}

static double step(const bat_array *array, const double box[4], int axis) {
    return box[axis + 2] - box[axis] + array->gap[axis];
}

/* Degrees from one copy to the next. */
static double step_angle(const bat_array *array) {
    const double angle = fmin(fmax(array->angle, -TURN), TURN);
    if (fabs(angle) == TURN) return angle / array->count;
    return array->count > 1 ? angle / (array->count - 1) : 0;
}

bool bat_array_is_heap(const bat_array *array, const double box[4]) {
    if (array->shape == BAT_ARRAY_CIRCLE)
        return step_angle(array) == 0 || (array->radius == 0 && !array->turns);
    if (array->count > 1 && step(array, box, 0) == 0) return true;
    return array->shape == BAT_ARRAY_GRID && array->rows > 1 && step(array, box, 1) == 0;
}

static void place_on_circle(const bat_array *array, const double box[4], int i, double matrix[6]) {
    const double middle[2] = {box[0] / 2 + box[2] / 2, box[1] / 2 + box[3] / 2};
    const double centre[2] = {middle[0], middle[1] + array->radius};
    const double angle = i * step_angle(array) * BAT_PI / 180;
    bat_matrix_rotation(angle, centre, matrix);
    if (array->turns) return;
    const double x = matrix[0] * middle[0] + matrix[2] * middle[1] + matrix[4];
    const double y = matrix[1] * middle[0] + matrix[3] * middle[1] + matrix[5];
    bat_matrix_translation(x - middle[0], y - middle[1], matrix);
}

void bat_array_place(const bat_array *array, const double box[4], int i, double matrix[6]) {
    if (array->shape == BAT_ARRAY_CIRCLE) {
        place_on_circle(array, box, i, matrix);
        return;
    }
    const int row = array->shape == BAT_ARRAY_GRID ? i / array->count : 0;
    bat_matrix_translation((i - row * array->count) * step(array, box, 0),
                           row > 0 ? row * step(array, box, 1) : 0, matrix);
}
