/* The points tool: the curve and the handle that are chosen. */
#include "editor/tools/points/state.h"
#include "curve/curve.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/edit/curves_of.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tools/toolbox.h"

bat_pointing *bat_pointing_of(const bat_context *c) { return bat_toolbox_that(c, BAT_EDITS_POINTS)->state; }

/* The chosen curve; NULL when there is none or it is gone. */
const bat_curve *bat_pointing_curve(const bat_context *c, const bat_pointing *p) {
    return p->object ? bat_edit_target_in(c->session->document, 0, p->object, p->curve) : NULL;
}

bool bat_pointing_is_marked(const bat_pointing *p, int index) {
    return p->marked > 0 && index < p->marks_size && p->marks[index];
}

void bat_pointing_unmark(bat_pointing *p) { p->marked = 0; }

void bat_pointing_choose_nothing(bat_pointing *p) {
    p->chosen = (bat_handle){0};
    p->measured = false;
    bat_pointing_unmark(p);
}

/* Takes over, once, what has been selected elsewhere. */
static void adopt(bat_context *c, bat_pointing *p) {
    if (c->choice->selection.count != 1 || c->choice->selection.ids[0] == p->adopted) return;
    p->object = p->adopted = c->choice->selection.ids[0];
    p->curve = 0;
    bat_pointing_choose_nothing(p);
}

/* Undo and other commands may have removed what was chosen. */
void bat_pointing_settle(bat_context *c, bat_pointing *p) {
    adopt(c, p);
    const bat_curve *curve = bat_pointing_curve(c, p);
    if (!curve || bat_seen_out_of_reach(c, bat_document_find(c->session->document, p->object))) {
        p->object = 0;
        bat_pointing_choose_nothing(p);
        return;
    }
    if (p->chosen.kind == BAT_HANDLE_POINT && p->chosen.index >= bat_point_count(curve))
        bat_pointing_choose_nothing(p);
    if (p->chosen.kind == BAT_HANDLE_KNOT && !bat_knot_held(curve, p->chosen.u))
        bat_pointing_choose_nothing(p);
    if (p->chosen.kind != BAT_HANDLE_KNOT) p->measured = false;
    if (p->chosen.kind != BAT_HANDLE_POINT || p->marks_size != bat_point_count(curve) ||
        !bat_pointing_is_marked(p, p->chosen.index))
        bat_pointing_unmark(p);
}

void bat_pointing_choose_curve(bat_context *c, bat_pointing *p, bat_id object, int curve) {
    if (p->object != object || p->curve != curve) bat_pointing_choose_nothing(p);
    p->object = object;
    p->curve = curve;
    p->adopted = object;
    bat_selection_clear(&c->choice->selection);
    if (object) bat_selection_add(&c->choice->selection, object); /* out of memory: not selected */
}

bool bat_pointing_chosen(bat_context *c, double place[2]) {
    bat_pointing *p = bat_pointing_of(c);
    bat_pointing_settle(c, p);
    const bat_curve *curve = bat_pointing_curve(c, p);
    if (!curve || !p->chosen.kind || bat_curve_dimension(curve) != 2) return false;
    bat_handle_place(curve, &p->chosen, place);
    return true;
}

bat_status bat_pointing_told(bat_context *c, bat_status status) {
    if (status != BAT_OK) bat_notice_failure(c, status);
    return status;
}
