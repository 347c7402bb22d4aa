#include "editor/tools/sketch/hold.h"
#include "base/real.h"
#include <math.h>

static const double STILL = 3, STILL_TOUCH = 6; /* px that a resting hand may wander */
/* Share of the tolerance: the figure has to look like one, and costs few points all the same. */
static const double CLOSER = 0.2;

void bat_hold_begin(bat_sketch_hold *hold, const bat_pointer *event) {
    *hold = (bat_sketch_hold){.at = {event->x, event->y}, .since = event->time};
    hold->spent = true; /* a press that rests where it came down is no stroke yet */
}

bool bat_hold_rests(bat_sketch_hold *hold, const bat_pointer *event, const bat_samples *samples,
                    double seconds) {
    const double still = event->device == BAT_DEVICE_TOUCH ? STILL_TOUCH : STILL;
    if (bat_hypot(event->x - hold->at[0], event->y - hold->at[1]) > still) {
        hold->at[0] = event->x, hold->at[1] = event->y;
        hold->since = event->time;
        hold->count = samples->count;
        hold->spent = false;
        hold->figure.kind = BAT_FIGURE_NONE;
    }
    if (hold->spent || seconds <= 0 || event->time - hold->since < 1000 * seconds) return false;
    hold->spent = true;
    if (hold->count >= 2) bat_figure_nearest(hold->count, samples->pixels, &hold->figure);
    return hold->figure.kind != BAT_FIGURE_NONE;
}

/* The samples lie evenly in time; their pressure is the stroke's in the middle. */
bat_status bat_hold_edit(const bat_sketch_hold *hold, const bat_edit *drawn, bat_samples *samples,
                         bat_edit *out) {
    static const double upright[2] = {0, 0};
    const bat_samples *from = &drawn->samples;
    const size_t count = hold->figure.count;
    bat_status status = BAT_OK;
    bat_samples_clear(samples);
    samples->start = from->start;
    if (hold->figure.kind == BAT_FIGURE_NONE || !from->count) return BAT_STATE;
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        double pixel[2];
        for (size_t k = 0; k < 2; k++)
            pixel[k] = fmin(fmax(bat_samples_round(hold->figure.points[2 * i + k], 100), -BAT_PIXELS_MAX),
                            BAT_PIXELS_MAX);
        const double time = bat_samples_round(from->time[from->count - 1] * (double)i / (double)(count - 1),
                                              100);
        status = bat_samples_add(samples, &drawn->stage, pixel, from->pressure[from->count / 2], time,
                                 upright);
        if (samples->count && (status == BAT_SINGULAR || status == BAT_FAR || status == BAT_NUMBER))
            status = BAT_OK; /* beside the ground */
    }
    if (status != BAT_OK) return status;
    *out = *drawn;
    out->options.tolerance *= CLOSER;
    out->samples = *samples;
    const bool closed = hold->figure.kind == BAT_FIGURE_CIRCLE || hold->figure.kind == BAT_FIGURE_ELLIPSE;
    if (out->kind == BAT_EDIT_NEW) out->meaning.closing = closed ? BAT_CLOSING_YES : BAT_CLOSING_NO;
    return BAT_OK;
}

bat_string bat_hold_word(bat_figure_kind kind) {
    static const bat_string words[BAT_FIGURE_COUNT] = {
        [BAT_FIGURE_NONE] = BAT_STRING_COUNT,
        [BAT_FIGURE_LINE] = BAT_STRING_FIGURE_LINE,
        [BAT_FIGURE_ARC] = BAT_STRING_FIGURE_ARC,
        [BAT_FIGURE_CIRCLE] = BAT_STRING_FIGURE_CIRCLE,
        [BAT_FIGURE_ELLIPSE] = BAT_STRING_FIGURE_ELLIPSE,
        [BAT_FIGURE_ELLIPSE_ARC] = BAT_STRING_FIGURE_ELLIPSE_ARC,
        [BAT_FIGURE_CLOTHOID] = BAT_STRING_FIGURE_CLOTHOID};
    return words[kind];
}
