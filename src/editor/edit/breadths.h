/* The stops of the width along a stroke, as they are edited by hand: those that an object has, or those that it would have. */
#ifndef BATTEN_EDITOR_EDIT_BREADTHS_H
#define BATTEN_EDITOR_EDIT_BREADTHS_H

#include "editor/session/context.h"
#include <batten/paint.h>

typedef struct bat_breadths {
    bool closed;
    size_t count;
    bat_width_stop stops[BAT_WIDTHS_MAX];
} bat_breadths;

/* Whether its strokes can change their width along them: planar curves, stroked by a round pen, without dashes. */
bool bat_breadths_fit(const bat_object *object);
/* Its stops; without a profile an open curve has one at each end, a closed one none. */
void bat_breadths_load(const bat_object *object, bool closed, bat_breadths *out);
/* The share at a place 0..1. */
double bat_breadths_at(const bat_breadths *breadths, double at);
/* A stop with the share that is there; where a closed curve has none, a second stands opposite. Its index; -1: no room. */
int bat_breadths_add(bat_breadths *breadths, double at);
/* Takes a stop to another place, between its neighbours; along a closed curve also past the seam. Its index then. */
int bat_breadths_slide(bat_breadths *breadths, int index, double at);
/* Within a transaction: gives stops to the object, which keeps none where all are as wide as its style says. BAT_STATE: it is gone. */
bat_status bat_breadths_put(bat_context *c, bat_id object, size_t count, const bat_width_stop *stops);

#endif
