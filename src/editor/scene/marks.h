/* Markers at the vertices of an object, as hosts get them: items of their own beside that of the object. */
#ifndef BATTEN_EDITOR_SCENE_MARKS_H
#define BATTEN_EDITOR_SCENE_MARKS_H

#include <batten/document.h>
#include <batten/frame.h>

typedef struct bat_scene_marks {
    bat_item *items; /* whose paths and paints are owned */
    int count;
    int order;       /* bat_marker_order */
    float bounds[4]; /* of them all */
} bat_scene_marks;

/* At most so many items take the place of an object's own, beside the marks. */
enum { BAT_MARKS_ITEMS = 4 };

/* Relative to the origin. *out NULL with BAT_OK: none. BAT_MEMORY. */
bat_status bat_scene_marks_create(const bat_object *object, const double origin[2], bat_scene_marks **out);
void bat_scene_marks_free(bat_scene_marks *marks); /* not NULL */
/* Writes what is painted of an object instead of its item and of those that it was to be painted by (itself, or `own` of its
 * stroke and fill); returns how many there are then. */
int bat_scene_marks_show(const bat_scene_marks *marks, const bat_item *item, const bat_item *own, int count,
                         bat_item *items);

#endif
