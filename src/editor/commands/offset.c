/*
 * The offset of what is selected: shown over the drawing while its distance and side are chosen, which are the properties of those
 * names; kept, it is one step. Objects that are locked or hidden in a selected group have none.
 */
#include "editor/commands/offset.h"
#include "base/box.h"
#include "editor/choice/choice.h"
#include "editor/commands/beside.h"
#include "editor/commands/tuning.h"
#include "editor/edit/arrange.h"
#include "editor/edit/outlining.h"
#include "editor/session/journal_line.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/commands.h"
#include "editor/tables/settings.h"
#include <math.h>

enum { SIDES = BAT_OFFSET_BOTH + 1 };

static const double FIGURES = 10000; /* distances that the slider tells apart, at most */

static bool is_possible(const bat_document *document, int index) {
    const bat_nesting_level level = bat_document_level(document, index);
    return !level.hidden && !level.locked && bat_outlining_is_flat(bat_document_at(document, index));
}

static double distance_now(const bat_context *c) { return c->settings->values[BAT_PROPERTY_OFFSET_DISTANCE]; }

static bat_offset_side side_now(const bat_context *c) {
    return (bat_offset_side)(int)c->settings->values[BAT_PROPERTY_OFFSET_SIDE];
}

/* ---- the slider: half the longer side of the box around the objects at its end, by the square, so that small ones are easy ---- */

static double longest(const bat_tuning *t) {
    double all[4], box[4];
    bat_box_nothing(all);
    for (int i = 0; i < t->count; i++) {
        bat_object_bounds(t->before[i], box);
        bat_box_hold(all, box);
    }
    const double most = bat_property_at(BAT_PROPERTY_OFFSET_DISTANCE)->high;
    return fmin(fmax(fmax(all[2] - all[0], all[3] - all[1]) / 2, 1), most);
}

/* A round number. */
static double distance_at(const bat_tuning *t, double amount) {
    const double most = longest(t), least = bat_property_at(BAT_PROPERTY_OFFSET_DISTANCE)->low;
    double figures = 1 / least;
    while (figures * most >= FIGURES) figures /= 10;
    return fmin(fmax(round(most * amount * amount * figures) / figures, least), most);
}

static double amount_of(const bat_tuning *t, double distance) { return fmin(sqrt(distance / longest(t)), 1); }

/* ---- shown ---- */

static bat_status show_one(bat_context *c, const bat_object *object) {
    bat_object *beside = NULL;
    bat_status status = bat_outlining_offset(object, distance_now(c), side_now(c), &beside);
    for (int i = 0; status == BAT_OK && beside && i < bat_object_curve_count(beside); i++) {
        bat_curve *curve = NULL;
        status = bat_curve_copy(bat_object_curve(beside, i), &curve);
        if (status == BAT_OK) status = bat_tuning_add(c->tuning, curve);
    }
    bat_object_release(beside);
    return status;
}

/* With the distance and side in force. Curves that tangle are none to show; any other failure leaves what was shown. */
static bat_status show(bat_context *c) {
    bat_tuning *t = c->tuning, kept = *t;
    bat_status status = BAT_OK;
    t->fit = NULL, t->shown = 0;
    for (int i = 0; i < t->count && status == BAT_OK; i++) status = show_one(c, t->before[i]);
    t->why = status == BAT_SINGULAR ? BAT_STRING_NOTICE_REGION_TANGLED : BAT_STRING_NOTICE_OFFSET_EMPTY;
    if (status != BAT_OK) bat_tuning_unshow(t);
    if (status != BAT_OK && status != BAT_SINGULAR) {
        *t = kept;
        return status;
    }
    bat_tuning_unshow(&kept);
    t->amount = amount_of(t, distance_now(c));
    t->version++;
    return BAT_OK;
}

static bat_status take(bat_context *c, double distance, int side) {
    double *values = c->settings->values;
    const double before[2] = {values[BAT_PROPERTY_OFFSET_DISTANCE], values[BAT_PROPERTY_OFFSET_SIDE]};
    values[BAT_PROPERTY_OFFSET_DISTANCE] = distance;
    values[BAT_PROPERTY_OFFSET_SIDE] = side;
    const bat_status status = show(c);
    if (status == BAT_OK) return BAT_OK;
    values[BAT_PROPERTY_OFFSET_DISTANCE] = before[0];
    values[BAT_PROPERTY_OFFSET_SIDE] = before[1];
    bat_notice_failure(c, status);
    return status;
}

static bat_status again(bat_context *c, double amount, bool done) {
    (void)done; /* it is taken by keeping it alone */
    if (!(amount >= 0 && amount <= 1)) return BAT_ARGUMENT;
    return take(c, distance_at(c->tuning, amount), (int)side_now(c));
}

/* ---- kept ---- */

/* What grows lies behind what it was made from, what shrinks in front of it. */
static bat_status offset_one(bat_context *c, int index, bat_beside *m) {
    const bat_object *object = bat_document_at(c->session->document, index);
    const bat_offset_side side = side_now(c);
    bat_object *beside = NULL;
    if (!is_possible(c->session->document, index)) return BAT_OK;
    m->fit++;
    bat_status status = bat_outlining_offset(object, distance_now(c), side, &beside);
    if (status == BAT_OK && beside)
        status = bat_beside_insert(c, side == BAT_OFFSET_INSIDE ? index + 1 : index, beside, m);
    bat_object_release(beside);
    return status;
}

static bat_status keep(bat_context *c) {
    const bat_tuning *t = c->tuning;
    if (t->shown == 0) return bat_notice_refuse(c, BAT_STATE, t->why);
    const bat_status status = bat_beside_each(c, offset_one, BAT_STRING_STEP_CURVE_OFFSET,
                                              BAT_STRING_NOTICE_SELECT_FLAT);
    bat_tuning_free(c->tuning);
    return status;
}

/* The sides, and then to keep it. */
static bat_status choose(bat_context *c, int way) {
    if (way > SIDES) return BAT_ARGUMENT;
    if (way == SIDES) return keep(c);
    return take(c, distance_now(c), way < 0 ? ((int)side_now(c) + 1) % SIDES : way);
}

static int way(const bat_context *c) { return (int)side_now(c); }

static void write(bat_context *c, bat_text *text) {
    const bat_tuning *t = c->tuning;
    static const bat_string words[SIDES + 1] = {BAT_STRING_SIDE_OUTSIDE, BAT_STRING_SIDE_INSIDE,
                                                BAT_STRING_SIDE_BOTH, BAT_STRING_EARLIER_KEEP};
    bat_text_string(text, ",\"of\":\"offset\",\"step\":0.005,\"typed\":\"offset-distance\",\"ways\":");
    bat_line_number(text, SIDES);
    bat_text_string(text, ",\"said\":");
    bat_text_json_string(text, t->shown ? "" : bat_word(c, t->why));
    for (int i = 0; i <= SIDES; i++) {
        bat_text_string(text, i ? "," : ",\"words\":[");
        bat_text_json_string(text, bat_word(c, words[i]));
    }
}

static const bat_tuning_kind offsetting = {
    BAT_STRING_STEP_CURVE_OFFSET, again, NULL, choose, way, write, keep, show};

void bat_offset_follow(bat_context *c, bat_property_id property) {
    if (property == BAT_PROPERTY_OFFSET_DISTANCE || property == BAT_PROPERTY_OFFSET_SIDE)
        bat_tuning_follow(c, &offsetting);
}

/* ---- the command ---- */

bat_status bat_command_curve_offset(bat_context *c, bat_command_id id) {
    (void)id;
    bat_tuning_free(c->tuning);
    return bat_tuning_start(c, &offsetting, bat_tuning_gather(c, is_possible), BAT_STRING_NOTICE_SELECT_FLAT);
}
