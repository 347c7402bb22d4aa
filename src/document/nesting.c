#include "document/nesting.h"

#include "document/kind.h"

bool bat_nesting_next(bat_nesting *nesting, const bat_object *object, bat_nesting_level *found) {
    bat_id parent = bat_object_parent(object);
    int depth = nesting->depth;
    while (depth > 0 && nesting->open[depth - 1].id != parent) depth--;
    if (depth == 0 && parent != 0) return false;
    const bat_nesting_level *in = depth ? &nesting->open[depth - 1] : NULL;
    bat_nesting_level level = {bat_object_id(object), bat_object_is(object, BAT_LAYER),
                               bat_object_is_hidden(object) || (in && in->hidden),
                               bat_object_is_locked(object) || (in && in->locked), in ? in->around : 1};
    if (bat_object_is_group(object)) {
        level.around *= bat_object_style(object)->opacity;
        if (depth == BAT_NESTING_MAX) return false;
        nesting->open[depth++] = level;
    }
    nesting->depth = depth;
    if (found) *found = level;
    return true;
}
