/* Frames along a curve, as precise as numbers allow. */
#include "curve/frames/converged.h"

#include "curve/curve.h"
#include "curve/frames/frames.h"

static const double converged = 1e-9; /* radians */
enum { STEPS = 16, STEPS_LEAST = 2, STEPS_MOST = 1024, FRAMES = 4096 };

/* Rotation-minimising frames are of fourth order in the steps: the finer chain is 15 times as close as the two are. */
bat_status bat_frame_chain_converged(const bat_curve *path, bat_frame_options *options,
                                     bat_frame_chain **out) {
    const bool converges = options->rule == BAT_FRAMES_RMF;
    bat_frame_chain *chain = NULL;
    options->substeps = STEPS; /* fewer where there are many spans, which turn little each */
    while (options->substeps > STEPS_LEAST && options->substeps * path->spread > FRAMES)
        options->substeps /= 2;
    for (;;) {
        double apart = 0;
        if (converges) options->substeps *= 2;
        bat_status status = bat_frame_chain_create(path, options, &chain);
        if (status == BAT_OK && converges) status = bat_frame_chain_error(chain, &apart);
        if (status == BAT_OK && apart > 15 * converged && options->substeps < STEPS_MOST) {
            bat_frame_chain_free(chain);
            chain = NULL;
            continue;
        }
        if (status == BAT_OK)
            *out = chain;
        else
            bat_frame_chain_free(chain);
        return status;
    }
}
