/* The round mode: directions, and from them the handles of every segment. */
#include "hands/tangents/round.h"
#include "hands/tangents/directions.h"
#include "hands/tangents/handle.h"
#include "hands/tangents/spline.h"

#include <stdlib.h>

static vec point_at(const bat_spline *s, int i) {
    return vec_load(s->points + (size_t)i * (size_t)s->dimension, s->dimension);
}

/* The derivatives before and after a point. */
static void fill_joint(const bat_round_row *row, int i, bat_joint *joint) {
    const int n = row->count, last = i > 0 ? i - 1 : n - 1;
    const vec t = row->directions[i];
    const bool has_in = row->closed || i > 0, has_out = row->closed || i < n - 1;
    const vec in = has_in ? row->chords[last] : (vec){0, 0, 0},
              out = has_out ? row->chords[i] : (vec){0, 0, 0};
    if (has_in) {
        const double handle = bat_round_handle(t, row->directions[last], in);
        vec_store(vec_scale(t, 3 * row->lengths[last] * handle), joint->left);
    }
    if (has_out) {
        const double handle = bat_round_handle(t, row->directions[(i + 1) % n], out);
        vec_store(vec_scale(t, 3 * row->lengths[i] * handle), joint->right);
    }
}

bat_status bat_round(const bat_spline *spline, const int *keep, int count, bat_joint *joints) {
    const size_t n = (size_t)count;
    vec *chords = malloc(2 * n * sizeof *chords);
    double *lengths = malloc(n * sizeof *lengths);
    bool *given = malloc(n * sizeof *given);
    bat_status status = chords && lengths && given ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        const bat_round_row row = {count, spline->dimension, spline->closed, chords, lengths,
                                   given, chords + n};
        for (int i = 0; i < count; i++) {
            const vec chord = vec_sub(point_at(spline, keep[(i + 1) % count]), point_at(spline, keep[i]));
            chords[i] = vec_unit(chord);
            lengths[i] = vec_norm(chord);
            given[i] = bat_spline_direction(spline, keep[i], &row.directions[i]);
        }
        status = bat_round_directions(&row);
        for (int i = 0; status == BAT_OK && i < count; i++) fill_joint(&row, i, &joints[keep[i]]);
    }
    free(chords);
    free(lengths);
    free(given);
    return status;
}
