/* Frames along a curve, as precise as numbers allow. */
#include "curve/frames_converged.h"

#include "base/vec.h"
#include "curve/curve.h"

#include <math.h>

static const double converged = 1e-9; /* radians */
enum { STEPS = 16, STEPS_LEAST = 2, STEPS_MOST = 1024, FRAMES = 4096, PLACES = 256 };

/* How far two chains are apart at the knots and in the middles of spans, in radians; of many spans at some, since what a chain is
 * off by at one place it stays off by. */
static double chains_apart(const bat_curve *path, const bat_frame_chain *a, const bat_frame_chain *b) {
    double worst = 0;
    const int stride = 1 + (path->spread - path->degree) / PLACES;
    for (int i = path->spread - 1; i >= path->degree; i -= stride)
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
    options->substeps = STEPS; /* fewer where there are many spans, which turn little each */
    while (options->substeps > STEPS_LEAST && options->substeps * path->spread > FRAMES)
        options->substeps /= 2;
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
