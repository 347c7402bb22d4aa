/* The commands that choose the axis of symmetry, or mirror about a line. */
#include "document/kind.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "curve/mirror.h"
#include "editor/choice/selection.h"
#include "editor/edit/arrange.h"
#include "editor/edit/symmetry.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/commands.h"
#include "editor/tables/settings.h"
#include "editor/view/stage.h"
#include <math.h>

static const double STRAIGHT = 0.5; /* px: greatest deviation from a straight line */

static bat_status choose(bat_context *c, const bat_mirror *axis) {
    bat_status status = bat_session_set_axis(c->session, axis);
    if (status != BAT_OK) {
        bat_notice_failure(c, status);
        return status;
    }
    c->settings->values[BAT_PROPERTY_SYMMETRY] = 1;
    bat_notice(c, BAT_STRING_COUNT);
    return BAT_OK;
}

bat_status bat_command_symmetry_axis(bat_context *c, bat_command_id id) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    bat_mirror axis;
    (void)id;
    const bat_object *line = selection->count == 1
                                 ? bat_document_at(document, bat_document_find(document, selection->ids[0]))
                                 : NULL;
    if (!line || !bat_object_is(line, BAT_CURVES) || bat_object_curve_count(line) != 1 ||
        !bat_symmetry_line(bat_object_curve(line, 0), STRAIGHT * bat_stage_pixel(c->stage), &axis)) {
        bat_notice(c, BAT_STRING_NOTICE_AXIS);
        return BAT_STATE;
    }
    return choose(c, &axis);
}

/* The frontmost straight line of the selection, as an axis; 0: there is none. */
static bat_id line_among(const bat_context *c, bat_mirror *axis) {
    const bat_document *document = c->session->document;
    for (int i = bat_document_count(document) - 1; i >= 0; i--) {
        const bat_object *object = bat_document_at(document, i);
        if (bat_selection_has(&c->choice->selection, bat_object_id(object)) &&
            bat_object_is_one_curve(object) &&
            bat_symmetry_line(bat_object_curve(object, 0), STRAIGHT * bat_stage_pixel(c->stage), axis))
            return bat_object_id(object);
    }
    return 0;
}

bat_status bat_command_mirror_line(bat_context *c, bat_command_id id) {
    bat_selection *selection = &c->choice->selection;
    bat_mirror axis;
    double matrix[6];
    (void)id;
    const bat_id line = selection->count > 1 ? line_among(c, &axis) : 0;
    if (!line) {
        bat_notice(c, BAT_STRING_NOTICE_SELECT_MIRROR);
        return BAT_STATE;
    }
    bat_selection_remove(selection, line);
    bat_mirror_matrix(&axis, matrix);
    const bat_status status = bat_arrange_transform(c, matrix, BAT_STRING_STEP_MIRROR);
    bat_selection_add(selection, line); /* there is room: it was there */
    return status;
}

bat_status bat_command_symmetry_origin(bat_context *c, bat_command_id id) {
    (void)id;
    return choose(c, &(bat_mirror){true, {0, 0}, {0, 1}});
}

bat_status bat_command_symmetry_middle(bat_context *c, bat_command_id id) {
    (void)id;
    return choose(c, &(bat_mirror){.on = false});
}
