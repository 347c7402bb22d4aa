/* Internal to STL. */
#ifndef BATTEN_FORMAT_STL_H
#define BATTEN_FORMAT_STL_H

#include "format/model/faces.h"

/* As bat_stl_write, of parts that are there already. */
bat_status bat_stl_put_parts(const bat_parts *parts, char **bytes, size_t *size);
/* The triangles of a file, each with corners of its own. */
bat_status bat_stl_parse(const char *bytes, size_t size, bat_faces *out, bat_problem *problem);
/* Whether it is text: it begins with "solid", and goes on with a facet or ends at once. */
bool bat_stl_is_text(const char *bytes, size_t size);
/* Whether it is binary, with triangles, and as long as their number says. */
bool bat_stl_is_whole(const char *bytes, size_t size);

#endif
