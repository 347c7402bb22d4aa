#include "editor/tools/sketch/hold.h"
#include "base/real.h"
#include <math.h>
#include <string.h>

static const double STILL = 3, STILL_TOUCH = 6; /* px that a resting hand may wander */
static const double LOOSE = 4, TIGHT = 12; /* px a held pen may slip; px from which the figure is with it */
/* Share of the tolerance: the figure has to look like one, and costs few points all the same. */
static const double CLOSER = 0.2;

void bat_hold_begin(bat_sketch_hold *hold, const bat_pointer *event) {
    bat_hold_end(hold);
    hold->at[0] = event->x, hold->at[1] = event->y;
    hold->since = event->time;
    hold->spent = true; /* a press that rests where it came down is no stroke yet */
}

bool bat_hold_due(bat_sketch_hold *hold, const bat_pointer *event, size_t count, double seconds) {
    const double still = event->device == BAT_DEVICE_TOUCH ? STILL_TOUCH : STILL;
    if (bat_hypot(event->x - hold->at[0], event->y - hold->at[1]) > still) {
        hold->at[0] = event->x, hold->at[1] = event->y;
        hold->since = event->time;
        hold->count = count;
        hold->spent = false;
    }
    if (hold->spent || seconds <= 0 || event->time - hold->since < 1000 * seconds) return false;
    hold->spent = true;
    return true;
}

/* Places along the figure as a stroke: evenly in time, its pressure the stroke's in the middle. */
static bat_status lay(const bat_sketch_hold *hold, bat_edit *edit, const double *points) {
    static const double upright[2] = {0, 0};
    const bat_samples *drawn = &hold->drawn.samples;
    const double last = drawn->time[drawn->count - 1], pressure = drawn->pressure[drawn->count / 2];
    const size_t count = hold->figure.count;
    bat_status status = BAT_OK;
    bat_samples_clear(&edit->samples);
    edit->samples.start = drawn->start;
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        double pixel[2];
        for (size_t k = 0; k < 2; k++)
            pixel[k] = fmin(fmax(bat_samples_round(points[2 * i + k], 100), -BAT_PIXELS_MAX), BAT_PIXELS_MAX);
        const double time = bat_samples_round(last * (double)i / (double)(count - 1), 100);
        status = bat_samples_add(&edit->samples, &edit->stage, pixel, pressure, time, upright);
        if (edit->samples.count && (status == BAT_SINGULAR || status == BAT_FAR || status == BAT_NUMBER))
            status = BAT_OK; /* beside the ground */
    }
    return status;
}

bat_status bat_hold_take(bat_sketch_hold *hold, bat_edit *edit) {
    if (hold->count < 2) return BAT_STATE;
    bat_figure_nearest(hold->count, edit->samples.pixels, &hold->figure);
    if (hold->figure.kind == BAT_FIGURE_NONE) return BAT_STATE;
    bat_samples spare = hold->drawn.samples;
    hold->drawn = *edit;
    edit->samples = spare;
    edit->options.tolerance *= CLOSER;
    memcpy(hold->grip, hold->at, sizeof hold->grip);
    hold->on = true;
    return lay(hold, edit, hold->figure.points);
}

bat_status bat_hold_drag(bat_sketch_hold *hold, bat_edit *edit, const double to[2]) {
    double points[2 * BAT_FIGURE_POINTS], at[2];
    const double x = to[0] - hold->grip[0], y = to[1] - hold->grip[1], far = bat_hypot(x, y);
    const double share = fmin(fmax((far - LOOSE) / (TIGHT - LOOSE), 0) * TIGHT / fmax(far, LOOSE), 1);
    const double *end = hold->figure.points + 2 * (hold->figure.count - 1);
    at[0] = end[0] + share * x, at[1] = end[1] + share * y;
    bat_figure_drag(&hold->figure, end, at, points);
    return lay(hold, edit, points);
}

void bat_hold_end(bat_sketch_hold *hold) {
    bat_samples_clear(&hold->drawn.samples);
    hold->on = false;
    hold->count = 0;
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
