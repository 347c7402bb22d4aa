#include "editor/edit/repeat.h"
#include "editor/choice/choice.h"
#include "editor/choice/repetition.h"
#include "editor/edit/arrange.h"
#include <string.h>

static void middle(const double box[4], double out[2]) {
    for (int k = 0; k < 2; k++) out[k] = box[k] / 2 + box[k + 2] / 2;
}

/* The map of one box as a map of another one: moves go as far; what turns, scales or mirrors does so about the same share of the box. */
static void map_elsewhere(const double matrix[6], const double box[4], const double other[4], double out[6]) {
    const bool moves = matrix[0] == 1 && matrix[1] == 0 && matrix[2] == 0 && matrix[3] == 1;
    double from[2], to[2];
    memcpy(out, matrix, 6 * sizeof *out);
    if (moves) return;
    middle(box, from);
    middle(other, to);
    for (int k = 0; k < 2; k++) {
        const double size = box[k + 2] - box[k], wide = other[k + 2] - other[k];
        const double by = matrix[k] * from[0] + matrix[k + 2] * from[1] + matrix[k + 4] - from[k];
        const double far = size > 0 ? by / size * wide : by;
        out[k + 4] = to[k] + far - (matrix[k] * to[0] + matrix[k + 2] * to[1]);
    }
}

bat_status bat_repeat(bat_context *c) {
    const bat_repetition *r = &c->choice->repetition;
    double matrix[6], box[4];
    if (!r->count || !bat_arrange_selection_box(c, box)) return BAT_STATE;
    if (bat_repetition_is_of_selection(c))
        memcpy(matrix, bat_repetition_matrix(c), sizeof matrix);
    else
        map_elsewhere(bat_repetition_matrix(c), r->box, box, matrix);
    return r->copies ? bat_arrange_duplicate(c, matrix) : bat_arrange_transform(c, matrix, r->label);
}
