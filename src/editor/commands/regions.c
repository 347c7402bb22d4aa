/* Commands that make one object of the regions that several bound: unite, subtract, intersect, exclude. */
#include "base/box.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/edit/arrange.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/commands.h"
#include "editor/tables/tables.h"

#include <batten/region.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of the larger side of all boxes. */
static const double TOLERANCE_SHARE = 1e-6;

static const struct {
    bat_command_id command;
    bat_region_operation operation;
    bat_string label;
} operations[] = {
    {BAT_COMMAND_REGION_UNITE, BAT_REGION_UNION, BAT_STRING_STEP_REGION_UNITE},
    {BAT_COMMAND_REGION_SUBTRACT, BAT_REGION_DIFFERENCE, BAT_STRING_STEP_REGION_SUBTRACT},
    {BAT_COMMAND_REGION_INTERSECT, BAT_REGION_INTERSECTION, BAT_STRING_STEP_REGION_INTERSECT},
    {BAT_COMMAND_REGION_EXCLUDE, BAT_REGION_EXCLUSION, BAT_STRING_STEP_REGION_EXCLUDE},
};

/* The selected objects that bound regions, lowest first, with their curves; free releases both arrays. */
typedef struct bounded {
    int count, *members; /* document indices */
    bat_region *regions;
    const bat_curve **curves;
    double tolerance;
} bounded;

static bool bounds(const bat_object *object) {
    for (int i = 0; i < bat_object_curve_count(object); i++) {
        const bat_curve *curve = bat_object_curve(object, i);
        if (!bat_curve_is_closed(curve) || bat_curve_dimension(curve) != 2) return false;
    }
    return bat_object_is_made_of_curves(object) && bat_object_curve_count(object) > 0;
}

static void clear(bounded *b) { free(b->members), free(b->regions), free(b->curves); }

/* BAT_STATE: something of the selection bounds none, or there are not two. */
static bat_status gather(const bat_context *c, bounded *b) {
    const bat_document *document = c->session->document;
    bat_status status = bat_arrange_members(c, &b->members, &b->count);
    if (status != BAT_OK) return status;
    size_t total = 0;
    double all[4];
    bat_box_nothing(all);
    for (int i = 0; i < b->count; i++) {
        const bat_object *object = bat_document_at(document, b->members[i]);
        double box[4];
        if (!bounds(object)) return BAT_STATE;
        total += (size_t)bat_object_curve_count(object);
        bat_object_bounds(object, box);
        bat_box_hold(all, box);
    }
    if (b->count < 2) return BAT_STATE;
    b->regions = calloc((size_t)b->count, sizeof *b->regions);
    b->curves = malloc(total * sizeof *b->curves);
    if (!b->regions || !b->curves) return BAT_MEMORY;
    size_t at = 0;
    for (int i = 0; i < b->count; i++) {
        const bat_object *object = bat_document_at(document, b->members[i]);
        const int count = bat_object_curve_count(object);
        b->regions[i] = (bat_region){(size_t)count, b->curves + at, bat_object_style(object)->even_odd};
        for (int k = 0; k < count; k++) b->curves[at++] = bat_object_curve(object, k);
    }
    b->tolerance = TOLERANCE_SHARE * fmax(all[2] - all[0], all[3] - all[1]);
    return b->tolerance > 0 ? BAT_OK : BAT_STATE;
}

/* The lowest object becomes what the curves bound; the others go. */
static bat_status put(bat_context *c, const bounded *b, size_t count, bat_curve *const *curves) {
    bat_object *made = NULL;
    bat_status status = bat_object_with_curves(bat_document_at(c->session->document, b->members[0]),
                                               (int)count, curves, &made);
    for (int i = b->count - 1; i > 0 && status == BAT_OK; i--)
        status = bat_transaction_remove(c, b->members[i]);
    if (status == BAT_OK) status = bat_transaction_replace(c, b->members[0], made);
    bat_object_release(made);
    return status;
}

bat_status bat_command_region(bat_context *c, bat_command_id id) {
    bounded b = {0};
    size_t kind = 0, count = 0;
    bat_curve **curves = NULL;
    while (operations[kind].command != id) kind++;
    bat_status status = gather(c, &b);
    if (status == BAT_OK)
        status = bat_regions_combine(operations[kind].operation, (size_t)b.count, b.regions, b.tolerance,
                                     &count, &curves);
    bat_string why = status == BAT_STATE ? BAT_STRING_NOTICE_SELECT_REGIONS : BAT_STRING_COUNT;
    if (status == BAT_OK && count == 0) why = BAT_STRING_NOTICE_REGION_EMPTY;
    const bool go = status == BAT_OK && count > 0;
    if (go) {
        status = bat_transaction_begin(c);
        if (status == BAT_OK) {
            status = put(c, &b, count, curves);
            memset(curves, 0, count * sizeof *curves); /* they are the object's, or gone */
        }
    }
    bat_curves_free(count, curves);
    clear(&b);
    if (go && status == BAT_OK) return bat_transaction_commit(c, operations[kind].label, NULL);
    if (go) bat_transaction_cancel(c);
    return bat_notice_refuse(c, status, why);
}
