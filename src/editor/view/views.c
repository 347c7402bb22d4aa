#include "editor/view/views.h"
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
