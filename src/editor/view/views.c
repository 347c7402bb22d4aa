#include "editor/view/views.h"
#include "base/real.h"
#include "editor/view/room.h"
#include <math.h>
#include <string.h>

void bat_views_leave(bat_views *views, const bat_view *view) {
    if (view->tilt == 0) {
        views->home = *view;
        views->away = true;
    }
    if (views->count == BAT_VIEWS_KEPT) {
        views->count--;
        memmove(views->left, views->left + 1, (size_t)views->count * sizeof *views->left);
    }
    views->left[views->count++] = *view;
}

static void look(bat_view *view, const bat_view *at) {
    const bat_view was = *view;
    *view = *at;
    view->width = was.width;
    view->height = was.height;
    view->ratio = was.ratio;
    view->fit_wanted = was.fit_wanted;
    view->fov = was.fov;
}

bool bat_views_back(bat_views *views, bat_view *view) {
    if (!views->count) return false;
    look(view, &views->left[--views->count]);
    return true;
}

bool bat_views_home(bat_views *views, bat_view *view) {
    if (!views->away) return false;
    look(view, &views->home);
    return true;
}

void bat_views_jump(bat_views *views, const bat_view *from, const bat_view *view) {
    views->from = *from;
    views->to = *view;
    views->gliding = true;
    views->jumps++;
}

void bat_views_arrive(bat_views *views, bat_view *view) {
    if (views->gliding) look(view, &views->to);
    views->gliding = false;
}

/* The pixel at which a view shows a point; one behind the eye has none, *pixel stays. */
static void pixel_of(const bat_view *view, const double point[3], double pixel[2]) {
    double map[BAT_MAP_NUMBERS], at[2];
    bat_view_map(view, map);
    if (!bat_map_look(map, 3, point, at)) bat_view_to_document(view, pixel, at);
    bat_view_to_screen(view, at, pixel);
}

void bat_views_glide(bat_views *views, bat_view *view, double share) {
    const bat_view *from = &views->from, *to = &views->to;
    if (!views->gliding) return;
    if (!(share < 1)) {
        bat_views_arrive(views, view);
        return;
    }
    /* With a roll, by the room of a wall, in which what is upright stays so. */
    const bool wall = from->roll != 0 || to->roll != 0;
    const bat_attitude a = bat_room_attitude(from, wall), b = bat_room_attitude(to, wall);
    const double s = fmax(share, 0);
    const bat_attitude pose = {a.turn + s * remainder(b.turn - a.turn, 360), a.tilt + s * (b.tilt - a.tilt),
                               a.roll + s * remainder(b.roll - a.roll, 360)};
    bat_view between = *to;
    double start[2] = {from->width / 2, from->height / 2}, end[2] = {start[0], start[1]}, pixel[2];
    memcpy(between.pivot, to->tilt != 0 ? to->pivot : from->pivot, sizeof between.pivot);
    pixel_of(from, between.pivot, start);
    pixel_of(to, between.pivot, end);
    for (int k = 0; k < 2; k++) pixel[k] = start[k] + s * (end[k] - start[k]);
    bat_room_take(&between, wall, &pose);
    between.zoom = from->zoom * bat_exp(s * bat_log(to->zoom / from->zoom));
    bat_view_hold(&between, between.pivot, pixel);
    look(view, &between);
}
