/* The commands that choose the axis of symmetry. */
#include "base/real.h"
#include "document/kind.h"
#include "editor/choice/choice.h"
#include "curve/mirror.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/commands.h"
#include "editor/tables/settings.h"
#include "editor/view/stage.h"
#include <math.h>

static const double STRAIGHT = 0.5; /* px: greatest deviation from a straight line */

/* The line through both ends of the curve, if the curve is straight between them. */
static bool axis_of(const bat_curve *curve, double within, bat_mirror *out) {
    double ends[2][2], domain[2];
    if (bat_curve_dimension(curve) != 2 || bat_curve_is_closed(curve)) return false;
    bat_curve_domain(curve, domain);
    for (int i = 0; i < 2; i++) bat_curve_eval(curve, domain[i], 0, ends[i]);
    const double x = ends[1][0] - ends[0][0], y = ends[1][1] - ends[0][1], length = bat_hypot(x, y);
    if (!(length > within)) return false;
    *out = (bat_mirror){true, {ends[0][0], ends[0][1]}, {x / length, y / length}};
    for (size_t i = 0; i < bat_curve_count(curve); i++)
        if (fabs(bat_mirror_side(out, bat_curve_points(curve) + 2 * i)) > within) return false;
    return true;
}

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
        !axis_of(bat_object_curve(line, 0), STRAIGHT * bat_stage_pixel(c->stage), &axis)) {
        bat_notice(c, BAT_STRING_NOTICE_AXIS);
        return BAT_STATE;
    }
    return choose(c, &axis);
}

bat_status bat_command_symmetry_origin(bat_context *c, bat_command_id id) {
    (void)id;
    return choose(c, &(bat_mirror){true, {0, 0}, {0, 1}});
}

bat_status bat_command_symmetry_middle(bat_context *c, bat_command_id id) {
    (void)id;
    return choose(c, &(bat_mirror){.on = false});
}
