/* Simplifies the selected curves: as few knots as keep them within the tolerance. */
#include "editor/tables/commands.h"
#include "editor/choice/choice.h"
#include "editor/edit/arrange.h"
#include "editor/edit/curves_of.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/view/stage.h"
#include <batten/fit.h>
#include <stdio.h>
#include <stdlib.h>

static const double CORNER = 0.05; /* radians: larger turns stay corners */

typedef struct tally {
    size_t before, after; /* control points of the whole selection */
} tally;

/* Within the transaction: simplifies each curve of the object that can do with fewer points. */
static bat_status simplify_object(bat_context *c, int index, double tolerance, tally *sum) {
    const bat_object *object = bat_document_at(c->session->document, index);
    const bat_id id = bat_object_id(object);
    const int count = bat_object_curve_count(object);
    for (int k = 0; k < count; k++) {
        const bat_curve *curve = bat_edit_target(c->session->document, id, k);
        if (!curve) continue;
        const size_t before = (size_t)bat_curve_count(curve);
        bat_curve *fewer = NULL;
        bat_status status = bat_curve_refit(curve, tolerance, CORNER, &fewer, NULL);
        if (status != BAT_OK) return status;
        const size_t after = (size_t)bat_curve_count(fewer);
        sum->before += before, sum->after += after;
        if (after < before)
            status = bat_put_curve(c, id, k, fewer);
        else
            bat_curve_free(fewer);
        if (status != BAT_OK) return status;
    }
    return BAT_OK;
}

static bat_status nothing(bat_context *c, bat_status status, bat_string why) {
    if (status == BAT_OK)
        bat_notice(c, why);
    else
        bat_notice_failure(c, status);
    return status == BAT_OK ? BAT_STATE : status;
}

bat_status bat_command_curve_simplify(bat_context *c, bat_command_id id) {
    (void)id;
    int *members = NULL, count = 0;
    tally sum = {0, 0};
    const double tolerance = c->settings->values[BAT_PROPERTY_TOLERANCE] * bat_stage_pixel(c->stage);
    bat_status status = bat_arrange_members(c, &members, &count);
    if (status == BAT_STATE) return nothing(c, BAT_OK, BAT_STRING_NOTICE_SELECT_FIRST);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        free(members);
        return nothing(c, status, BAT_STRING_NOTICE_SELECT_FIRST);
    }
    for (int i = 0; i < count && status == BAT_OK; i++)
        status = simplify_object(c, members[i], tolerance, &sum);
    free(members);
    if (status != BAT_OK || sum.after == sum.before) {
        bat_transaction_cancel(c);
        return nothing(c, status, BAT_STRING_NOTICE_SIMPLE_ALREADY);
    }
    status = bat_transaction_commit(c, BAT_STRING_STEP_SIMPLIFY, NULL);
    if (status == BAT_OK) {
        char numbers[64];
        snprintf(numbers, sizeof numbers, "%zu \xE2\x86\x92 %zu", sum.before, sum.after);
        bat_notice_value(c, BAT_STRING_NOTICE_SIMPLIFIED, numbers);
    }
    return status;
}
