/* SHAPE inside other JSON. */
#ifndef BATTEN_SRC_SHAPE_JSON_H
#define BATTEN_SRC_SHAPE_JSON_H

#include "format/text.h"

#include <batten/levels.h>

void bat_shape_to_json(const bat_shape *shape, bat_text *text);

#endif
