/*
 * A blend between two open curves, between the ends of one, or between the edges of two surfaces, or of a surface and a curve; and the first
 * curve's end, or surface's edge, matched to the second: shown with its comb
 * over the drawing while continuity and tension are chosen; kept, it is one step. The nearest ends are meant.
 */
#include "base/real.h"
#include "curve/curve.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/commands/beside.h"
#include "editor/commands/blend_edges.h"
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

/* Open curves, neither locked nor hidden in a group that is selected. */
static bool is_possible(const bat_document *document, int index) {
    const bat_object *object = bat_document_at(document, index);
    const bat_nesting_level level = bat_document_level(document, index);
    return !level.hidden && !level.locked && bat_object_is_made_of_curves(object);
}

/* Or surfaces. */
static bool is_possible_edge(const bat_document *document, int index) {
    const bat_nesting_level level = bat_document_level(document, index);
    return is_possible(document, index) ||
           (!level.hidden && !level.locked && bat_object_surface(bat_document_at(document, index)));
}

static const bat_curve *curve_of(const ends *e, int k) { return bat_object_curve(e->object[k], e->curve[k]); }

static bool is_open(const bat_object *object, int k) {
    return !bat_curve_is_closed(bat_object_curve(object, k));
}

static bool has_open(const bat_object *object) {
    int k = bat_object_curve_count(object);
    while (k > 0 && !is_open(object, k - 1)) k--;
    return k > 0;
}

/* Where an end is; planar ones on the page. */
static void place_of(const bat_curve *curve, bool last, double at[3]) {
    double domain[2];
    bat_curve_domain(curve, domain);
    at[2] = 0;
    bat_curve_eval(curve, domain[last], 0, at);
}

/* How far two ends are from each other. */
static double gap(const bat_curve *a, bool a_last, const bat_curve *b, bool b_last) {
    double from[3], to[3];
    place_of(a, a_last, from), place_of(b, b_last, to);
    return bat_distance(from, to, 3);
}

/* BAT_STATE: not one open curve to blend its ends, nor two. */
static bat_status find(const bat_tuning *t, ends *e) {
    int found = 0;
    for (int i = 0; i < t->count; i++)
        for (int k = 0; k < bat_object_curve_count(t->before[i]); k++) {
            if (bat_object_surface(t->before[i]) || !is_open(t->before[i], k)) continue;
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

static double tension_at(double amount) { return bat_exp((amount - 0.5) * bat_log(RANGE)); }

/* At an end: a blend's way says both. */
static int continuity_at(const bat_tuning *t, int end) { return end ? t->way / WAYS : t->way % WAYS; }

static bat_blend_options options_of(const bat_tuning *t) {
    bat_blend_options options = bat_blend_defaults();
    const double tension[2] = {tension_at(t->amount), tension_at(t->other)};
    for (int k = 0; k < 2; k++) options.continuity[k] = continuity_at(t, k), options.tension[k] = tension[k];
    return options;
}

/* Of two curves of one dimension. */
static bat_status make_of(const bat_tuning *t, const ends *e, bat_curve *const side[2], bat_curve **out) {
    const bat_blend_options options = options_of(t);
    if (t->kind == &matching)
        return bat_curve_match(side[0], e->last[0], side[1], e->last[1], options.continuity[0],
                               options.tension[0], out, NULL);
    return bat_curve_blend(side[0], e->last[0], side[1], e->last[1], &options, out, NULL);
}

/* A planar curve and one in space meet in space. */
static bat_status make(const bat_tuning *t, const ends *e, bat_curve **out) {
    bat_curve *side[2] = {NULL, NULL};
    bat_status status = BAT_OK;
    int dimension = 2;
    for (int k = 0; k < 2; k++)
        if (bat_curve_dimension(curve_of(e, k)) == 3) dimension = 3;
    for (int k = 0; k < 2 && status == BAT_OK; k++)
        status = bat_curve_to_dimension(curve_of(e, k), dimension, &side[k]);
    if (status == BAT_OK) status = make_of(t, e, side, out);
    bat_curve_free(side[0]), bat_curve_free(side[1]);
    return status;
}

/* The surface between the edges, or the first surface with its edge moved. */
static bat_status make_surface(const bat_tuning *t, bat_surface **out) {
    const bat_blend_options options = options_of(t);
    return t->kind == &matching
               ? bat_edge_pair_match(&t->edges, options.continuity[0], options.tension[0], out)
               : bat_edge_pair_blend(&t->edges, &options, out);
}

/* As lines across it. */
static bat_status show_edges(bat_tuning *t) {
    bat_surface *made = NULL;
    bat_status status = make_surface(t, &made);
    if (status != BAT_OK && status != BAT_SINGULAR) return status;
    bat_tuning_unshow(t);
    t->why = BAT_STRING_NOTICE_NOT_POSSIBLE;
    status = made ? bat_edge_pair_show(t, made, t->kind == &matching) : BAT_OK;
    bat_surface_free(made);
    t->version++;
    return status;
}

/* Ends between which there is none leave nothing to show; any other failure leaves what was shown. */
static bat_status show(bat_context *c) {
    bat_tuning *t = c->tuning;
    ends e;
    bat_curve *made = NULL;
    if (t->edges.object[0]) return show_edges(t);
    bat_status status = find(t, &e);
    if (status == BAT_OK) status = make(t, &e, &made);
    if (status != BAT_OK && status != BAT_SINGULAR) return status;
    bat_tuning_unshow(t);
    t->why = BAT_STRING_NOTICE_NOT_POSSIBLE;
    if (made) status = bat_tuning_add(t, made);
    for (int k = 0; k < 2; k++) place_of(curve_of(&e, k), e.last[k], t->place[k]);
    t->version++;
    return status == BAT_SINGULAR ? BAT_OK : status;
}

/* With other tensions or another continuity. */
static bat_status take(bat_context *c, double amount, double other, int way) {
    bat_tuning *t = c->tuning;
    if (!(amount >= 0 && amount <= 1 && other >= 0 && other <= 1)) return BAT_ARGUMENT;
    const double before[2] = {t->amount, t->other};
    const int way_before = t->way;
    t->amount = amount, t->other = other, t->way = way;
    const bat_status status = show(c);
    if (status == BAT_OK) return BAT_OK;
    t->amount = before[0], t->other = before[1], t->way = way_before;
    bat_notice_failure(c, status);
    return status;
}

/* Either is taken by keeping it alone. */
static bat_status again(bat_context *c, double amount, bool done) {
    (void)done;
    return take(c, amount, c->tuning->other, c->tuning->way);
}

static bat_status other(bat_context *c, double amount, bool done) {
    (void)done;
    return take(c, c->tuning->amount, amount, c->tuning->way);
}

/* ---- kept ---- */

static bat_status add_surface(bat_context *c, int index, bat_beside *m) {
    bat_surface *made = NULL;
    bat_object *beside = NULL;
    m->fit++;
    bat_status status = make_surface(c->tuning, &made);
    if (status == BAT_OK) status = bat_edge_pair_object(&c->tuning->edges, made, &beside);
    if (status == BAT_OK) status = bat_beside_insert(c, index + 1, beside, m);
    bat_object_release(beside);
    bat_surface_free(made);
    return status;
}

/* The blend has the style of the first curve or surface, and lies before it. */
static bat_status add(bat_context *c, int index, bat_beside *m) {
    const bat_object *object = bat_document_at(c->session->document, index),
                     *first = c->tuning->edges.object[0];
    if (first) return bat_object_id(object) == bat_object_id(first) ? add_surface(c, index, m) : BAT_OK;
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

/* In place of the object as it was; takes `after` over, whatever it returns. */
static bat_status replace(bat_context *c, const bat_object *before, bat_object *after) {
    bat_status status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        const int at = bat_document_find(c->session->document, bat_object_id(before));
        status = bat_transaction_end(c, bat_transaction_replace(c, at, after), c->tuning->kind->step);
    }
    bat_object_release(after);
    return status;
}

static bat_status put_surface(bat_context *c) {
    const bat_object *before = c->tuning->edges.object[0];
    bat_surface *made = NULL;
    bat_object *after = NULL;
    bat_status status = make_surface(c->tuning, &made);
    if (status == BAT_OK) status = bat_object_with_surface(before, made, &after);
    bat_surface_free(made);
    return status == BAT_OK ? replace(c, before, after) : status;
}

static bat_status put(bat_context *c) {
    ends e;
    bat_curve *made = NULL;
    if (c->tuning->edges.object[0]) return put_surface(c);
    bat_status status = find(c->tuning, &e);
    if (status == BAT_OK) status = make(c->tuning, &e, &made);
    if (status != BAT_OK) return status;
    if (bat_object_curve_count(e.object[0]) > 1)
        return bat_commit_curve(c, bat_object_id(e.object[0]), e.curve[0], made, c->tuning->kind->step);
    bat_object *after = NULL; /* which may be in space now */
    status = bat_object_with_curves(e.object[0], 1, &made, &after);
    return status == BAT_OK ? replace(c, e.object[0], after) : status;
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

/* How many continuities are offered: of a matched end, or of both ends of a blend. */
static int ways_of(const bat_tuning *t) { return t->kind == &matching ? WAYS : 2 * WAYS; }

/* The continuities, and then to keep it. */
static bat_status choose(bat_context *c, int way) {
    const bat_tuning *t = c->tuning;
    const int count = ways_of(t), first = continuity_at(t, 0), second = continuity_at(t, 1);
    if (way > count) return BAT_ARGUMENT;
    if (way == count) return keep(c);
    const int next = (first + 1) % WAYS; /* at both ends */
    return take(c, t->amount, t->other,
                way < 0      ? next + WAYS * next
                : way < WAYS ? way + WAYS * second
                             : first + WAYS * (way - WAYS));
}

static int way(const bat_context *c) { return continuity_at(c->tuning, 0); }

static void write(bat_context *c, bat_text *text) {
    const bat_tuning *t = c->tuning;
    const bool both = t->kind != &matching;
    bat_text_string(text, both ? ",\"of\":\"blend\",\"also\":" : ",\"of\":\"match\"");
    if (both) bat_line_number(text, WAYS + continuity_at(t, 1));
    bat_text_string(text, ",\"step\":0.01,\"ways\":");
    bat_line_number(text, ways_of(t));
    bat_text_string(text, ",\"said\":");
    bat_text_json_string(text, t->shown ? "" : bat_word(c, t->why));
    bat_text_string(text, ",\"words\":[");
    bat_text_string(text,
                    both ? "\"1: G0\",\"1: G1\",\"1: G2\",\"1: G3\",\"2: G0\",\"2: G1\",\"2: G2\",\"2: G3\","
                         : "\"G0\",\"G1\",\"G2\",\"G3\",");
    bat_text_json_string(text, bat_word(c, BAT_STRING_EARLIER_KEEP));
}

static const bat_tuning_kind
    blending = {BAT_STRING_COMMAND_CURVE_BLEND, again, other, choose, way, write, keep, show},
    matching = {BAT_STRING_COMMAND_CURVE_MATCH, again, NULL, choose, way, write, keep, show};

/* ---- the commands ---- */

bat_status bat_command_curve_blend(bat_context *c, bat_command_id id) {
    bat_tuning_free(c->tuning);
    const bool match = id == BAT_COMMAND_CURVE_MATCH;
    const bat_status gathered = bat_tuning_gather(c, is_possible_edge);
    bat_edge_pair edges;
    if (gathered == BAT_OK && bat_edge_pair_find(c->tuning->count, c->tuning->before, &edges))
        c->tuning->edges = edges;
    c->tuning->amount = c->tuning->other = 0.5;
    c->tuning->way = USUAL + WAYS * USUAL;
    c->tuning->comb = true;
    return bat_tuning_start(c, match ? &matching : &blending, gathered, BAT_STRING_NOTICE_SELECT_TWO_OPEN);
}
