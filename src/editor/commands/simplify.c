#include "editor/commands/simplify.h"
#include "editor/commands/tuning.h"
#include "base/real.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/edit/arrange.h"
#include "editor/edit/curves_of.h"
#include "editor/session/journal_line.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/session/undo.h"
#include "editor/tables/commands.h"
#include "editor/tables/settings.h"
#include "editor/view/stage.h"
#include <batten/bezier.h>
#include <batten/fit.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double CORNER = 0.05; /* radians: larger turns stay corners */
static const double RANGE = 256;   /* the largest tolerance that can be chosen over the smallest */

static const bat_tuning_kind simplifying;

/* ---- what is kept ---- */

/* Planar curves that others can take the place of, neither locked nor hidden in a group that is selected. */
static bool is_possible(const bat_document *document, int index) {
    const bat_object *object = bat_document_at(document, index);
    const bat_nesting_level level = bat_document_level(document, index);
    return bat_object_is_made_of_curves(object) && !level.hidden && !level.locked &&
           bat_curve_dimension(bat_object_curve(object, 0)) == 2;
}

/* BAT_STATE: nothing is selected; BAT_ARGUMENT: no curve that can be simplified. */
static bat_status keep(bat_context *c) {
    bat_tuning *s = c->tuning;
    const bat_document *document = c->session->document;
    int *members = NULL, count = 0;
    bat_tuning_free(c->tuning);
    bat_status status = bat_arrange_members(c, &members, &count);
    if (status != BAT_OK) return status;
    s->before = malloc((size_t)(count > 0 ? count : 1) * sizeof *s->before);
    for (int i = 0; i < count && s->before; i++)
        if (is_possible(document, members[i]))
            s->before[s->count++] = bat_object_retain(bat_document_at(document, members[i]));
    free(members);
    if (!s->before) return BAT_MEMORY;
    return s->count > 0 ? BAT_OK : BAT_ARGUMENT;
}

/* ---- simplifying ---- */

/* What is done with a curve of the objects as they were; takes over `fewer`, which is NULL where the curve is as simple
 * as it can be. */
typedef bat_status taker(bat_context *c, const bat_object *object, int index, bat_curve *fewer);

static bat_status put(bat_context *c, const bat_object *object, int index, bat_curve *fewer) {
    return fewer ? bat_put_curve(c, bat_object_id(object), index, fewer) : BAT_OK;
}

static bat_status show(bat_context *c, const bat_object *object, int index, bat_curve *fewer) {
    bat_status status = fewer ? BAT_OK : bat_curve_copy(bat_object_curve(object, index), &fewer);
    return status == BAT_OK ? bat_tuning_add(c->tuning, fewer) : status;
}

/* Fewer points; with G1 joints fewer cubics, or as many with fewer points. *fewer is NULL where there is no such curve.
 */
static bat_status simpler(const bat_curve *curve, double tolerance, bat_joints joints, bat_curve **fewer) {
    bat_status status = (joints == BAT_JOINTS_G1 ? bat_curve_refit_g1 : bat_curve_refit)(curve, tolerance,
                                                                                         CORNER, fewer, NULL);
    if (status != BAT_OK) return status;
    const size_t cubics = (size_t)bat_curve_segment_count(curve);
    const size_t fewer_cubics = (size_t)bat_curve_segment_count(*fewer);
    if (joints == BAT_JOINTS_G1 && cubics != fewer_cubics ? fewer_cubics < cubics
                                                          : bat_curve_count(*fewer) < bat_curve_count(curve))
        return BAT_OK;
    bat_curve_free(*fewer);
    *fewer = NULL;
    return BAT_OK;
}

static void count(bat_simplified *sum, const bat_curve *curve, bool after) {
    sum->points[after] += (size_t)bat_curve_count(curve);
    sum->cubics[after] += (size_t)bat_curve_segment_count(curve);
}

static bat_status simplify_all(bat_context *c, double tolerance, taker *take, bat_simplified *sum) {
    const bat_tuning *t = c->tuning;
    *sum = (bat_simplified){0};
    for (int i = 0; i < t->count; i++)
        for (int k = 0; k < bat_object_curve_count(t->before[i]); k++) {
            const bat_curve *curve = bat_object_curve(t->before[i], k);
            bat_curve *fewer = NULL;
            bat_status status = simpler(curve, tolerance, c->simplifying->joints, &fewer);
            if (status != BAT_OK) return status;
            count(sum, curve, false);
            count(sum, fewer ? fewer : curve, true);
            sum->changed += fewer != NULL;
            status = take(c, t->before[i], k, fewer);
            if (status != BAT_OK) return status;
        }
    return BAT_OK;
}

/* One step, or none when nothing became simpler. */
static bat_status carry_out(bat_context *c, double tolerance) {
    bat_simplified sum;
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    status = simplify_all(c, tolerance, put, &sum);
    status = bat_transaction_end(c, status, BAT_STRING_STEP_SIMPLIFY);
    if (status != BAT_OK) return status;
    c->simplifying->sum = sum;
    bat_tuning_mark(c, &simplifying, sum.changed > 0);
    return BAT_OK;
}

/* "40 → 12", and the words around it. */
static bat_string told(const bat_simplifying *s, char numbers[64]) {
    const bool joined = s->joints == BAT_JOINTS_G1;
    const size_t *counted = joined ? s->sum.cubics : s->sum.points;
    snprintf(numbers, 64, "%zu \xE2\x86\x92 %zu", counted[0], counted[1]);
    return joined ? BAT_STRING_NOTICE_SIMPLIFIED_G1 : BAT_STRING_NOTICE_SIMPLIFIED;
}

static void tell(bat_context *c) {
    char numbers[64];
    const bat_string words = told(c->simplifying, numbers);
    if (c->simplifying->sum.changed == 0)
        bat_notice(c, BAT_STRING_NOTICE_SIMPLE_ALREADY);
    else
        bat_notice_value(c, words, numbers);
}

static bat_status refuse(bat_context *c, bat_status status) {
    bat_tuning_free(c->tuning);
    const bat_string why = status == BAT_STATE      ? BAT_STRING_NOTICE_SELECT_FIRST
                           : status == BAT_ARGUMENT ? BAT_STRING_NOTICE_NOT_POSSIBLE
                                                    : BAT_STRING_COUNT;
    return bat_notice_refuse(c, status == BAT_ARGUMENT ? BAT_STATE : status, why);
}

bat_status bat_command_curve_simplify(bat_context *c, bat_command_id id) {
    (void)id;
    bat_simplifying *s = c->simplifying;
    bat_status status = keep(c);
    if (status != BAT_OK) return refuse(c, status);
    s->tolerance = c->settings->values[BAT_PROPERTY_TOLERANCE] * bat_stage_pixel(c->stage);
    c->tuning->amount = 0.5;
    status = carry_out(c, s->tolerance);
    if (status != BAT_OK) {
        bat_tuning_free(c->tuning);
        bat_notice_failure(c, status);
        return status;
    }
    tell(c);
    return c->tuning->stepped ? BAT_OK : BAT_STATE;
}

/* ---- again ---- */

/* Replaces the step; when that fails, it is as it was. */
static bat_status replace(bat_context *c, double tolerance) {
    const bool stepped = c->tuning->stepped;
    bat_status status = stepped ? bat_session_step(c, true) : BAT_OK;
    if (status != BAT_OK) return status;
    status = carry_out(c, tolerance);
    if (status == BAT_OK) return BAT_OK;
    if (stepped) bat_session_step(c, false);
    bat_tuning_mark(c, &simplifying, stepped);
    return status;
}

static double chosen(const bat_simplifying *s, double amount) {
    return s->tolerance * bat_exp((amount - 0.5) * bat_log(RANGE));
}

static bat_status shown(bat_context *c, double tolerance) {
    bat_simplifying *s = c->simplifying;
    bat_simplified sum;
    bat_status status = simplify_all(c, tolerance, show, &sum);
    if (status != BAT_OK) return status;
    s->sum = sum;
    c->tuning->version++;
    return BAT_OK;
}

/* In place of the step, or only shown. */
static bat_status choose(bat_context *c, double amount, bool done) {
    bat_simplifying *s = c->simplifying;
    bat_tuning_unshow(c->tuning);
    bat_status status = (done ? replace : shown)(c, chosen(s, amount));
    if (status != BAT_OK) {
        bat_tuning_unshow(c->tuning);
        bat_notice_failure(c, status);
        return status;
    }
    c->tuning->amount = amount;
    if (done) tell(c);
    return BAT_OK;
}

static bat_status again(bat_context *c, double amount, bool done) {
    if (!(amount >= 0 && amount <= 1)) return BAT_ARGUMENT;
    return choose(c, amount, done);
}

/* Takes other joints. */
static bat_status join(bat_context *c, int joints) {
    bat_simplifying *s = c->simplifying;
    if (joints < 0) joints = s->joints == BAT_JOINTS_C2 ? BAT_JOINTS_G1 : BAT_JOINTS_C2;
    if (joints >= BAT_JOINTS_COUNT) return BAT_ARGUMENT;
    const bat_joints before = s->joints;
    s->joints = (bat_joints)joints;
    bat_status status = choose(c, c->tuning->amount, true);
    if (status != BAT_OK) s->joints = before;
    return status;
}

static int way(const bat_context *c) { return (int)c->simplifying->joints; }

static void counted(bat_text *text, const char *what, const size_t count[2]) {
    bat_text_string(text, ",\"");
    bat_text_string(text, what);
    bat_text_string(text, "\":");
    bat_line_numbers(text, (double[]){(double)count[0], (double)count[1]}, 2, 1);
}

static void write(bat_context *c, bat_text *text) {
    const bat_simplifying *s = c->simplifying;
    char numbers[64], said[BAT_NOTICE_ROOM];
    const bat_string words = told(s, numbers);
    bat_word_fill(c, words, 1, (const char *const[]){numbers}, said, sizeof said);
    bat_text_string(text, ",\"of\":\"simplify\"");
    counted(text, "points", s->sum.points);
    counted(text, "cubics", s->sum.cubics);
    bat_text_string(text, ",\"said\":");
    bat_text_json_string(text, said);
    bat_text_string(text, ",\"words\":[");
    bat_text_json_string(text, bat_word(c, BAT_STRING_SIMPLIFY_C2));
    bat_text_string(text, ",");
    bat_text_json_string(text, bat_word(c, BAT_STRING_SIMPLIFY_G1));
}

static const bat_tuning_kind simplifying = {
    BAT_STRING_STEP_SIMPLIFY, again, NULL, join, way, write, NULL, NULL};
