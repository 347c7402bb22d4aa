/* Internal: what strokes are cast on, made ready, and rays one at a time. */
#ifndef BATTEN_FORM_CAST_H
#define BATTEN_FORM_CAST_H

#include <batten/view.h>

typedef struct bat_caster bat_caster;

/* A surface is borrowed, a curve is not. Statuses of the canvas as bat_cast. */
bat_status bat_caster_create(const bat_canvas *canvas, bat_caster **out);
void bat_caster_free(bat_caster *caster);
/* Where the line through a point, along a direction of length 1, meets it first. last: s of the sample that landed before
 * on a ruled surface, else NaN (bat_cast). BAT_MEMORY. */
bat_status bat_caster_line(bat_caster *caster, const double from[3], const double along[3], double last,
                           bat_cast_point *out);
/* All places where the line lands on a ruled surface, in the order of s. *list grows as they need, *room with it; it is the
 * caller's, to be freed. BAT_MEMORY. */
bat_status bat_caster_places(bat_caster *caster, const double from[3], const double along[3],
                             bat_cast_point **list, size_t *room, size_t *count);

#endif
