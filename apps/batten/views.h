/* Shared by the commands that cast strokes: the VIEW and the STROKE that they read. */
#ifndef BATTEN_APPS_VIEWS_H
#define BATTEN_APPS_VIEWS_H

#include "program.h"

#include <batten/view.h>

int read_view(const char *name, bat_viewpoint *out);
/* A stroke in pixels: its samples have 2 numbers. Free *block with bat_free. */
int read_pixels(const char *name, bat_stroke *out, void **block);

#endif
