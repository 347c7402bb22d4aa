#include "editor/commands/simplify.h"
#include "base/real.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/edit/arrange.h"
#include "editor/edit/curves_of.h"
#include "editor/scene/path.h"
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

static const double CORNER = 0.05; /* radians: larger turns stay corners */
static const double RANGE = 256;   /* the largest tolerance that can be chosen over the smallest */
static const float FIT_WIDTH = 2;

/* ---- what is kept ---- */

static void drop_shown(bat_simplifying *s) {
    for (int i = 0; i < s->shown; i++) bat_curve_free(s->fit[i]);
    free(s->fit);
    s->fit = NULL;
    s->shown = 0;
}

void bat_simplify_free(bat_simplifying *s) {
    drop_shown(s);
    for (int i = 0; i < s->count; i++) bat_object_release(s->before[i]);
    free(s->before);
    *s = (bat_simplifying){.version = s->version, .joints = s->joints};
}

bool bat_simplify_holds(const bat_context *c) {
    const bat_simplifying *s = c->simplifying;
    return s->count > 0 && s->revision == c->session->revision && s->tool == c->choice->tool &&
           s->selection == c->choice->selection.version && !c->session->busy;
}

uint32_t bat_simplify_version(const bat_context *c) {
    return bat_simplify_holds(c) ? c->simplifying->version | 1U << 31 : 0;
}

/* From now on this is the last thing done. */
static void mark(bat_context *c, bool stepped) {
    bat_simplifying *s = c->simplifying;
    s->stepped = stepped;
    s->revision = c->session->revision;
    s->selection = c->choice->selection.version;
    s->tool = c->choice->tool;
    s->version++;
}

/* Planar curves that others can take the place of, neither locked nor hidden in a group that is selected. */
static bool is_possible(const bat_document *document, int index) {
    const bat_object *object = bat_document_at(document, index);
    const bat_nesting_level level = bat_document_level(document, index);
    return bat_object_is_made_of_curves(object) && !level.hidden && !level.locked &&
           bat_curve_dimension(bat_object_curve(object, 0)) == 2;
}

/* BAT_STATE: nothing is selected; BAT_ARGUMENT: no curve that can be simplified. */
static bat_status keep(bat_context *c) {
    bat_simplifying *s = c->simplifying;
    const bat_document *document = c->session->document;
    int *members = NULL, count = 0;
    bat_simplify_free(s);
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

void bat_simplify_place(const bat_context *c, double at[2]) {
    double box[4];
    const bool some = bat_arrange_selection_box(c, box);
    for (int k = 0; k < 2; k++) at[k] = some ? box[k + 2] : 0;
}

/* ---- simplifying ---- */

/* What is done with a curve of the objects as they were; takes over `fewer`, which is NULL where the curve is as simple
 * as it can be. */
typedef bat_status taker(bat_context *c, const bat_object *object, int index, bat_curve *fewer);

static bat_status put(bat_context *c, const bat_object *object, int index, bat_curve *fewer) {
    return fewer ? bat_put_curve(c, bat_object_id(object), index, fewer) : BAT_OK;
}

static bat_status show(bat_context *c, const bat_object *object, int index, bat_curve *fewer) {
    bat_simplifying *s = c->simplifying;
    bat_curve **more = realloc(s->fit, (size_t)(s->shown + 1) * sizeof *more);
    bat_status status = more ? BAT_OK : BAT_MEMORY;
    if (more) s->fit = more;
    if (more && !fewer) status = bat_curve_copy(bat_object_curve(object, index), &fewer);
    if (status == BAT_OK)
        s->fit[s->shown++] = fewer;
    else
        bat_curve_free(fewer);
    return status;
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
    const bat_simplifying *s = c->simplifying;
    *sum = (bat_simplified){0};
    for (int i = 0; i < s->count; i++)
        for (int k = 0; k < bat_object_curve_count(s->before[i]); k++) {
            const bat_curve *curve = bat_object_curve(s->before[i], k);
            bat_curve *fewer = NULL;
            bat_status status = simpler(curve, tolerance, s->joints, &fewer);
            if (status != BAT_OK) return status;
            count(sum, curve, false);
            count(sum, fewer ? fewer : curve, true);
            sum->changed += fewer != NULL;
            status = take(c, s->before[i], k, fewer);
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
    mark(c, sum.changed > 0);
    return BAT_OK;
}

static void tell(bat_context *c) {
    const bat_simplifying *s = c->simplifying;
    const bool joined = s->joints == BAT_JOINTS_G1;
    const size_t *counted = joined ? s->sum.cubics : s->sum.points;
    char numbers[64];
    if (s->sum.changed == 0) {
        bat_notice(c, BAT_STRING_NOTICE_SIMPLE_ALREADY);
        return;
    }
    snprintf(numbers, sizeof numbers, "%zu \xE2\x86\x92 %zu", counted[0], counted[1]);
    bat_notice_value(c, joined ? BAT_STRING_NOTICE_SIMPLIFIED_G1 : BAT_STRING_NOTICE_SIMPLIFIED, numbers);
}

static bat_status refuse(bat_context *c, bat_status status) {
    bat_simplify_free(c->simplifying);
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
    s->amount = 0.5;
    status = carry_out(c, s->tolerance);
    if (status != BAT_OK) {
        bat_simplify_free(s);
        bat_notice_failure(c, status);
        return status;
    }
    tell(c);
    return s->stepped ? BAT_OK : BAT_STATE;
}

/* ---- again ---- */

/* Replaces the step; when that fails, it is as it was. */
static bat_status replace(bat_context *c, double tolerance) {
    const bool stepped = c->simplifying->stepped;
    bat_status status = stepped ? bat_session_step(c, true) : BAT_OK;
    if (status != BAT_OK) return status;
    status = carry_out(c, tolerance);
    if (status == BAT_OK) return BAT_OK;
    if (stepped) bat_session_step(c, false);
    mark(c, stepped);
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
    s->version++;
    return BAT_OK;
}

/* In place of the step, or only shown. */
static bat_status choose(bat_context *c, double amount, bool done) {
    bat_simplifying *s = c->simplifying;
    drop_shown(s);
    bat_status status = (done ? replace : shown)(c, chosen(s, amount));
    if (status != BAT_OK) {
        drop_shown(s);
        bat_notice_failure(c, status);
        return status;
    }
    s->amount = amount;
    if (done) tell(c);
    return BAT_OK;
}

bat_status bat_simplify_again(bat_context *c, double amount, bool done) {
    if (!bat_simplify_holds(c)) return BAT_STATE;
    if (!(amount >= 0 && amount <= 1)) return BAT_ARGUMENT;
    return choose(c, amount, done);
}

bat_status bat_simplify_joined(bat_context *c, int joints) {
    bat_simplifying *s = c->simplifying;
    if (!bat_simplify_holds(c)) return BAT_STATE;
    if (joints < 0 || joints >= BAT_JOINTS_COUNT) return BAT_ARGUMENT;
    const bat_joints before = s->joints;
    s->joints = (bat_joints)joints;
    bat_status status = choose(c, s->amount, true);
    if (status != BAT_OK) s->joints = before;
    return status;
}

bool bat_simplify_cancel(bat_context *c) {
    bat_simplifying *s = c->simplifying;
    if (!bat_simplify_holds(c)) return false;
    if (s->stepped && bat_session_step(c, true) == BAT_OK)
        bat_notice_value(c, BAT_STRING_NOTICE_UNDONE, bat_word(c, BAT_STRING_STEP_SIMPLIFY));
    bat_simplify_free(s);
    return true;
}

bool bat_simplify_accept(bat_context *c) {
    const bool holds = bat_simplify_holds(c);
    if (holds) bat_simplify_free(c->simplifying);
    return holds;
}

void bat_simplify_show(bat_context *c, bat_overlay *overlay) {
    const bat_simplifying *s = c->simplifying;
    if (s->shown == 0 || !bat_simplify_holds(c)) return;
    bat_overlay_item(overlay, BAT_ROLE_FIT, BAT_ITEM_STROKED, FIT_WIDTH);
    for (int i = 0; i < s->shown; i++) bat_path_curve(&overlay->path, s->fit[i]);
}
