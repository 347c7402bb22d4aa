/* The tubes of reach of the wires that are selected, or that something selected is bound to. */
#ifndef BATTEN_EDITOR_SHOW_TUBES_H
#define BATTEN_EDITOR_SHOW_TUBES_H

#include "editor/show/overlay.h"
#include "editor/session/context.h"
#include "form/wire/stops.h"

#include <batten/document.h>

typedef struct bat_tube {
    bat_id curve;         /* whose first curve the wire is */
    const bat_curve *now; /* that curve */
    const bat_wire *wire; /* as something is bound to it */
} bat_tube;

/* Each wire once; returns how many. Borrowed until the document changes. */
int bat_tubes_of(const bat_context *c, bat_tube out[BAT_BOUND_WIRES]);
/* Where a place along the tube is seen: its axis, the way across (of length 1), and how far a unit of length is there, in
 * drawing coordinates. at: 0 to 1. False: behind the eye. */
typedef struct bat_tube_place {
    double at[2], across[2], scale;
} bat_tube_place;
bool bat_tube_look(const bat_context *c, const bat_tube *tube, double at, bat_tube_place *out);
double bat_tube_radius(const bat_tube *tube, double at);
/* Adds the object's torn edges, where it now is, in red; returns how many there are. */
size_t bat_torn_show(const bat_context *c, const bat_object *object, bat_overlay *overlay);
/* Shows them: translucent, their walls, handles at their stops, torn edges in red. held: the wire whose stop is dragged (its
 * radius is then shown), or 0. */
void bat_tubes_show(const bat_context *c, bat_id held, int stop, bat_overlay *overlay);

#endif
