/* Casters: curves and surfaces of the document made ready as grounds. The last few are kept, for as long as their objects are
 * as they were. */
#ifndef BATTEN_EDITOR_VIEW_CASTERS_H
#define BATTEN_EDITOR_VIEW_CASTERS_H

#include "form/view/cast.h"
#include <batten/document.h>

typedef struct bat_casting {
    bat_object *object; /* retained */
    int curve;          /* -1: the surface */
    double along[3];
    const bat_curve *line; /* both of the object */
    const bat_surface *surface;
    bat_caster *caster;
} bat_casting;

enum { BAT_CASTINGS = 4 };

typedef struct bat_casters {
    bat_document *const *document; /* the session's */
    bat_casting kept[BAT_CASTINGS];
    int next; /* the one that gives way */
} bat_casters;

/* The ruled surface along `along` of a curve of the object, or its surface (curve -1). The result is borrowed until the
 * next call. BAT_STATE: the document has no such thing; BAT_MEMORY. */
bat_status bat_casters_find(bat_casters *casters, bat_id object, int curve, const double along[3],
                            bat_casting **out);
void bat_casters_free(bat_casters *casters);

#endif
