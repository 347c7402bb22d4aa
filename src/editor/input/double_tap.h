/* A tap soon after another in about the same place. */
#ifndef BATTEN_EDITOR_INPUT_DOUBLE_TAP_H
#define BATTEN_EDITOR_INPUT_DOUBLE_TAP_H

#include <batten/editor.h>

/* The last tap; zeros: there was none. */
typedef struct bat_double_tap {
    bool first; /* a second one now would make a double tap */
    double at[2], time;
} bat_double_tap;

/* Notes a tap that ends with the event; returns whether it is the second of two. A third begins anew. */
bool bat_double_tap_ends(bat_double_tap *last, const bat_pointer *event);

#endif
