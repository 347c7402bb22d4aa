#include "editor/edit/surface_pair.h"
#include "document/document.h"

static const double SHARE = 1e-4; /* of the size */

static const bat_surface *surface_at(const bat_document *document, int at) {
    return at < 0 ? NULL : bat_object_surface(bat_document_at(document, at));
}

bat_surface_pair bat_surface_pair_of(const bat_document *document, bat_id object, const bat_mirror *mirror) {
    const bat_surface *surface = surface_at(document, bat_document_find(document, object));
    bat_surface_pair pair = {.image = 0};
    if (!mirror->on || !surface) return pair;
    const double within = SHARE * bat_surface_size(surface);
    if (bat_surface_is_own_image(surface, mirror, within, &pair.way)) {
        pair.image = object;
        return pair;
    }
    for (int i = bat_document_count(document) - 1; i >= 0; i--) {
        const bat_object *other = bat_document_at(document, i);
        const bat_surface *twin = bat_object_surface(other);
        if (!twin || bat_object_id(other) == object) continue;
        const bat_nesting_level level = bat_document_level(document, i);
        if (level.hidden || level.locked || !bat_surface_is_image(surface, twin, mirror, within, &pair.way))
            continue;
        pair.image = bat_object_id(other);
        break;
    }
    return pair;
}
