/*
 * Copies of what is selected in a row, a grid or a circle: shown over the drawing while their number and places are chosen, which
 * are the properties of those names; kept, they are one step, and are selected with what they are copies of.
 */
#include "editor/commands/array.h"
#include "base/box.h"
#include "base/matrix.h"
#include "document/document.h"
#include "document/kind.h"
#include "editor/commands/tuning.h"
#include "editor/edit/arrange.h"
#include "editor/edit/array.h"
#include "editor/session/journal_line.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/commands.h"
#include "editor/tables/settings.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 10000 }; /* objects that are made, at most */

static const double FIGURES = 10000; /* gaps that the slider tells apart, at most */
static const double FARTHEST = 2;    /* the gap at the slider's end, by the longer side of what is copied */

static double value_of(const bat_context *c, bat_property_id id) { return c->settings->values[id]; }

static bat_array array_now(const bat_context *c) {
    return (bat_array){
        .shape = (bat_array_shape)(int)value_of(c, BAT_PROPERTY_ARRAY_SHAPE),
        .count = (int)round(value_of(c, BAT_PROPERTY_ARRAY_COUNT)),
        .rows = (int)round(value_of(c, BAT_PROPERTY_ARRAY_ROWS)),
        .gap = {value_of(c, BAT_PROPERTY_ARRAY_GAP), value_of(c, BAT_PROPERTY_ARRAY_GAP_DOWN)},
        .direction = value_of(c, BAT_PROPERTY_ARRAY_DIRECTION),
        .radius = value_of(c, BAT_PROPERTY_ARRAY_RADIUS),
        .angle = value_of(c, BAT_PROPERTY_ARRAY_ANGLE),
        .turns = value_of(c, BAT_PROPERTY_ARRAY_TURN) != 0,
    };
}

/* The box around all that there would be; of a heap, or of too many, that around what is copied. */
static void box_of_all(const bat_context *c, double box[4]) {
    const bat_tuning *t = c->tuning;
    const bat_array array = array_now(c);
    memcpy(box, t->around, 4 * sizeof *box);
    for (int i = 1; t->why == BAT_STRING_COUNT && i < bat_array_count(&array); i++) {
        double matrix[6];
        bat_array_place(&array, t->around, i, matrix);
        for (int k = 0; k < 4; k++) {
            const double x = t->around[k & 1 ? 2 : 0], y = t->around[k & 2 ? 3 : 1];
            const double at[2] = {matrix[0] * x + matrix[2] * y + matrix[4],
                                  matrix[1] * x + matrix[3] * y + matrix[5]};
            bat_box_hold(box, (double[]){at[0], at[1], at[0], at[1]});
        }
    }
}

/* ---- the slider: the gap, or of a circle the radius, by the square, so that small ones are easy ---- */

static double farthest(const bat_context *c) {
    const double *box = c->tuning->around;
    const double most = bat_property_at(BAT_PROPERTY_ARRAY_RADIUS)->high;
    return fmin(fmax(fmax(box[2] - box[0], box[3] - box[1]) * FARTHEST, 1), most);
}

static double distance_at(const bat_context *c, double amount) {
    const double most = farthest(c);
    double figures = 1000;
    while (figures * most >= FIGURES) figures /= 10;
    return round(most * amount * amount * figures) / figures;
}

static double amount_now(const bat_context *c) {
    const bat_array array = array_now(c);
    const double distance = array.shape == BAT_ARRAY_CIRCLE ? array.radius : array.gap[0];
    return fmin(sqrt(fmax(distance, 0) / farthest(c)), 1);
}

/* ---- shown ---- */

static bat_status add_image(bat_tuning *t, const bat_curve *curve, const double matrix[6]) {
    double rows[12];
    bat_curve *image = NULL;
    bat_matrix_rows(matrix, bat_curve_dimension(curve), rows);
    const bat_status status = bat_curve_transform(curve, rows, &image);
    return status == BAT_OK ? bat_tuning_add(t, image) : status;
}

/* What is not made of curves is shown as the box around it. */
static bat_status show_box(bat_tuning *t, const bat_object *object, const double matrix[6]) {
    static const double knots[5] = {0, 1, 2, 3, 4};
    double b[4];
    bat_curve *curve = NULL;
    bat_object_bounds(object, b);
    if (!(b[0] <= b[2])) return BAT_OK;
    const double points[8] = {b[0], b[1], b[2], b[1], b[2], b[3], b[0], b[3]};
    bat_status status = bat_curve_create(2, 1, true, 4, points, 5, knots, &curve);
    if (status == BAT_OK) status = add_image(t, curve, matrix);
    bat_curve_free(curve);
    return status;
}

static bat_status show_one(bat_tuning *t, const bat_object *object, const double matrix[6]) {
    bat_status status = BAT_OK;
    if (!bat_object_is_made_of_curves(object)) return show_box(t, object, matrix);
    for (int i = 0; i < bat_object_curve_count(object) && status == BAT_OK; i++)
        status = add_image(t, bat_object_curve(object, i), matrix);
    return status;
}

/* BAT_STRING_COUNT: it can be made. */
static bat_string why_not(const bat_tuning *t, const bat_array *array) {
    const int count = bat_array_count(array);
    return count < 2                             ? BAT_STRING_NOTICE_ARRAY_ONE
           : count - 1 > MOST / t->count         ? BAT_STRING_NOTICE_ARRAY_MANY
           : bat_array_is_heap(array, t->around) ? BAT_STRING_NOTICE_ARRAY_HEAP
                                                 : BAT_STRING_COUNT;
}

/* With the properties in force. What can not be made is none to show; a failure leaves what was shown. */
static bat_status show(bat_context *c) {
    bat_tuning *t = c->tuning, kept = *t;
    const bat_array array = array_now(c);
    bat_status status = BAT_OK;
    t->fit = NULL, t->shown = 0;
    t->why = why_not(t, &array);
    for (int i = 1; t->why == BAT_STRING_COUNT && i < bat_array_count(&array) && status == BAT_OK; i++) {
        double matrix[6];
        bat_array_place(&array, t->around, i, matrix);
        for (int k = 0; k < t->count && status == BAT_OK; k++) status = show_one(t, t->before[k], matrix);
    }
    if (status != BAT_OK) {
        bat_tuning_unshow(t);
        *t = kept;
        return status;
    }
    bat_tuning_unshow(&kept);
    t->amount = amount_now(c);
    t->version++;
    return BAT_OK;
}

static bat_status take(bat_context *c, const bat_property_id *ids, double value) {
    double *values = c->settings->values;
    const double before[2] = {values[ids[0]], values[ids[1]]};
    values[ids[0]] = values[ids[1]] = value;
    const bat_status status = show(c);
    if (status == BAT_OK) return BAT_OK;
    values[ids[0]] = before[0];
    values[ids[1]] = before[1];
    bat_notice_failure(c, status);
    return status;
}

static bat_status take_one(bat_context *c, bat_property_id id, double value) {
    return take(c, (const bat_property_id[2]){id, id}, value);
}

static bat_status again(bat_context *c, double amount, bool done) {
    (void)done; /* it is taken by keeping it alone */
    if (!(amount >= 0 && amount <= 1)) return BAT_ARGUMENT;
    const double distance = distance_at(c, amount);
    if (array_now(c).shape == BAT_ARRAY_CIRCLE) return take_one(c, BAT_PROPERTY_ARRAY_RADIUS, distance);
    return take(c, (const bat_property_id[2]){BAT_PROPERTY_ARRAY_GAP, BAT_PROPERTY_ARRAY_GAP_DOWN}, distance);
}

/* ---- kept ---- */

static bat_status keep(bat_context *c) {
    const bat_array array = array_now(c);
    const bat_tuning *t = c->tuning;
    if (t->why != BAT_STRING_COUNT) return bat_notice_refuse(c, BAT_STATE, t->why);
    const int copies = bat_array_count(&array) - 1;
    double(*matrices)[6] = malloc((size_t)copies * sizeof *matrices);
    bat_status status = matrices ? BAT_OK : BAT_MEMORY;
    for (int i = 0; i < copies && matrices; i++) bat_array_place(&array, t->around, i + 1, matrices[i]);
    if (status == BAT_OK)
        status = bat_arrange_copies(c, copies, (const double(*)[6])matrices, BAT_STRING_STEP_ARRAY);
    free(matrices);
    bat_tuning_free(c->tuning);
    return status == BAT_OK ? BAT_OK : bat_notice_refuse(c, status, BAT_STRING_COUNT);
}

static bool is_circle(const bat_context *c) { return array_now(c).shape == BAT_ARRAY_CIRCLE; }

/* The shapes; of a circle whether its copies turn; and then to keep it. */
static bat_status choose(bat_context *c, int way) {
    const int last = BAT_ARRAY_SHAPES + is_circle(c);
    if (way > last) return BAT_ARGUMENT;
    if (way == last) return keep(c);
    if (way == BAT_ARRAY_SHAPES) return take_one(c, BAT_PROPERTY_ARRAY_TURN, !array_now(c).turns);
    const int shape = way < 0 ? ((int)array_now(c).shape + 1) % BAT_ARRAY_SHAPES : way;
    return take_one(c, BAT_PROPERTY_ARRAY_SHAPE, shape);
}

static int way(const bat_context *c) { return (int)array_now(c).shape; }

static void write(bat_context *c, bat_text *text) {
    static const char *const typed[] = {"array-count array-gap array-direction",
                                        "array-count array-rows array-gap array-gap-down",
                                        "array-count array-radius array-angle"};
    const bat_array array = array_now(c);
    const bat_string words[] = {BAT_STRING_ARRAY_ROW, BAT_STRING_ARRAY_GRID, BAT_STRING_ARRAY_CIRCLE,
                                array.turns ? BAT_STRING_ARRAY_UPRIGHT : BAT_STRING_ARRAY_TURNED,
                                BAT_STRING_EARLIER_KEEP};
    double all[4], around[4];
    box_of_all(c, all);
    bat_tuning_look(c->stage, all, around);
    bat_text_string(text, ",\"of\":\"array\",\"around\":");
    bat_line_numbers(text, around, 4, 1);
    bat_text_string(text, ",\"step\":0.005,\"typed\":");
    bat_text_json_string(text, typed[array.shape]);
    bat_text_string(text, ",\"ways\":");
    bat_line_number(text, BAT_ARRAY_SHAPES);
    bat_text_string(text, ",\"said\":");
    bat_text_json_string(text, c->tuning->why == BAT_STRING_COUNT ? "" : bat_word(c, c->tuning->why));
    for (int i = 0; i < (int)(sizeof words / sizeof *words); i++) {
        if (i == BAT_ARRAY_SHAPES && !is_circle(c)) continue;
        bat_text_string(text, i ? "," : ",\"words\":[");
        bat_text_json_string(text, bat_word(c, words[i]));
    }
}

static const bat_tuning_kind arraying = {BAT_STRING_STEP_ARRAY, again, NULL, choose, way, write, keep, show};

void bat_array_follow(bat_context *c, bat_property_id property) {
    if (property >= BAT_PROPERTY_ARRAY_SHAPE && property <= BAT_PROPERTY_ARRAY_TURN)
        bat_tuning_follow(c, &arraying);
}

/* ---- the command ---- */

bat_status bat_command_array(bat_context *c, bat_command_id id) {
    (void)id;
    bat_tuning_free(c->tuning);
    const bool some = bat_arrange_selection_box(c, c->tuning->around);
    return bat_tuning_start(c, &arraying, some ? bat_tuning_gather(c, NULL) : BAT_STATE,
                            BAT_STRING_NOTICE_SELECT_FIRST);
}
