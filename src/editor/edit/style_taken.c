/* The style of one object for others. */
#include "base/vec.h"
#include "document/paint.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/edit/arrange.h"
#include "editor/edit/style.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"

#include <batten/paint.h>

#include <stdlib.h>

/* The map of one object's box onto another's; where one has no extent, the middles are put together. */
static void box_to_box(const bat_object *from, const bat_object *to, double matrix[6]) {
    double a[4], b[4], scale[2];
    bat_object_bounds(from, a);
    bat_object_bounds(to, b);
    for (int k = 0; k < 2; k++) {
        const double wide = a[k + 2] - a[k], now = b[k + 2] - b[k];
        scale[k] = wide > 0 && now > 0 ? now / wide : 1;
        matrix[4 + k] = (b[k] + b[k + 2]) / 2 - scale[k] * (a[k] + a[k + 2]) / 2;
    }
    matrix[0] = scale[0], matrix[1] = 0, matrix[2] = 0, matrix[3] = scale[1];
}

static bat_status dressed(const bat_object *object, const bat_object *from, bat_object **out) {
    bat_style style = *bat_object_style(from);
    style.even_odd = bat_object_style(object)->even_odd; /* how its curves lie within each other is its own */
    bat_object *styled = NULL;
    bat_status status = bat_object_with_style(object, &style, &styled);
    if (status != BAT_OK || !bat_object_is_made_of_curves(object)) {
        *out = styled;
        return status;
    }
    const bat_paint *paint = bat_object_paint(from);
    bat_paint mapped = {0};
    double matrix[6], dashes[BAT_DASHES_MAX];
    if (paint) {
        box_to_box(from, object, matrix);
        mapped = bat_paint_mapped(paint, matrix, 1, dashes);
        for (int k = 0; k < 4; k++) mapped.pen[k] = paint->pen[k];
    }
    status = bat_object_with_paint(styled, &mapped, out);
    bat_object_release(styled);
    return status;
}

static bat_status give(bat_context *c, int index, const bat_object *from) {
    const bat_object *object = bat_document_at(c->session->document, index);
    bat_object *after = NULL;
    if (bat_object_id(object) == bat_object_id(from)) return BAT_OK;
    bat_status status = dressed(object, from, &after);
    if (status == BAT_OK) status = bat_transaction_replace(c, index, after);
    bat_object_release(after);
    return status;
}

bat_status bat_styling_take(bat_context *c, const bat_object *from) {
    bat_object *kept = bat_object_retain(from);
    int *members = NULL, count = 0;
    for (int i = 0; i < BAT_PROPERTY_COUNT; i++)
        if (bat_property_at((bat_property_id)i)->group == BAT_GROUP_STYLE && i != BAT_PROPERTY_DASHES &&
            i != BAT_PROPERTY_WIDTHS && i != BAT_PROPERTY_FILL_RULE)
            c->settings->values[i] = bat_styling_value(bat_object_style(from), (bat_property_id)i);
    const bat_dashing dashes = bat_dashing_of(from);
    c->settings->values[BAT_PROPERTY_DASHES] = dashes == BAT_DASHING_OTHER ? BAT_DASHING_SOLID : dashes;
    bat_status status = bat_arrange_members(c, &members, &count);
    if (status == BAT_OK) {
        status = bat_transaction_begin(c);
        for (int i = 0; i < count && status == BAT_OK; i++) status = give(c, members[i], kept);
        status = bat_transaction_end(c, status, BAT_STRING_STEP_EYEDROPPER);
    } else if (status == BAT_STATE) {
        status = BAT_OK; /* the pen alone */
    }
    free(members);
    bat_object_release(kept);
    return status;
}
