/* Commands for views that the drawing holds. Going to one changes the window only; saving and forgetting are steps. */
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/show/flight.h"
#include "editor/show/moves.h"
#include "editor/tables/commands.h"
#include "editor/tables/settings.h"
#include "editor/view/saved.h"
#include "editor/view/stage.h"
#include "editor/view/views.h"

/* What is seen, through a camera, too. */
static bat_status seen(const bat_context *c, bat_viewpoint *out) {
    if (c->moves->through && bat_flight_view(c, out)) return BAT_OK;
    return bat_stage_viewpoint(c->stage, out);
}

bat_status bat_command_view_save(bat_context *c, bat_command_id id) {
    const bat_document *document = c->session->document;
    bat_viewpoint view;
    bat_object *object = NULL;
    int shown;
    (void)id;
    if (bat_saved_next(document, &c->stage->view, &shown) == shown && shown >= 0 && !c->moves->through) {
        bat_notice(c, BAT_STRING_NOTICE_VIEW_KNOWN);
        return BAT_STATE;
    }
    bat_status status = seen(c, &view);
    if (status == BAT_OK) status = bat_object_create_view(bat_document_next(document), "", &view, &object);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        status = bat_transaction_insert(c, bat_document_count(document), object);
        status = bat_transaction_end(c, status, BAT_STRING_STEP_VIEW);
    }
    bat_object_release(object);
    if (status == BAT_OK)
        bat_notice(c, BAT_STRING_NOTICE_VIEW_SAVED);
    else
        bat_notice_failure(c, status);
    return status;
}

bat_status bat_command_view_saved(bat_context *c, bat_command_id id) {
    const bat_document *document = c->session->document;
    bat_view *view = &c->stage->view, from = *view;
    int shown;
    const int next = bat_saved_next(document, view, &shown);
    (void)id;
    if (next < 0) {
        bat_notice(c, BAT_STRING_NOTICE_NO_VIEW);
        return BAT_STATE;
    }
    if (next == shown && !c->moves->through) return BAT_STATE;
    const bat_viewpoint *to = bat_object_view(bat_document_at(document, next));
    bat_moves_leave(c);
    bat_views_leave(c->views, view);
    c->views->saved = false;
    bat_view_look_from(view, to);
    if (view->tilt != 0)
        c->settings->values[BAT_PROPERTY_PERSPECTIVE] = view->fov > 0;
    else
        view->fov = from.fov;
    bat_views_jump(c->views, &from, view);
    return BAT_OK;
}

/* The one that is shown, or else the last. */
bat_status bat_command_view_forget(bat_context *c, bat_command_id id) {
    int shown;
    const int next = bat_saved_next(c->session->document, &c->stage->view, &shown);
    (void)id;
    if (next < 0) {
        bat_notice(c, BAT_STRING_NOTICE_NO_VIEW);
        return BAT_STATE;
    }
    bat_status status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        status = bat_transaction_remove(c, shown < 0 ? next : shown);
        status = bat_transaction_end(c, status, BAT_STRING_STEP_VIEW_FORGET);
    }
    if (status != BAT_OK) bat_notice_failure(c, status);
    return status;
}
