/* Strokes whose width changes along them: what covers them, as hosts get it. */
#ifndef BATTEN_EDITOR_SCENE_WIDE_H
#define BATTEN_EDITOR_SCENE_WIDE_H

#include <batten/frame.h>
#include <batten/paint.h>

typedef struct bat_scene_wide {
    uint32_t version, count, paint_count;
    float *path;
    float *paint; /* NULL: a plain colour */
} bat_scene_wide;

enum { BAT_WIDE_ITEMS = 3 };

/* Relative to the origin. *out NULL with BAT_OK: it cannot be covered, and is as wide everywhere. BAT_MEMORY. */
bat_status bat_scene_wide_create(const bat_object *object, const double origin[2], uint32_t version,
                                 bat_scene_wide **out);
void bat_scene_wide_free(bat_scene_wide *wide); /* NULL is fine */
/* Writes the items that are painted instead of one with a stroke, at most BAT_WIDE_ITEMS; returns how many. */
int bat_scene_wide_show(const bat_scene_wide *wide, const bat_item *item, bat_item *items);

#endif
