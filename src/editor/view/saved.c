#include "editor/view/saved.h"
#include "base/real.h"
#include "base/vec.h"
#include "document/document.h"
#include "document/nesting.h"
#include "editor/session/notice.h"
#include "editor/view/room.h"
#include "editor/view/stage.h"
#include "editor/view/views.h"
#include <math.h>
#include <string.h>

static const double ALIKE = 0.01; /* pixels: views that differ by less are the same */

void bat_view_look_from(bat_view *view, const bat_viewpoint *from) {
    const vec gaze = vec_sub(vec_load(from->target, 3), vec_load(from->eye, 3));
    const double far = vec_norm(gaze), middle[2] = {view->width / 2, view->height / 2};
    double ahead[3];
    vec_store(gaze, ahead);
    const double high = from->fov > 0 ? 2 * far * bat_tan(from->fov * (BAT_PI / 360)) : from->height;
    const double wide = high / from->size[1] * from->size[0];
    bat_view_look_afresh(view);
    view->fov = from->fov > 0 ? BAT_FOV : 0;
    memcpy(view->pivot, from->target, sizeof view->pivot);
    if (middle[0] > 0 && middle[1] > 0 && isfinite(high))
        view->zoom = fmin(fmax(fmin(view->height / high, view->width / wide), BAT_ZOOM_MIN), BAT_ZOOM_MAX);
    bat_view_look_along(view, ahead, from->up);
    bat_view_hold(view, view->pivot, middle);
}

static bool is_shown(const bat_view *view, const bat_viewpoint *from) {
    bat_view there = *view;
    double middle[2] = {view->width / 2, view->height / 2}, at[2], seen[2];
    bat_view_look_from(&there, from);
    if (there.angle != view->angle || there.tilt != view->tilt || there.roll != view->roll ||
        (view->tilt != 0 && there.fov != view->fov))
        return false;
    const bat_ray mine = bat_view_ray(view, middle), own = bat_view_ray(&there, middle);
    bat_view_to_screen(view, (double[]){0, 0}, seen); /* face-on */
    bat_view_to_screen(&there, (double[]){0, 0}, at);
    double apart = bat_hypot(at[0] - seen[0], at[1] - seen[1]);
    if (view->tilt != 0) {
        const vec way = vec_sub(vec_load(mine.from, 3), vec_load(own.from, 3)),
                  ahead = vec_load(own.along, 3);
        const double deep = vec_dot(way, ahead);
        apart = vec_norm(view->fov > 0 ? way : vec_sub(way, vec_scale(ahead, deep))) * view->zoom;
    }
    return apart <= ALIKE &&
           fabs(there.zoom - view->zoom) * fmax(view->width, view->height) <= ALIKE * view->zoom;
}

int bat_saved_next(const bat_document *document, const bat_view *view, int *shown) {
    int last = -1, before = -1, previous = -1;
    bat_nesting nesting = {0};
    *shown = -1;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        bat_nesting_next(&nesting, object, &level);
        if (level.hidden || !bat_object_view(object)) continue;
        if (is_shown(view, bat_object_view(object))) {
            *shown = i;
            before = previous;
        }
        previous = last = i;
    }
    return *shown < 0 || before < 0 ? last : before;
}

void bat_saved_leave(bat_context *c) {
    bat_views_leave(c->views, &c->stage->view);
    if (c->views->saved) bat_notice_saved_view(c);
    c->views->saved = false;
}
