#include "editor/input/samples.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 8 /* other than places */ };

void bat_samples_clear(bat_samples *samples) { samples->count = 0; }

void bat_samples_free(bat_samples *samples) {
    free(samples->pixels); /* the block of all columns starts here */
    *samples = (bat_samples){0};
}

static void lay_out(bat_samples *samples, double *block, size_t room) {
    samples->pixels = block;
    samples->points = block + 2 * room;
    samples->tilt = block + 4 * room;
    samples->pressure = block + 6 * room;
    samples->time = block + 7 * room;
    samples->places = samples->apart ? block + COLUMNS * room : samples->points;
    samples->room = room;
}

size_t bat_samples_size(size_t count) { return count * (COLUMNS + BAT_DIMENSION_MAX) * sizeof(double); }

/* Its columns in a block of their own, which has this much room. */
static bat_status move_to(bat_samples *samples, size_t room) {
    size_t n = samples->count;
    size_t size = (size_t)samples->dimension, columns = samples->apart ? COLUMNS + size : COLUMNS;
    double *block = malloc(room * columns * sizeof *block);
    if (!block) return BAT_MEMORY;
    bat_samples old = *samples;
    lay_out(samples, block, room);
    if (n) {
        memcpy(samples->pixels, old.pixels, 2 * n * sizeof *block);
        memcpy(samples->points, old.points, 2 * n * sizeof *block);
        memcpy(samples->tilt, old.tilt, 2 * n * sizeof *block);
        memcpy(samples->pressure, old.pressure, n * sizeof *block);
        memcpy(samples->time, old.time, n * sizeof *block);
        if (samples->apart) memcpy(samples->places, old.places, size * n * sizeof *block);
    }
    return BAT_OK;
}

static bat_status grow(bat_samples *samples) {
    double *old = samples->pixels;
    bat_status status = move_to(samples, samples->room ? 2 * samples->room : 256);
    if (status == BAT_OK) free(old);
    return status;
}

bat_status bat_samples_copy(const bat_samples *samples, bat_samples *out) {
    bat_samples copy = *samples;
    bat_status status = move_to(&copy, samples->count + 1);
    if (status == BAT_OK) *out = copy;
    return status;
}

double bat_samples_round(double value, double parts) { return round(value * parts) / parts; }

bat_status bat_samples_add(bat_samples *samples, const bat_stage *stage, const double pixel[2],
                           double pressure, double time, const double tilt[2]) {
    bat_hit hit;
    if (samples->count == BAT_SAMPLES_MAX) return BAT_COUNT;
    bat_status status = bat_stage_place(stage, pixel, samples->count ? &samples->last : NULL, &hit);
    if (status != BAT_OK) return status;
    const int dimension = bat_stage_dimension(stage);
    const bool apart = dimension == 3 || bat_stage_tilted(stage);
    if (!samples->count && (samples->dimension != dimension || samples->apart != apart)) {
        samples->dimension = dimension;
        samples->apart = apart;
        samples->room = 0; /* the block has other columns */
    }
    if (samples->count == samples->room && grow(samples) != BAT_OK) return BAT_MEMORY;
    samples->last = hit;
    size_t i = samples->count++;
    for (int k = 0; k < 2; k++) {
        samples->pixels[2 * i + (size_t)k] = pixel[k];
        samples->tilt[2 * i + (size_t)k] = tilt[k];
    }
    bat_stage_look(stage, dimension, hit.at, samples->points + 2 * i);
    const size_t size = (size_t)dimension;
    if (apart) memcpy(samples->places + size * i, hit.at, size * sizeof *hit.at);
    samples->pressure[i] = pressure;
    samples->time[i] = time;
    return BAT_OK;
}

bat_stroke bat_samples_stroke(const bat_samples *samples, size_t first) {
    return (bat_stroke){.dimension = samples->dimension == 3 ? 3 : 2,
                        .count = samples->count - first,
                        .points = samples->places + (size_t)(samples->dimension == 3 ? 3 : 2) * first,
                        .pressure = samples->pressure + first,
                        .time = samples->time + first};
}
