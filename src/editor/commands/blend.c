/*
 * A blend between two open curves, or between the ends of one, and the first curve's end matched to the second: shown with its comb
 * over the drawing while continuity and tension are chosen; kept, it is one step. The nearest ends are meant.
 */
#include "base/real.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/commands/beside.h"
#include "editor/commands/tuning.h"
#include "editor/edit/curves_of.h"
#include "editor/session/journal_line.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/commands.h"
#include "editor/tables/settings.h"
#include <batten/blend.h>
#include <math.h>

enum { WAYS = BAT_CONTINUITY_MAX + 1, USUAL = 2 };

static const double RANGE = 16; /* the largest tension over the smallest */
static const bat_tuning_kind blending, matching;

/* The two ends: on objects as they were, which curve of each, and whether its end. */
typedef struct ends {
    const bat_object *object[2];
    int curve[2];
    bool last[2];
} ends;

/* Open planar curves, neither locked nor hidden in a group that is selected. */
static bool is_possible(const bat_document *document, int index) {
    const bat_object *object = bat_document_at(document, index);
    const bat_nesting_level level = bat_document_level(document, index);
    return !level.hidden && !level.locked && bat_object_is_made_of_curves(object);
}

static const bat_curve *curve_of(const ends *e, int k) { return bat_object_curve(e->object[k], e->curve[k]); }

static bool is_open(const bat_object *object, int k) {
    const bat_curve *curve = bat_object_curve(object, k);
    return !bat_curve_is_closed(curve) && bat_curve_dimension(curve) == 2;
}

static bool has_open(const bat_object *object) {
    int k = bat_object_curve_count(object);
    while (k > 0 && !is_open(object, k - 1)) k--;
    return k > 0;
}

/* How far two ends are from each other. */
static double gap(const bat_curve *a, bool a_last, const bat_curve *b, bool b_last) {
    double jump[WAYS] = {INFINITY};
    bat_curve_jump(a, a_last, b, b_last, jump);
    return jump[0];
}

/* BAT_STATE: not one open curve to blend its ends, nor two. */
static bat_status find(const bat_tuning *t, ends *e) {
    int found = 0;
    for (int i = 0; i < t->count; i++)
        for (int k = 0; k < bat_object_curve_count(t->before[i]); k++) {
            if (!is_open(t->before[i], k)) continue;
            if (found < 2) e->object[found] = t->before[i], e->curve[found] = k;
            found++;
        }
    if (found < 1 || found > 2 || (found == 1 && t->kind == &matching)) return BAT_STATE;
    if (found == 1) {
        *e = (ends){{e->object[0], e->object[0]}, {e->curve[0], e->curve[0]}, {true, false}};
        return BAT_OK;
    }
    double least = INFINITY;
    for (int way = 0; way < 4; way++) {
        const bool a = !(way & 1), b = way & 2;
        const double far = gap(curve_of(e, 0), a, curve_of(e, 1), b);
        if (far < least) least = far, e->last[0] = a, e->last[1] = b;
    }
    return BAT_OK;
}

static bat_status make(const bat_tuning *t, const ends *e, bat_curve **out) {
    const double tension = bat_exp((t->amount - 0.5) * bat_log(RANGE));
    if (t->kind == &matching)
        return bat_curve_match(curve_of(e, 0), e->last[0], curve_of(e, 1), e->last[1], t->way, tension, out,
                               NULL);
    bat_blend_options options = bat_blend_defaults();
    for (int k = 0; k < 2; k++) options.continuity[k] = t->way, options.tension[k] = tension;
    return bat_curve_blend(curve_of(e, 0), e->last[0], curve_of(e, 1), e->last[1], &options, out, NULL);
}

/* Ends between which there is none leave nothing to show; any other failure leaves what was shown. */
static bat_status show(bat_context *c) {
    bat_tuning *t = c->tuning;
    ends e;
    bat_curve *made = NULL;
    bat_status status = find(t, &e);
    if (status == BAT_OK) status = make(t, &e, &made);
    if (status != BAT_OK && status != BAT_SINGULAR) return status;
    bat_tuning_unshow(t);
    t->why = BAT_STRING_NOTICE_NOT_POSSIBLE;
    if (made) status = bat_tuning_add(t, made);
    t->version++;
    return status == BAT_SINGULAR ? BAT_OK : status;
}

/* With another tension or continuity. */
static bat_status take(bat_context *c, double amount, int way) {
    bat_tuning *t = c->tuning;
    const double amount_before = t->amount;
    const int way_before = t->way;
    t->amount = amount, t->way = way;
    const bat_status status = show(c);
    if (status == BAT_OK) return BAT_OK;
    t->amount = amount_before, t->way = way_before;
    bat_notice_failure(c, status);
    return status;
}

static bat_status again(bat_context *c, double amount, bool done) {
    (void)done; /* it is taken by keeping it alone */
    return amount >= 0 && amount <= 1 ? take(c, amount, c->tuning->way) : BAT_ARGUMENT;
}

/* ---- kept ---- */

/* The blend has the style of the first curve, and lies before it. */
static bat_status add(bat_context *c, int index, bat_beside *m) {
    const bat_object *object = bat_document_at(c->session->document, index);
    ends e;
    bat_curve *made = NULL;
    bat_object *beside = NULL;
    if (!has_open(object))
        return BAT_OK; /* one of two at most: the ends are not looked for with each of many */
    bat_status status = find(c->tuning, &e);
    if (status != BAT_OK || bat_object_id(object) != bat_object_id(e.object[0])) return status;
    m->fit++;
    status = make(c->tuning, &e, &made);
    if (status == BAT_OK) status = bat_object_with_curves(object, 1, &made, &beside);
    if (status == BAT_OK) status = bat_beside_insert(c, index + 1, beside, m);
    bat_object_release(beside);
    return status;
}

static bat_status put(bat_context *c) {
    ends e;
    bat_curve *made = NULL;
    bat_status status = find(c->tuning, &e);
    if (status == BAT_OK) status = make(c->tuning, &e, &made);
    if (status != BAT_OK) return status;
    return bat_commit_curve(c, bat_object_id(e.object[0]), e.curve[0], made, c->tuning->kind->step);
}

static bat_status keep(bat_context *c) {
    const bat_tuning *t = c->tuning;
    if (t->shown == 0) return bat_notice_refuse(c, BAT_STATE, t->why);
    const bat_status status = t->kind == &matching
                                  ? put(c)
                                  : bat_beside_each(c, add, t->kind->step, BAT_STRING_NOTICE_SELECT_TWO_OPEN);
    bat_tuning_free(c->tuning);
    return status;
}

/* The continuities, and then to keep it. */
static bat_status choose(bat_context *c, int way) {
    if (way > WAYS) return BAT_ARGUMENT;
    if (way == WAYS) return keep(c);
    return take(c, c->tuning->amount, way < 0 ? (c->tuning->way + 1) % WAYS : way);
}

static int way(const bat_context *c) { return c->tuning->way; }

static void write(bat_context *c, bat_text *text) {
    const bat_tuning *t = c->tuning;
    bat_text_string(text, t->kind == &matching ? ",\"of\":\"match\"" : ",\"of\":\"blend\"");
    bat_text_string(text, ",\"step\":0.01,\"ways\":4,\"said\":");
    bat_text_json_string(text, t->shown ? "" : bat_word(c, t->why));
    bat_text_string(text, ",\"words\":[\"G0\",\"G1\",\"G2\",\"G3\",");
    bat_text_json_string(text, bat_word(c, BAT_STRING_EARLIER_KEEP));
}

static const bat_tuning_kind
    blending = {BAT_STRING_COMMAND_CURVE_BLEND, again, choose, way, write, keep, show},
    matching = {BAT_STRING_COMMAND_CURVE_MATCH, again, choose, way, write, keep, show};

/* ---- the commands ---- */

bat_status bat_command_curve_blend(bat_context *c, bat_command_id id) {
    bat_tuning_free(c->tuning);
    const bat_status gathered = bat_tuning_gather(c, is_possible);
    c->tuning->amount = 0.5;
    c->tuning->way = USUAL;
    c->tuning->comb = true;
    return bat_tuning_start(c, id == BAT_COMMAND_CURVE_MATCH ? &matching : &blending, gathered,
                            BAT_STRING_NOTICE_SELECT_TWO_OPEN);
}
