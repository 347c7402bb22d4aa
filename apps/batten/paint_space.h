/* Paints a document in space as PNG: surfaces shaded, curves over them, what is hidden fainter, thinner and dashed. */
#ifndef BATTEN_APPS_PAINT_SPACE_H
#define BATTEN_APPS_PAINT_SPACE_H

#include "form/shade/shade.h"

#include <batten/document.h>

/* A three-quarter view of all: parallel, from the front right and 30 degrees above; the page lies or stands (bat_stand_of). width 0:
 * 1000 pixels on the longer side. */
void space_view_of(const bat_document *document, int width, int height, bat_viewpoint *out);
/* As paint_document; the view's size is that of the picture, in whole pixels. */
const char *paint_space(const bat_document *document, const bat_viewpoint *view, bat_look look,
                        uint32_t background, unsigned char **data, size_t *size);

#endif
