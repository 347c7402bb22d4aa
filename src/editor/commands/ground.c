/* The commands that choose what the pen draws on. */
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/pick/pivot.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/commands.h"
#include "editor/tables/words.h"
#include "editor/view/curve_ground.h"
#include "editor/view/stage.h"

/* The next object in the drawing, after the present ground, that can be drawn on, or the first; none in a hidden
 * layer. */
static const bat_object *next_ground(const bat_context *c, bat_ground *out) {
    const bat_document *document = c->session->document;
    int now = c->stage->ground.object ? bat_document_find(document, c->stage->ground.object) : -1;
    int count = bat_document_count(document);
    for (int i = 1; i <= count; i++) {
        int at = (now + i) % count;
        const bat_object *object = bat_document_at(document, at);
        if (!bat_document_level(document, at).hidden && bat_ground_of(object, out)) return object;
    }
    return NULL;
}

static void draw_on(bat_context *c, const bat_object *plane) {
    const char *name = bat_object_name(plane);
    bat_notice_value(c, BAT_STRING_NOTICE_ON_PLANE, *name ? name : bat_word(c, BAT_STRING_A_PLANE));
}

/* A new plane to draw on. */
static bat_status draw_on_new(bat_context *c, const double origin[3], const double axes[6]) {
    bat_object *plane = NULL;
    bat_status status = bat_object_create_plane(bat_document_next(c->session->document), "", origin, axes,
                                                &plane);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        status = bat_transaction_insert(c, bat_document_count(c->session->document), plane);
        status = bat_transaction_end(c, status, BAT_STRING_STEP_PLANE);
    }
    if (status == BAT_OK && bat_ground_of(plane, &c->stage->ground))
        draw_on(c, plane);
    else
        bat_notice_failure(c, status);
    bat_object_release(plane);
    return status;
}

/* Through the view's pivot, at right angles to the gaze. */
bat_status bat_command_plane_facing(bat_context *c, bat_command_id id) {
    double axes[9];
    (void)id;
    bat_pivot_set(c, NULL);
    bat_view_axes(&c->stage->view, axes, axes + 3, axes + 6);
    return draw_on_new(c, c->stage->view.pivot, axes);
}

/* The first of the selected curves that lies in a plane gives it. */
bat_status bat_command_plane_of_curve(bat_context *c, bat_command_id id) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    bat_ground ground;
    (void)id;
    for (int i = 0; i < selection->count; i++) {
        const bat_object *object = bat_document_at(document, bat_document_find(document, selection->ids[i]));
        for (int j = 0; j < bat_object_curve_count(object); j++) {
            const bat_curve *curve = bat_object_curve(object, j);
            if (bat_curve_dimension(curve) == 3 && bat_ground_of_planar(curve, &ground))
                return draw_on_new(c, ground.numbers, ground.numbers + 3);
        }
    }
    bat_notice(c, BAT_STRING_NOTICE_SELECT_PLANAR);
    return BAT_STATE;
}

bat_status bat_command_draw_on(bat_context *c, bat_command_id id) {
    if (id == BAT_COMMAND_DRAW_ON_PAGE) {
        if (!c->stage->ground.object) return BAT_STATE;
        c->stage->ground = bat_ground_page();
        bat_notice(c, BAT_STRING_NOTICE_ON_PAGE);
        return BAT_OK;
    }
    const bat_object *ground = next_ground(c, &c->stage->ground);
    if (!ground) {
        bat_notice(c, BAT_STRING_NOTICE_NO_PLANE);
        return BAT_STATE;
    }
    draw_on(c, ground);
    return BAT_OK;
}
