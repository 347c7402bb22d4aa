/* One change of each selected object that allows it, as one step. */
#ifndef BATTEN_EDITOR_EDIT_EACH_H
#define BATTEN_EDITOR_EDIT_EACH_H

#include "editor/session/session.h"

typedef bool bat_each_fits(const bat_object *object);
typedef bat_status bat_each_made(const bat_object *object, bat_object **out);

/* Whether any of the selected objects fits. */
bool bat_each_any(const bat_context *c, bat_each_fits *fits);
/* Replaces those that fit; the others stay. BAT_STATE: none fits. */
bat_status bat_each_replace(bat_context *c, bat_each_fits *fits, bat_each_made *made, bat_string step);

#endif
