#include "editor/edit/stroke_record.h"
#include "editor/edit/mirror_record.h"
#include "editor/edit/view_record.h"
#include "editor/session/journal_line.h"
#include "editor/view/stage.h"
#include <batten/levels.h>
#include <math.h>
#include <string.h>
#include <stdio.h>

/* One row per kind: its name in the journal, and the string that names its undo step. */
static const struct {
    const char *name;
    bat_string label;
} KINDS[BAT_EDIT_COUNT] = {
    [BAT_EDIT_NEW] = {"sketch-new", BAT_STRING_STEP_NEW},
    [BAT_EDIT_REDRAW] = {"sketch-redraw", BAT_STRING_STEP_REDRAW},
    [BAT_EDIT_SMOOTH] = {"sketch-smooth", BAT_STRING_STEP_SMOOTH},
    [BAT_EDIT_JOIN] = {"sketch-join", BAT_STRING_STEP_JOIN},
    [BAT_EDIT_EXTEND] = {"sketch-extend", BAT_STRING_STEP_EXTEND},
    [BAT_EDIT_CLOSE] = {"sketch-close", BAT_STRING_STEP_CLOSE},
    [BAT_EDIT_SEVERAL] = {"sketch-several", BAT_STRING_STEP_SEVERAL},
    [BAT_EDIT_BLEND] = {"sketch-blend", BAT_STRING_COMMAND_CURVE_BLEND},
    [BAT_EDIT_LEVEL] = {"sketch-level", BAT_STRING_STEP_LEVEL_SKETCH},
};

const char *bat_edit_name(bat_edit_kind kind) { return KINDS[kind].name; }
bat_string bat_edit_label(bat_edit_kind kind) { return KINDS[kind].label; }

bat_edit_kind bat_edit_named(const char *name) {
    int i = 0;
    while (i < BAT_EDIT_COUNT && strcmp(KINDS[i].name, name)) i++;
    return (bat_edit_kind)i;
}

static void number(bat_text *line, const char *name, double value) {
    bat_text_string(line, ",\"");
    bat_text_string(line, name);
    bat_text_string(line, "\":");
    bat_line_number(line, value);
}

/* When all are the same, one number stands for all. */
static size_t distinct(const double *numbers, size_t count) {
    for (size_t i = 1; i < count; i++)
        if (numbers[i] != numbers[0]) return count;
    return count ? 1 : 0;
}

static void pairs(bat_text *line, const double *numbers, size_t count) {
    bat_text_string(line, "[");
    for (size_t i = 0; i < count; i++) {
        if (i) bat_text_string(line, ",");
        bat_line_numbers(line, numbers + 2 * i, 2, 1);
    }
    bat_text_string(line, "]");
}

static void stroke(bat_text *line, const bat_samples *samples) {
    size_t n = samples->count;
    bat_text_string(line, ",\"stroke\":{\"points\":");
    pairs(line, samples->pixels, n);
    bat_text_string(line, ",\"pressure\":");
    bat_line_numbers(line, samples->pressure, distinct(samples->pressure, n), 1);
    bat_text_string(line, ",\"time\":");
    bat_line_numbers(line, samples->time, n, 1);
    bool tilted = false;
    for (size_t i = 0; i < 2 * n; i++) tilted = tilted || samples->tilt[i] != 0;
    if (tilted) {
        bat_text_string(line, ",\"tilt\":");
        pairs(line, samples->tilt, n);
    }
    bat_text_string(line, "}");
}

/* Writes only what differs from the default. */
static void write_style(bat_text *line, const bat_style *style) {
    bat_style usual = bat_style_defaults();
    if (style->stroked != usual.stroked) number(line, "stroked", style->stroked);
    if (style->filled != usual.filled) number(line, "filled", style->filled);
    if (style->fill != usual.fill) number(line, "fill_colour", style->fill);
    if (style->opacity != usual.opacity) number(line, "opacity", style->opacity);
    if (style->cap != usual.cap) number(line, "cap", (double)style->cap);
    if (style->join != usual.join) number(line, "join", (double)style->join);
}

static bool has_other(bat_edit_kind kind) { return kind == BAT_EDIT_JOIN || kind == BAT_EDIT_BLEND; }

static bool is_redraw(bat_edit_kind kind) { return kind == BAT_EDIT_REDRAW || kind == BAT_EDIT_EXTEND; }

/* What the choice of meaning has determined for a redraw. */
static void write_redraw(bat_text *line, const bat_sketch_meaning *meaning) {
    if (meaning->sense) number(line, "sense", meaning->sense);
    if (!meaning->end[0] && !meaning->end[1]) return;
    bat_text_string(line, ",\"ends\":");
    bat_line_numbers(line, (double[]){(double)meaning->end[0], (double)meaning->end[1]}, 2, 1);
}

static void write_new(bat_text *line, const bat_sketch_meaning *meaning, int dimension) {
    if (meaning->closing)
        bat_text_string(line, meaning->closing == BAT_CLOSING_YES ? ",\"closed\":true" : ",\"closed\":false");
    if (meaning->mark) bat_text_string(line, ",\"mark\":true");
    for (int side = 0; side < 2; side++) {
        if (!meaning->put[side]) continue;
        bat_text_string(line, side ? ",\"finish\":" : ",\"start\":");
        bat_line_numbers(line, meaning->tip[side], (size_t)dimension, 1);
    }
}

static void write_parts(bat_text *line, const bat_edit *edit) {
    bat_text_string(line, ",\"parts\":[");
    for (int i = 0; i < edit->part_count; i++) {
        const bat_edit_part *part = &edit->part[i];
        bat_text_string(line, i ? ",{\"object\":" : "{\"object\":");
        bat_line_number(line, (double)part->object);
        number(line, "curve", part->curve);
        write_redraw(line, &part->meaning);
        bat_text_string(line, ",\"end\":");
        bat_line_numbers(line, part->end, (size_t)bat_stage_dimension(&edit->stage), 1);
        bat_text_string(line, "}");
    }
    bat_text_string(line, "]");
}

/* The page is the default and not written. */
static void write_ground(bat_text *line, const bat_ground *ground) {
    if (!ground->type->numbers) return;
    bat_text_string(line, ",\"ground\":{\"");
    bat_text_string(line, ground->type->name);
    bat_text_string(line, "\":");
    bat_line_numbers(line, ground->numbers, (size_t)ground->type->numbers, 1);
    bat_text_string(line, "}");
}

void bat_edit_write(const bat_edit *edit, bat_text *line) {
    bat_text_string(line, "{\"do\":\"");
    bat_text_string(line, bat_edit_name(edit->kind));
    bat_text_string(line, "\"");
    number(line, "object", (double)edit->object);
    if (edit->kind != BAT_EDIT_NEW) number(line, "curve", edit->curve);
    if (edit->kind == BAT_EDIT_LEVEL) number(line, "level", edit->level);
    if (is_redraw(edit->kind)) write_redraw(line, &edit->meaning);
    if (edit->kind == BAT_EDIT_SEVERAL) write_parts(line, edit);
    if (has_other(edit->kind)) {
        number(line, "other", (double)edit->other);
        number(line, "other_curve", edit->other_curve);
    }
    if (edit->kind == BAT_EDIT_NEW) {
        number(line, "stroke_colour", edit->style.stroke);
        number(line, "stroke_width", edit->style.width);
        write_style(line, &edit->style);
        if (edit->parent) number(line, "parent", (double)edit->parent);
        if (edit->dashes) number(line, "dashes", edit->dashes);
        if (edit->pressed) bat_text_string(line, ",\"pressed\":true");
        write_new(line, &edit->meaning, bat_stage_dimension(&edit->stage));
    }
    number(line, "tolerance", edit->options.tolerance);
    number(line, "pixel", edit->options.pixel);
    number(line, "pins", edit->options.pins);
    number(line, "width", edit->options.width);
    bat_text_string(line, edit->options.keep_corners ? ",\"keep_corners\":true" : ",\"keep_corners\":false");
    number(line, "smooth_limit", edit->options.smooth_limit);
    if (edit->options.fairness != bat_sketch_defaults().fairness)
        number(line, "fairness", edit->options.fairness);
    if (edit->options.degree != 3) number(line, "degree", edit->options.degree);
    if (edit->on_extremes) bat_text_string(line, ",\"on_extremes\":true");
    if (edit->accepted) bat_text_string(line, ",\"accepted\":true");
    bat_mirror_write(&edit->mirror, line);
    bat_text_string(line, ",\"view\":");
    bat_view_write(&edit->stage.view, line, false);
    write_ground(line, &edit->stage.ground);
    stroke(line, &edit->samples);
}

/* ---- reading ---- */

bat_status bat_edit_number(const bat_json *json, uint32_t object, const char *name, double low, double high,
                           const double *otherwise, double *out, bat_problem *problem) {
    char expected[80];
    uint32_t node = bat_json_member(json, object, name);
    if (!node && otherwise) {
        *out = *otherwise;
        return BAT_OK;
    }
    if (bat_json_type_of(json, node) == BAT_JSON_NUMBER) {
        double value = json->nodes[node].value.number;
        if (value >= low && value <= high) {
            *out = value;
            return BAT_OK;
        }
    }
    snprintf(expected, sizeof expected, "a number from %g to %g", low, high);
    return bat_json_complain(json, node ? node : object, BAT_ARGUMENT, name, expected, problem);
}

/* A reader that stops at the first error. */
typedef struct reader {
    const bat_json *json;
    uint32_t object;
    bat_problem *problem;
    bat_status status;
} reader;

static double read(reader *r, const char *name, double low, double high, const double *otherwise) {
    double value = 0;
    if (r->status == BAT_OK)
        r->status = bat_edit_number(r->json, r->object, name, low, high, otherwise, &value, r->problem);
    return value;
}

static int read_whole(reader *r, const char *name, double low, double high) {
    double value = read(r, name, low, high, NULL);
    if (r->status == BAT_OK && value != floor(value))
        r->status = bat_json_complain(r->json, bat_json_member(r->json, r->object, name), BAT_ARGUMENT, name,
                                      "a whole number", r->problem);
    return (int)value;
}

static void read_style(reader *r, bat_style *style) {
    const double stroked = style->stroked, filled = style->filled, fill = style->fill,
                 cap = (double)style->cap, join = (double)style->join;
    style->stroked = read(r, "stroked", 0, 1, &stroked) != 0;
    style->filled = read(r, "filled", 0, 1, &filled) != 0;
    style->fill = (uint32_t)read(r, "fill_colour", 0, 4294967295.0, &fill);
    style->opacity = read(r, "opacity", 0, 1, &style->opacity);
    style->cap = (bat_cap)(int)read(r, "cap", 0, 2, &cap);
    style->join = (bat_join)(int)read(r, "join", 0, 2, &join);
}

static bool read_switch(reader *r, const char *name) {
    return bat_json_type_of(r->json, bat_json_member(r->json, r->object, name)) == BAT_JSON_TRUE;
}

static double item_number(const bat_json *json, uint32_t node) {
    return bat_json_type_of(json, node) == BAT_JSON_NUMBER ? json->nodes[node].value.number : NAN;
}

static bool item_numbers(const bat_json *json, uint32_t node, uint32_t count, double limit, double *out) {
    if (bat_json_count(json, node) != count) return false;
    bool good = true;
    node = bat_json_first(json, node);
    for (uint32_t i = 0; i < count && good; i++, node = json->nodes[node].next) {
        out[i] = item_number(json, node);
        good = fabs(out[i]) <= limit;
    }
    return good;
}

/* One number per sample, one for all, or none at all. */
static bool column_fits(const bat_json *json, uint32_t list, uint32_t count) {
    uint32_t found = bat_json_count(json, list);
    return !list || found == count || (bat_json_type_of(json, list) == BAT_JSON_LIST && found == 1);
}

static uint32_t following(const bat_json *json, uint32_t node, uint32_t all) {
    return node && all > 1 ? json->nodes[node].next : node;
}

static bat_status read_stroke(const bat_json *json, uint32_t stroke, bat_edit *edit, bat_problem *problem) {
    uint32_t points = bat_json_member(json, stroke, "points"),
             pressure = bat_json_member(json, stroke, "pressure");
    uint32_t time = bat_json_member(json, stroke, "time"), tilt = bat_json_member(json, stroke, "tilt");
    uint32_t count = bat_json_count(json, points);
    if (count < 1 || count > BAT_SAMPLES_MAX)
        return bat_json_complain(json,
                                 points   ? points
                                 : stroke ? stroke
                                          : 1,
                                 BAT_COUNT, "stroke points", "a list of one point or more", problem);
    if (!column_fits(json, pressure, count) || !column_fits(json, time, count) ||
        !column_fits(json, tilt, count))
        return bat_json_complain(json, stroke, BAT_COUNT, "stroke", "lists as long as its points", problem);
    uint32_t at = bat_json_first(json, points), p = bat_json_first(json, pressure),
             t = bat_json_first(json, time);
    uint32_t slant = bat_json_first(json, tilt);
    double last = 0;
    for (uint32_t i = 0; i < count; i++) {
        double pixel[2], lean[2] = {0, 0};
        if (!item_numbers(json, at, 2, BAT_PIXELS_MAX, pixel))
            return bat_json_complain(json, at, BAT_SYNTAX, "stroke point", "[x, y]", problem);
        double press = p ? item_number(json, p) : 0, when = t ? item_number(json, t) : 0;
        if (!(press >= 0 && press <= 1))
            return bat_json_complain(json, p, BAT_SYNTAX, "pressure", "a number from 0 to 1", problem);
        if (!(when >= last && when <= 1e13))
            return bat_json_complain(json, t, BAT_SYNTAX, "time", "milliseconds that do not decrease",
                                     problem);
        if (slant && !item_numbers(json, slant, 2, 90, lean))
            return bat_json_complain(json, slant, BAT_SYNTAX, "tilt", "[x, y] in degrees", problem);
        last = when;
        bat_status status = bat_samples_add(&edit->samples, &edit->stage, pixel, press, when, lean);
        if (status != BAT_OK) return status;
        at = json->nodes[at].next;
        p = following(json, p, bat_json_count(json, pressure));
        t = following(json, t, bat_json_count(json, time));
        slant = following(json, slant, bat_json_count(json, tilt));
    }
    return BAT_OK;
}

/* Reads that many numbers, if the member is there. */
static bool read_numbers(reader *r, const char *name, int count, double limit, double *out) {
    uint32_t node = bat_json_member(r->json, r->object, name);
    if (!node || r->status != BAT_OK) return false;
    if (!item_numbers(r->json, node, (uint32_t)count, limit, out))
        r->status = bat_json_complain(r->json, node, BAT_SYNTAX, name,
                                      count == 2   ? "two numbers"
                                      : count == 3 ? "three numbers"
                                                   : "four numbers",
                                      r->problem);
    return r->status == BAT_OK;
}

static void read_redraw(reader *r, bat_sketch_meaning *meaning) {
    static const double none = 0;
    double ends[2] = {0, 0};
    meaning->sense = (int)read(r, "sense", -1, 1, &none);
    if (!read_numbers(r, "ends", 2, BAT_END_RULE_HELD, ends)) return;
    for (int side = 0; side < 2; side++) meaning->end[side] = (bat_end_rule)fmax(ends[side], 0);
}

static void read_new(reader *r, bat_sketch_meaning *meaning, int dimension) {
    uint32_t closed = bat_json_member(r->json, r->object, "closed");
    if (closed)
        meaning->closing = bat_json_type_of(r->json, closed) == BAT_JSON_TRUE ? BAT_CLOSING_YES
                                                                              : BAT_CLOSING_NO;
    uint32_t mark = bat_json_member(r->json, r->object, "mark");
    meaning->mark = mark && bat_json_type_of(r->json, mark) == BAT_JSON_TRUE;
    for (int side = 0; side < 2; side++)
        meaning->put[side] = read_numbers(r, side ? "finish" : "start", dimension, BAT_COORDINATE_MAX,
                                          meaning->tip[side]);
}

static void read_parts(reader *r, bat_edit *edit) {
    uint32_t list = bat_json_member(r->json, r->object, "parts"), node = bat_json_first(r->json, list);
    uint32_t count = bat_json_count(r->json, list);
    if (r->status == BAT_OK && (count < 1 || count > BAT_EDIT_PARTS))
        r->status = bat_json_complain(r->json, list ? list : r->object, BAT_COUNT, "parts",
                                      "a list of 1 to 6", r->problem);
    for (uint32_t i = 0; i < count && r->status == BAT_OK; i++, node = r->json->nodes[node].next) {
        bat_edit_part *part = &edit->part[edit->part_count++];
        reader inner = {r->json, node, r->problem, BAT_OK};
        part->object = (bat_id)read_whole(&inner, "object", 1, 2147483647);
        part->curve = read_whole(&inner, "curve", 0, 2147483647);
        read_redraw(&inner, &part->meaning);
        read_numbers(&inner, "end", bat_stage_dimension(&edit->stage), BAT_COORDINATE_MAX, part->end);
        r->status = inner.status;
    }
}

static bat_status read_ground(const bat_json *json, bat_ground *ground, bat_problem *problem) {
    uint32_t node = bat_json_member(json, 1, "ground");
    const char *name;
    *ground = bat_ground_page();
    for (int i = 0; node && (name = bat_ground_name(i)); i++) {
        double numbers[BAT_GROUND_NUMBERS];
        uint32_t list = bat_json_member(json, node, name), count = bat_json_count(json, list);
        if (list && count <= BAT_GROUND_NUMBERS &&
            item_numbers(json, list, count, BAT_COORDINATE_MAX, numbers) &&
            bat_ground_named(name, (int)count, numbers, ground))
            return BAT_OK;
    }
    return node ? bat_json_complain(json, node, BAT_SYNTAX, "ground", "a ground's name with its numbers",
                                    problem)
                : BAT_OK;
}

bat_status bat_edit_read(const bat_json *json, struct bat_casters *casters, bat_edit *out,
                         bat_problem *problem) {
    static const double one = 1, three = 3, none = 0;
    bat_samples samples = out->samples;
    bat_samples_clear(&samples);
    *out = (bat_edit){.samples = samples, .stage = bat_stage_defaults(), .style = bat_style_defaults()};
    out->stage.casters = casters;
    const char *name = bat_json_text(json, bat_json_member(json, 1, "do"));
    out->kind = bat_edit_named(name ? name : "");
    if (out->kind == BAT_EDIT_COUNT)
        return bat_json_say(json, 1, BAT_UNSUPPORTED, "do: no edit has this name", problem);
    bat_status staged = bat_view_read(json, &out->stage.view, problem);
    if (staged == BAT_OK) staged = read_ground(json, &out->stage.ground, problem);
    reader r = {json, 1, problem, staged};
    const double ids = (double)BAT_ID_MAX;
    out->object = (bat_id)read_whole(&r, "object", 1, ids);
    if (out->kind != BAT_EDIT_NEW) out->curve = read_whole(&r, "curve", 0, ids);
    if (out->kind == BAT_EDIT_LEVEL) out->level = read_whole(&r, "level", BAT_LEVEL_BARE, BAT_LEVELS_MAX);
    if (is_redraw(out->kind)) read_redraw(&r, &out->meaning);
    if (out->kind == BAT_EDIT_SEVERAL) read_parts(&r, out);
    if (has_other(out->kind)) {
        out->other = (bat_id)read_whole(&r, "other", 1, ids);
        out->other_curve = read_whole(&r, "other_curve", 0, ids);
    }
    if (out->kind == BAT_EDIT_NEW) {
        const double colour = out->style.stroke;
        out->style.stroke = (uint32_t)read(&r, "stroke_colour", 0, 4294967295.0, &colour);
        out->style.width = read(&r, "stroke_width", 0, 1e9, &out->style.width);
        read_style(&r, &out->style);
        out->parent = (bat_id)read(&r, "parent", 0, ids, &none);
        out->dashes = (bat_dashing)read(&r, "dashes", 0, BAT_DASHING_OTHER - 1, &none);
        out->pressed = read_switch(&r, "pressed");
        read_new(&r, &out->meaning, bat_stage_dimension(&out->stage));
    }
    bat_sketch_options *options = &out->options;
    *options = bat_sketch_defaults();
    options->pixel = read(&r, "pixel", 1e-9, 1e9, &one);
    options->tolerance = read(&r, "tolerance", 1e-9, 1e9, &options->pixel);
    options->pins = (int)read(&r, "pins", 2, 3, &three);
    options->degree = (int)read(&r, "degree", 3, BAT_DEGREE_MAX, &three);
    options->fairness = read(&r, "fairness", BAT_FAIRNESS_LEAST, BAT_FAIRNESS_MOST, &options->fairness);
    options->width = read(&r, "width", 1, 100, &three);
    options->smooth_limit = read(&r, "smooth_limit", 0, 1e12, &none);
    options->keep_corners = read_switch(&r, "keep_corners");
    out->on_extremes = read_switch(&r, "on_extremes");
    out->accepted = read_switch(&r, "accepted");
    if (r.status == BAT_OK) r.status = bat_mirror_read(json, 1, &out->mirror, problem);
    if (r.status == BAT_OK) r.status = read_stroke(json, bat_json_member(json, 1, "stroke"), out, problem);
    return r.status;
}
