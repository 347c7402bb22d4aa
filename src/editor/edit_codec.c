#include "editor/edit_codec.h"

static void number(bat_line *line, const char *name, double value) {
    bat_line_text(line, ",\"");
    bat_line_text(line, name);
    bat_line_text(line, "\":");
    bat_line_number(line, value);
}

/* All the same: one number stands for all. */
static size_t distinct(const double *numbers, size_t count) {
    for (size_t i = 1; i < count; i++)
        if (numbers[i] != numbers[0]) return count;
    return count ? 1 : 0;
}

static void pairs(bat_line *line, const double *numbers, size_t count) {
    bat_line_text(line, "[");
    for (size_t i = 0; i < count; i++) {
        if (i) bat_line_text(line, ",");
        bat_line_numbers(line, numbers + 2 * i, 2, 1);
    }
    bat_line_text(line, "]");
}

static void stroke(bat_line *line, const bat_samples *samples) {
    size_t n = samples->count;
    bat_line_text(line, ",\"stroke\":{\"points\":");
    pairs(line, samples->pixels, n);
    bat_line_text(line, ",\"pressure\":");
    bat_line_numbers(line, samples->pressure, distinct(samples->pressure, n), 1);
    bat_line_text(line, ",\"time\":");
    bat_line_numbers(line, samples->time, n, 1);
    bool tilted = false;
    for (size_t i = 0; i < 2 * n; i++) tilted = tilted || samples->tilt[i] != 0;
    if (tilted) {
        bat_line_text(line, ",\"tilt\":");
        pairs(line, samples->tilt, n);
    }
    bat_line_text(line, "}");
}

void bat_edit_write(const bat_edit *edit, bat_line *line) {
    bat_line_text(line, "{\"do\":\"");
    bat_line_text(line, bat_edit_name(edit->kind));
    bat_line_text(line, "\"");
    number(line, "object", (double)edit->object);
    if (edit->kind != BAT_EDIT_NEW) number(line, "curve", edit->curve);
    if (edit->kind == BAT_EDIT_JOIN) {
        number(line, "other", (double)edit->other);
        number(line, "other_curve", edit->other_curve);
    }
    if (edit->kind == BAT_EDIT_NEW) {
        number(line, "stroke_colour", edit->style.stroke);
        number(line, "stroke_width", edit->style.width);
    }
    number(line, "tolerance", edit->options.tolerance);
    number(line, "pixel", edit->options.pixel);
    number(line, "pins", edit->options.pins);
    number(line, "width", edit->options.width);
    bat_line_text(line, edit->options.keep_corners ? ",\"keep_corners\":true" : ",\"keep_corners\":false");
    number(line, "smooth_limit", edit->options.smooth_limit);
    if (edit->accepted) bat_line_text(line, ",\"accepted\":true");
    bat_line_text(line, ",\"view\":");
    bat_line_numbers(line, edit->view, 3, 1);
    stroke(line, &edit->samples);
}
