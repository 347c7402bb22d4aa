/* Frames along a curve, as precise as numbers allow. */
#include "curve/frames_converged.h"

#include "base/vec.h"
#include "curve/curve.h"

#include <math.h>

static const double converged = 1e-9; /* radians */
enum { STEPS = 16, STEPS_MOST = 1024 };

/* How far two chains are apart at the knots and in the middles of spans, in radians. */
static double chains_apart(const bat_curve *path, const bat_frame_chain *a, const bat_frame_chain *b) {
    double worst = 0;
    for (int i = path->degree; i < path->spread; i++)
        for (int half = 1; half <= 2; half++) {
            const double u = path->knots[i] + (path->knots[i + 1] - path->knots[i]) * 0.5 * half;
            bat_frame3 x, y;
            bat_frame_chain_at(a, u, &x), bat_frame_chain_at(b, u, &y);
            worst = fmax(worst, vec_norm(vec_sub(vec_load(x.s, 3), vec_load(y.s, 3))));
        }
    return worst;
}

/* Rotation-minimising frames are of fourth order in the steps: the finer chain is 15 times as close as the two are. */
bat_status bat_frame_chain_converged(const bat_curve *path, bat_frame_options *options,
                                     bat_frame_chain **out) {
    bat_frame_chain *coarse = NULL, *fine = NULL;
    options->substeps = STEPS;
    bat_status status = bat_frame_chain_create(path, options, &coarse);
    while (status == BAT_OK && options->rule == BAT_FRAMES_RMF && options->substeps < STEPS_MOST) {
        options->substeps *= 2;
        status = bat_frame_chain_create(path, options, &fine);
        if (status != BAT_OK) break;
        const bool done = chains_apart(path, coarse, fine) <= 15 * converged;
        bat_frame_chain_free(coarse);
        coarse = fine, fine = NULL;
        if (done) break;
    }
    if (status == BAT_OK)
        *out = coarse;
    else
        bat_frame_chain_free(coarse);
    return status;
}
