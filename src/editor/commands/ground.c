/* The commands that choose what the pen draws on. */
#include "editor/commands/ground.h"
#include "base/vec.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/input/input.h"
#include "editor/pick/front.h"
#include "editor/pick/pivot.h"
#include "editor/pick/surface.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/commands.h"
#include "editor/view/curve_ground.h"
#include "editor/view/room.h"
#include "editor/view/stage.h"
#include <string.h>

/* The next plane in the drawing, after the present ground, or the first; none in a hidden layer. */
static const bat_object *next_plane(const bat_context *c) {
    const bat_document *document = c->session->document;
    int now = c->stage->ground.object ? bat_document_find(document, c->stage->ground.object) : -1;
    int count = bat_document_count(document);
    bat_ground ground;
    for (int i = 1; i <= count; i++) {
        int at = (now + i) % count;
        const bat_object *object = bat_document_at(document, at);
        if (!bat_document_level(document, at).hidden && bat_ground_of(object, &ground) &&
            !bat_ground_bounded(&ground))
            return object;
    }
    return NULL;
}

/* The surface under the pen, or the one that is selected. */
static const bat_object *meant_surface(bat_context *c) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    const bat_object *found = c->input->pen_near ? bat_pick_surface(c, c->input->pen) : NULL;
    if (found || selection->count != 1) return found;
    found = bat_document_at(document, bat_document_find(document, selection->ids[0]));
    return found && bat_object_surface(found) ? found : NULL;
}

/* A plane of the drawing that lies as this one does; none that is hidden. */
static const bat_object *same_plane(const bat_context *c, const bat_object *plane) {
    const bat_document *document = c->session->document;
    bat_ground wanted, found;
    if (!bat_ground_of(plane, &wanted)) return NULL;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        if (bat_ground_of(object, &found) && bat_ground_same(&found, &wanted) &&
            !bat_document_level(document, i).hidden)
            return object;
    }
    return NULL;
}

bat_status bat_ground_draw_on(bat_context *c, const double origin[3], const double axes[6]) {
    bat_object *plane = NULL;
    bat_status status = bat_object_create_plane(bat_document_next(c->session->document), "", origin, axes,
                                                &plane);
    const bat_object *known = status == BAT_OK ? same_plane(c, plane) : NULL;
    if (!known && status == BAT_OK) status = bat_transaction_begin(c);
    if (!known && status == BAT_OK) {
        status = bat_transaction_insert(c, bat_document_count(c->session->document), plane);
        status = bat_transaction_end(c, status, BAT_STRING_STEP_PLANE);
    }
    if (status != BAT_OK || !bat_ground_take(c, known ? known : plane)) bat_notice_failure(c, status);
    bat_object_release(plane);
    return status;
}

/* Along two axes of the room, through the view's pivot; as the page lies and where it lies it is the page. */
bat_status bat_command_plane_named(bat_context *c, bat_command_id id) {
    const bool wall = bat_room_is_wall(c->session->document);
    const int across = id == BAT_COMMAND_PLANE_SIDE ? 1 : 0, along = id == BAT_COMMAND_PLANE_LEVEL ? 1 : 2;
    double room[9], axes[6];
    bat_pivot_set(c, NULL);
    const double *origin = c->stage->view.pivot;
    if (id == (wall ? BAT_COMMAND_PLANE_FRONT : BAT_COMMAND_PLANE_LEVEL) && origin[2] == 0) {
        bat_ground_take(c, NULL);
        return BAT_OK;
    }
    bat_room_axes(wall, room);
    memcpy(axes, room + 3 * across, 3 * sizeof *axes);
    memcpy(axes + 3, room + 3 * along, 3 * sizeof *axes);
    return bat_ground_draw_on(c, origin, axes);
}

/* Through the view's pivot, at right angles to the gaze. */
bat_status bat_command_plane_facing(bat_context *c, bat_command_id id) {
    double axes[9];
    (void)id;
    bat_pivot_set(c, NULL);
    bat_view_axes(&c->stage->view, axes, axes + 3, axes + 6);
    return bat_ground_draw_on(c, c->stage->view.pivot, axes);
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
                return bat_ground_draw_on(c, ground.numbers, ground.numbers + 3);
        }
    }
    bat_notice(c, BAT_STRING_NOTICE_SELECT_PLANAR);
    return BAT_STATE;
}

/* On the plane of a mesh's face. */
static bat_status draw_on_face(bat_context *c, const double at[3], const double normal[3]) {
    double axes[6];
    const vec n = vec_load(normal, 3), across = vec_any_normal(n);
    vec_store(across, axes);
    vec_store(vec_cross(n, across), axes + 3);
    return bat_ground_draw_on(c, at, axes);
}

bat_status bat_command_draw_on(bat_context *c, bat_command_id id) {
    if (id == BAT_COMMAND_DRAW_ON_PAGE) {
        if (bat_stage_dimension(c->stage) == 2) return BAT_STATE;
        bat_ground_take(c, NULL);
        return BAT_OK;
    }
    double at[3], normal[3];
    if (c->input->pen_near && bat_pick_face(c, c->input->pen, at, normal)) return draw_on_face(c, at, normal);
    const bat_object *ground = meant_surface(c);
    if (!ground) ground = next_plane(c);
    if (ground && bat_ground_take(c, ground)) return BAT_OK;
    bat_notice(c, BAT_STRING_NOTICE_NO_PLANE);
    return BAT_STATE;
}
