#include "editor/edit/symmetry.h"
#include "base/real.h"
#include "editor/edit/mirror.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/view/stage.h"
#include <math.h>

static bool upright_middle(const bat_context *c, bat_mirror *out) {
    double page[4], box[4], size[2], at[2] = {0, 0};
    *out = (bat_mirror){.on = true, .along = {0, 1}};
    bat_document_page(c->session->document, page);
    bat_document_bounds(c->session->document, box);
    if (page[2] > 0) {
        for (int k = 0; k < 2; k++) out->at[k] = page[k] + page[k + 2] / 2;
        return true;
    }
    bat_stage_window(c->stage, size);
    bat_stage_on_page(c->stage, (double[]){size[0] / 2, size[1] / 2}, at);
    for (int k = 0; k < 2; k++) out->at[k] = box[0] <= box[2] ? (box[k] + box[k + 2]) / 2 : at[k];
    return false;
}

bat_mirror bat_symmetry(bat_context *c) {
    return bat_stage_dimension(c->stage) == 2 ? bat_symmetry_plane(c) : (bat_mirror){0};
}

bat_mirror bat_symmetry_plane(bat_context *c) {
    return c->settings->values[BAT_PROPERTY_SYMMETRY] == 0 ? (bat_mirror){0} : bat_symmetry_axis(c);
}

bat_mirror bat_symmetry_axis(bat_context *c) {
    bat_mirror axis = c->session->axis;
    if (!axis.on && !upright_middle(c, &axis) && !c->session->read_only)
        bat_session_set_axis(c->session, &axis); /* out of memory: the same again next time */
    return axis;
}

/* What of a step is mirrored, by the step's label; 0: it acts on the selection, or on no curve. */
static unsigned ways_of(bat_string label) {
    enum { SHAPE = BAT_MIRROR_TWINS | BAT_MIRROR_OWN };
    static const struct {
        bat_string label;
        unsigned ways;
    } rows[] = {{BAT_STRING_STEP_CONVERGE, SHAPE | BAT_MIRROR_JOIN},
                {BAT_STRING_STEP_REFIT, SHAPE},
                {BAT_STRING_STEP_SMOOTH, SHAPE},
                {BAT_STRING_STEP_CALM, SHAPE},
                {BAT_STRING_STEP_SIMPLIFY, SHAPE},
                {BAT_STRING_STEP_ERASE, BAT_MIRROR_TWINS | BAT_MIRROR_GONE | BAT_MIRROR_PIECES},
                {BAT_STRING_STEP_CONTROL_POINT, SHAPE},
                {BAT_STRING_STEP_PULL, SHAPE},
                {BAT_STRING_STEP_KNOT_IN, BAT_MIRROR_TWINS},
                {BAT_STRING_STEP_KNOT_OUT, SHAPE},
                {BAT_STRING_STEP_CORNER, SHAPE},
                {BAT_STRING_STEP_CORNER_OUT, SHAPE},
                {BAT_STRING_STEP_LINE, BAT_MIRROR_TWINS | BAT_MIRROR_FRESH},
                {BAT_STRING_STEP_SPLINE, BAT_MIRROR_TWINS | BAT_MIRROR_FRESH},
                {BAT_STRING_STEP_POINT, BAT_MIRROR_TWINS},
                {BAT_STRING_STEP_MOVE_POINT, BAT_MIRROR_TWINS},
                {BAT_STRING_STEP_DIRECTION, BAT_MIRROR_TWINS},
                {BAT_STRING_STEP_SPLINE_MODE, BAT_MIRROR_TWINS},
                {BAT_STRING_STEP_INSERT_POINT, BAT_MIRROR_TWINS},
                {BAT_STRING_STEP_DELETE_POINT, BAT_MIRROR_TWINS},
                {BAT_STRING_STEP_CLOSE, BAT_MIRROR_TWINS},
                {BAT_STRING_STEP_LEVEL_POINT, BAT_MIRROR_TWINS},
                {BAT_STRING_STEP_LEVEL_PULL, BAT_MIRROR_TWINS},
                {BAT_STRING_STEP_GAIN, BAT_MIRROR_TWINS},
                {BAT_STRING_STEP_MUTE, BAT_MIRROR_TWINS},
                {BAT_STRING_STEP_SOLO, BAT_MIRROR_TWINS}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (rows[i].label == label) return rows[i].ways;
    return 0;
}

bat_status bat_symmetry_finish(bat_context *c, bat_string label) {
    const unsigned ways = ways_of(label);
    const bat_mirror axis = ways ? bat_symmetry(c) : (bat_mirror){0};
    const double pixel = bat_stage_pixel(c->stage);
    if (!axis.on) return BAT_OK;
    return bat_mirror_changes(c, &axis, ways, pixel, c->settings->values[BAT_PROPERTY_TOLERANCE] * pixel);
}

bool bat_symmetry_line(const bat_curve *curve, double within, bat_mirror *out) {
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
