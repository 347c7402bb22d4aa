/* What of a drawing is in space as the file of another program, asked for in words. */
#ifndef BATTEN_FORMAT_EXPORT_H
#define BATTEN_FORMAT_EXPORT_H

#include "format/model/drawn.h"

/*
 * words, with a blank between each: the name of a format; "wall" or "floor", which is how the page stands, else as `found`;
 * a number, which is the greatest distance of triangles in millimetres (0: 1e-4 of the size); "cap": open rims are filled (bat_parts_close); "tell": the bytes are JSON of
 * what the file would hold instead, with its size in millimetres. "space" in place of a format: JSON of whether the page is
 * a floor. BAT_COUNT: nothing is in space; BAT_ARGUMENT: other words; problem says why there is no file.
 */
bat_status bat_export_model(const char *words, bat_stand found, const bat_document *document, char **bytes,
                            size_t *size, bat_problem *problem);

#endif
