/* Dashes by name: patterns as long as the stroke's width asks for, beside those that a file brought. */
#ifndef BATTEN_EDITOR_EDIT_DASHES_H
#define BATTEN_EDITOR_EDIT_DASHES_H

#include <batten/document.h>

/* In the order of the property's choices. */
typedef enum bat_dashing {
    BAT_DASHING_SOLID,
    BAT_DASHING_DASHED,
    BAT_DASHING_DOTTED,
    BAT_DASHING_DASH_DOT,
    BAT_DASHING_OTHER
} bat_dashing;

bat_dashing bat_dashing_of(const bat_object *object);
/* A copy with those dashes, at its width; OTHER: with those that it has. */
bat_status bat_dashing_give(const bat_object *object, bat_dashing dashing, bat_object **out);

#endif
