/* The command that lets a skeleton go along a curve of the drawing. */
#include "editor/commands/body.h"
#include "document/document.h"
#include "document/kind.h"
#include "editor/choice/choice.h"
#include "editor/edit/arrange.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/commands.h"
#include <batten/motion.h>

/* The skeleton that is selected, and the object beside it in the selection, whose first curve can be a path; NULL: none. */
static const bat_object *body_of(const bat_context *c, const bat_object **path) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    const bat_object *body = NULL;
    *path = NULL;
    for (int i = 0; i < selection->count && selection->count <= 2; i++) {
        const bat_object *object = bat_document_at(document, bat_document_find(document, selection->ids[i]));
        if (object && bat_object_motion(object, NULL)) body = object;
        if (object && bat_object_is_made_of_curves(object) && bat_object_leads(object)) *path = object;
    }
    return body && selection->count == (*path ? 2 : 1) ? body : NULL;
}

bool bat_command_body_path_fits(const bat_context *c) {
    const bat_object *path, *body = body_of(c, &path);
    if (!body || !bat_motion_path(bat_object_motion(body, NULL))) return false;
    return path ? bat_object_followed(body) != bat_object_id(path) : !bat_object_followed(body);
}

/* The coarsest level of where its root goes, in the drawing. */
static bat_status lay_out(bat_context *c, const bat_object *body, bat_object **out) {
    const bat_style style = bat_style_defaults();
    double place[12];
    bat_curve *curve = NULL;
    const bat_shape *path = bat_motion_path(bat_object_motion(body, place));
    bat_status status = bat_curve_transform(bat_shape_curve(path, 0), place, &curve);
    if (status != BAT_OK) return status;
    return bat_object_create_path(bat_document_new_id(c->session->document), "", &style, 1, &curve, out);
}

static bat_status lead(bat_context *c, const bat_object *body, const bat_object *path, bat_id *chosen) {
    bat_object *made = NULL, *led = NULL;
    bat_status status = path ? BAT_OK : lay_out(c, body, &made);
    if (status == BAT_OK && !path) status = bat_arrange_insert(c, made);
    const bat_object *from = path ? path : made;
    if (status == BAT_OK) {
        *chosen = bat_object_id(from);
        status = bat_object_type(body)->follow(body, *chosen, bat_object_curve(from, 0), &led);
    }
    if (status == BAT_OK && (!led || bat_object_followed(led) == 0)) status = BAT_UNSUPPORTED;
    if (status == BAT_OK)
        status = bat_transaction_replace(c, bat_document_find(c->session->document, bat_object_id(body)),
                                         led);
    bat_object_release(made), bat_object_release(led);
    return status;
}

bat_status bat_command_body_path(bat_context *c, bat_command_id id) {
    const bat_object *path, *body = body_of(c, &path);
    bat_id chosen = 0;
    (void)id;
    if (!bat_command_body_path_fits(c)) {
        bat_notice(c, BAT_STRING_NOTICE_SELECT_BODY);
        return BAT_STATE;
    }
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    const bat_status done = lead(c, body, path, &chosen);
    if (done == BAT_UNSUPPORTED) {
        bat_transaction_cancel(c);
        bat_notice(c, BAT_STRING_NOTICE_NO_BODY_PATH);
        return BAT_STATE;
    }
    status = bat_transaction_end(c, done, BAT_STRING_STEP_BODY_PATH);
    if (status != BAT_OK) {
        bat_notice_failure(c, status);
        return status;
    }
    bat_selection_clear(&c->choice->selection);
    bat_selection_add(&c->choice->selection, chosen); /* out of memory: not selected */
    return BAT_OK;
}
