/* A stroke without a pen. */
#include "editor/input/samples.h"
#include "editor/input/stabiliser.h"
#include "editor/tools/sketch/parts.h"
#include "editor/view/stage.h"

bat_status bat_sketching_trace(bat_context *c, void *state, const bat_traced *stroke) {
    bat_sketching *s = state;
    for (size_t i = 0; i < stroke->count; i++) {
        double at[2];
        bat_stage_project(c->stage, stroke->points + 2 * i, at);
        bat_pointer event = {.x = bat_samples_round(at[0], 100),
                             .y = bat_samples_round(at[1], 100),
                             .pressure = 0.5,
                             .time = c->time + 4 * (double)i};
        if (i) {
            bat_sketching_move(c, s, &event);
            continue;
        }
        if (stroke->object)
            bat_sketching_begin(c, s, &event, (bat_pick){.object = stroke->object, .curve = stroke->curve},
                                true);
        else
            bat_sketching_down(c, s, &event);
        s->steady = bat_steady_begin(0, (double[]){event.x, event.y}); /* no trembling hand to steady */
    }
    return BAT_OK;
}

bat_status bat_sketching_lift(bat_context *c, void *state, const bat_traced *stroke) {
    bat_sketching *s = state;
    const bat_samples *samples = &s->edit.samples;
    (void)stroke;
    if (s->state != BAT_SKETCHING_DRAWING) return BAT_OK;
    const double *last = samples->pixels + 2 * (samples->count - 1);
    bat_sketching_up(c, s, &(bat_pointer){.x = last[0], .y = last[1]});
    return BAT_OK;
}
