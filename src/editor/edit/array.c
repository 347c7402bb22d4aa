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

/* Of a row, from one copy to the next: as far as a box reaches in its direction, and the gap. Level and upright rows are exact. */
static void step_along(const bat_array *array, const double box[4], double way[2]) {
    const double angle = array->direction * BAT_PI / 180, half = fabs(fmod(array->direction, TURN / 2));
    way[0] = half == TURN / 4 ? 0 : bat_cos(angle);
    way[1] = half == 0 ? 0 : bat_sin(angle);
    const double far = fabs(way[0]) * (box[2] - box[0]) + fabs(way[1]) * (box[3] - box[1]) + array->gap[0];
    for (int k = 0; k < 2; k++) way[k] *= far;
}

bool bat_array_is_heap(const bat_array *array, const double box[4]) {
    if (array->shape == BAT_ARRAY_CIRCLE)
        return step_angle(array) == 0 || (array->radius == 0 && !array->turns);
    if (array->shape == BAT_ARRAY_ROW) {
        double way[2];
        step_along(array, box, way);
        return array->count > 1 && way[0] == 0 && way[1] == 0;
    }
    if (array->count > 1 && step(array, box, 0) == 0) return true;
    return array->rows > 1 && step(array, box, 1) == 0;
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
    double way[2];
    if (array->shape == BAT_ARRAY_GRID) {
        const int row = i / array->count;
        bat_matrix_translation((i - row * array->count) * step(array, box, 0), row * step(array, box, 1),
                               matrix);
        return;
    }
    step_along(array, box, way);
    bat_matrix_translation(i * way[0], i * way[1], matrix);
}
