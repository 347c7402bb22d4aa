/* The width along a stroke: profiles by name, beside those that were made by hand; and what they become when curves are cut, joined
 * and turned. */
#ifndef BATTEN_EDITOR_EDIT_PROFILE_H
#define BATTEN_EDITOR_EDIT_PROFILE_H

#include <batten/paint.h>

/* In the order of the property's choices. */
typedef enum bat_profile {
    BAT_PROFILE_EVEN,
    BAT_PROFILE_END,   /* pointed there */
    BAT_PROFILE_START, /* pointed there */
    BAT_PROFILE_BOTH,  /* pointed at both */
    BAT_PROFILE_WAIST, /* thin in the middle */
    BAT_PROFILE_OTHER
} bat_profile;

bat_profile bat_profile_of(const bat_object *object);
/* A copy with that profile; OTHER: with its own. */
bat_status bat_profile_give(const bat_object *object, bat_profile profile, bat_object **out);
/* A copy with those stops, which are copied. */
bat_status bat_profile_set(const bat_object *object, size_t count, const bat_width_stop *stops,
                           bat_object **out);
/* A copy with the profile of a stretch of its own (bat_width_stretch), from 1 to 0 that of the curves turned round; none: the object
 * itself, retained. */
bat_status bat_profile_stretch(const bat_object *object, double from, double to, bat_object **out);
/* *part, which is released, with the profile that a piece of a curve keeps: from..to in shares of the whole curve's length, of a closed one
 * to may lie in the next period. Where `whole` has none it is left alone. */
bat_status bat_profile_piece(bat_object **part, const bat_object *whole, bool closed, double from, double to);
/* *object, which is released, with the profile of two curves that were joined: a's up to `share` of the length, b's from there on, each
 * turned round or not, in widths of a's style. Where neither has one it is left alone. */
bat_status bat_profile_join(bat_object **object, const bat_object *a, bool turn_a, const bat_object *b,
                            bool turn_b, double share);

#endif
