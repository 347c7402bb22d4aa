/* The points tool on the keyboard: its commands. */
#include "editor/tools/points/state.h"
#include "curve/curve.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/edit/curves_of.h"
#include "editor/scene/seen.h"
#include "editor/session/session.h"
#include <math.h>

static bat_status step(bat_context *c, bat_pointing *p, int direction) {
    const bat_curve *curve = bat_pointing_curve(c, p);
    if (!curve) { /* the selected curve, else the first curve */
        bat_seen_sync(c);
        for (int pass = 0; pass < 2 && !curve; pass++)
            for (int i = 0; i < bat_document_count(c->session->document) && !curve; i++) {
                bat_id id = bat_object_id(bat_document_at(c->session->document, i));
                if (pass == 0 && !bat_selection_has(&c->choice->selection, id)) continue;
                if (bat_seen_out_of_reach(c, i)) continue;
                if (!(curve = bat_edit_target_in(c->session->document, 0, id, 0))) continue;
                bat_pointing_choose_curve(c, p, id, 0);
            }
        if (!curve) return BAT_STATE;
        bat_pointing_choose_nothing(p);
    }
    int count = bat_point_count(curve), at = direction > 0 ? 0 : count - 1;
    if (p->chosen.kind == BAT_HANDLE_POINT) at = p->chosen.index + direction;
    if (at < 0 || at >= count) { /* the keyboard focus moves on to what follows the drawing */
        bat_pointing_choose_nothing(p);
        return BAT_STATE;
    }
    bat_pointing_unmark(p);
    p->chosen = (bat_handle){BAT_HANDLE_POINT, p->object, p->curve, at, bat_handle_greville(curve, at)};
    p->measured = false;
    return BAT_OK;
}

static bat_status step_knot(bat_context *c, bat_pointing *p, int direction) {
    const bat_curve *curve = bat_pointing_curve(c, p);
    if (!curve) return step(c, p, direction);
    double u, best = 0, from = p->chosen.kind ? p->chosen.u : direction > 0 ? -INFINITY : INFINITY;
    bool found = false;
    for (double after = -INFINITY; bat_knot_next(curve, after, &u, NULL); after = u) {
        if (direction > 0 ? u <= from || found : u >= from) continue;
        best = u;
        found = true;
    }
    if (!found) return BAT_STATE;
    bat_pointing_unmark(p);
    p->chosen = (bat_handle){BAT_HANDLE_KNOT, p->object, p->curve, 0, best};
    p->measured = false;
    return BAT_OK;
}

bat_status bat_pointing_command(bat_context *c, void *state, bat_command_id id) {
    bat_pointing *p = state;
    bat_pointing_settle(c, p);
    switch (id) {
    case BAT_COMMAND_POINT_NEXT: return step(c, p, 1);
    case BAT_COMMAND_POINT_PREVIOUS: return step(c, p, -1);
    case BAT_COMMAND_KNOT_NEXT: return step_knot(c, p, 1);
    case BAT_COMMAND_KNOT_PREVIOUS: return step_knot(c, p, -1);
    case BAT_COMMAND_POINT_ADD: return bat_pointing_insert_knot(c, p);
    case BAT_COMMAND_POINT_DELETE: return bat_pointing_delete_knot(c, p);
    case BAT_COMMAND_CORNER_MAKE: return bat_pointing_make_corner(c, p);
    case BAT_COMMAND_CORNER_SMOOTH: return bat_pointing_smooth_corner(c, p);
    case BAT_COMMAND_NUDGE_LEFT: return bat_pointing_nudge(c, -1, 0);
    case BAT_COMMAND_NUDGE_RIGHT: return bat_pointing_nudge(c, 1, 0);
    case BAT_COMMAND_NUDGE_UP: return bat_pointing_nudge(c, 0, -1);
    case BAT_COMMAND_NUDGE_DOWN: return bat_pointing_nudge(c, 0, 1);
    case BAT_COMMAND_ALIGN_LEFT:
    case BAT_COMMAND_ALIGN_CENTRE:
    case BAT_COMMAND_ALIGN_RIGHT:
    case BAT_COMMAND_ALIGN_TOP:
    case BAT_COMMAND_ALIGN_MIDDLE:
    case BAT_COMMAND_ALIGN_BOTTOM:
    case BAT_COMMAND_DISTRIBUTE_ACROSS:
    case BAT_COMMAND_DISTRIBUTE_DOWN: return bat_pointing_line_up(c, p, id);
    default: return BAT_STATE;
    }
}
