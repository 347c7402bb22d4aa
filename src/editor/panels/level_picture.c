#include "editor/panels/level_picture.h"

#include "curve/curve.h"
#include <batten/levels.h>
#include <batten/relief.h>
#include <math.h>
#include <stdlib.h>

enum {
    COLUMNS = 18, /* of a wave: each has its least and its greatest value */
    SAMPLES = 65, /* of a curve */
    MARGIN = 2
};

static const double SEEN = 1e-4; /* of the size: smaller details are a flat line */

static void point(bat_text *text, double x, double y) {
    bat_text_string(text, text->size && text->data[text->size - 1] == 'M' ? "" : " ");
    bat_text_number(text, round(10 * x) / 10);
    bat_text_string(text, " ");
    bat_text_number(text, round(10 * y) / 10);
}

/* ---- waves ---- */

static double across(double x) { return MARGIN + x * (BAT_LEVEL_WIDE - 2 * MARGIN); }

/* Heights -1..1, upwards; where there are many, the least and the greatest of each column, in their order. */
static void polyline(bat_text *text, size_t count, const double *values, double scale, double middle,
                     double half) {
    const size_t columns = count < 2 * COLUMNS ? count : COLUMNS;
    bat_text_string(text, "M");
    if (count < 2 || scale == 0) {
        point(text, across(0), middle);
        point(text, across(1), middle);
        return;
    }
    for (size_t c = 0; c < columns; c++) {
        const size_t from = c * count / columns, to = (c + 1) * count / columns;
        size_t least = from, most = from;
        for (size_t i = from; i < to; i++) {
            if (values[i] < values[least]) least = i;
            if (values[i] > values[most]) most = i;
        }
        const size_t ends[2] = {least < most ? least : most, least < most ? most : least};
        for (int k = ends[0] == ends[1]; k < 2; k++)
            point(text, across((double)ends[k] / (double)(count - 1)),
                  middle - half * fmin(fmax(values[ends[k]] * scale, -1), 1));
    }
}

static double farthest(size_t count, const double *values) {
    double most = 0;
    for (size_t i = 0; i < count; i++) most = fmax(most, fabs(values[i]));
    return most;
}

void bat_level_wave(bat_text *text, size_t count, const double *values, double size, double gain) {
    const double most = farthest(count, values);
    polyline(text, count, values, most > SEEN * size ? 0.5 * gain / most : 0, BAT_LEVEL_HIGH / 2.0,
             BAT_LEVEL_HIGH / 2.0 - MARGIN);
}

void bat_level_hill(bat_text *text, size_t count, const double *values) {
    const double most = farthest(count, values);
    polyline(text, count, values, most > 0 ? 1 / most : 0, BAT_LEVEL_HIGH - MARGIN,
             BAT_LEVEL_HIGH - 2 * MARGIN);
}

/* ---- shapes ---- */

/* On the page; in space as seen from above one corner. */
static void project(int dimension, const double *p, double out[2]) {
    out[0] = dimension == 2 ? p[0] : 0.866 * (p[0] - p[1]);
    out[1] = dimension == 2 ? p[1] : 0.5 * (p[0] + p[1]) - p[2];
}

/* Lines of SAMPLES places each, as large as the box allows. */
static void lines(bat_text *text, int count, const double *places) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < 2 * SAMPLES * count; i++) {
        low[i % 2] = fmin(low[i % 2], places[i]);
        high[i % 2] = fmax(high[i % 2], places[i]);
    }
    const double scale = fmin((BAT_LEVEL_WIDE - 2 * MARGIN) / fmax(high[0] - low[0], 1e-300),
                              (BAT_LEVEL_HIGH - 2 * MARGIN) / fmax(high[1] - low[1], 1e-300));
    const double kept = scale < 1e300 ? scale : 0; /* all in one place */
    for (int i = 0; i < SAMPLES * count; i++) {
        if (i % SAMPLES == 0) bat_text_string(text, "M");
        point(text, BAT_LEVEL_WIDE / 2.0 + kept * (places[2 * i] - (low[0] + high[0]) / 2),
              BAT_LEVEL_HIGH / 2.0 + kept * (places[2 * i + 1] - (low[1] + high[1]) / 2));
    }
}

static double between(const double domain[2], int i) {
    return domain[0] + (domain[1] - domain[0]) * i / (SAMPLES - 1);
}

static void shape_of_curve(bat_text *text, const bat_curve *curve) {
    double places[2 * SAMPLES], domain[2], at[3];
    bat_curve_domain(curve, domain);
    for (int i = 0; i < SAMPLES; i++) {
        bat_curve_eval(curve, between(domain, i), 0, at);
        project(bat_curve_dimension(curve), at, places + 2 * i);
    }
    lines(text, 1, places);
}

/* The edges and the middle in both directions. */
static void shape_of_surface(bat_text *text, const bat_surface *surface) {
    enum { ACROSS = 3 };
    double places[2 * 2 * ACROSS * SAMPLES], *next = places, domain[2][2], at[3];
    for (int d = 0; d < 2; d++) bat_surface_domain(surface, d ? BAT_V : BAT_U, domain[d]);
    for (int d = 0; d < 2; d++)
        for (int k = 0; k < ACROSS; k++)
            for (int i = 0; i < SAMPLES; i++, next += 2) {
                const double along = between(domain[d], i),
                             fixed = between(domain[!d], k * (SAMPLES - 1) / (ACROSS - 1));
                bat_surface_eval(surface, d ? fixed : along, d ? along : fixed, 0, at);
                project(3, at, next);
            }
    lines(text, 2 * ACROSS, places);
}

/* ---- levels ---- */

/* To the side that the level uses more. */
static void wave_of_curve(bat_text *text, const bat_shape *shape, int level, double gain) {
    const size_t count = bat_curve_count(bat_shape_curve(shape, level));
    const double *details = bat_shape_details(shape, level);
    double sums[2] = {0, 0}, *values = malloc((count + !count) * sizeof *values);
    if (!values) {
        text->failed = true;
        return;
    }
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 2; k++) sums[k] += fabs(details[3 * i + 1 + (size_t)k]);
    for (size_t i = 0; i < count; i++) values[i] = details[3 * i + (sums[1] > sums[0] ? 2 : 1)];
    bat_level_wave(text, count, values, bat_curve_size(bat_shape_curve(shape, 0)), gain);
    free(values);
}

static void wave_of_surface(bat_text *text, const bat_relief *relief, int level, double gain) {
    const bat_surface *surface = bat_relief_surface(relief, level);
    const size_t rows = bat_surface_count(surface, BAT_U), along = bat_surface_count(surface, BAT_V);
    const double *details = bat_relief_details(relief, level);
    double *values = calloc(along + !along, sizeof *values);
    if (!values) {
        text->failed = true;
        return;
    }
    for (size_t i = 0; i < rows * along; i++)
        if (fabs(details[3 * i + 2]) > fabs(values[i % along])) values[i % along] = details[3 * i + 2];
    bat_level_wave(text, along, values, bat_surface_size(bat_relief_surface(relief, 0)), gain);
    free(values);
}

void bat_level_picture(bat_text *text, bat_ladder ladder, int level) {
    const double gain = level ? bat_ladder_gain(ladder, level) : 1;
    if (ladder.relief && level)
        wave_of_surface(text, ladder.relief, level, gain);
    else if (ladder.relief)
        shape_of_surface(text, bat_relief_surface(ladder.relief, 0));
    else if (level)
        wave_of_curve(text, ladder.shape, level, gain);
    else
        shape_of_curve(text, bat_shape_curve(ladder.shape, 0));
}
