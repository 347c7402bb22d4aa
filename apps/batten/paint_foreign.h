/* Foreign content, painted by librsvg where that is installed: it is loaded when it is first needed. */
#ifndef BATTEN_APPS_PAINT_FOREIGN_H
#define BATTEN_APPS_PAINT_FOREIGN_H

#include <batten/document.h>
#include <cairo.h>

/* Paints it in its place; with the object's opacity. False: there is no librsvg, or it cannot read the content. What the
 * content refers to beyond itself is not fetched, and nothing in it is run. */
bool paint_foreign(cairo_t *cairo, const bat_object *object);

#endif
