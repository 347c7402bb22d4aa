/* Internal to glTF. */
#ifndef BATTEN_FORMAT_GLTF_H
#define BATTEN_FORMAT_GLTF_H

#include "format/model/faces.h"

/* As bat_gltf_write, of parts that are there already; and as .gltf: JSON with the numbers in it. */
bat_status bat_gltf_put_parts(const bat_parts *parts, char **bytes, size_t *size);
bat_status bat_gltf_put_parts_as_text(const bat_parts *parts, char **bytes, size_t *size);

/* A mesh for each node that has one, on top of the drawing; *left_out: what else has a shape or moves. BAT_UNSUPPORTED: numbers in
 * other files or compressed ones. O(bytes) as a rule: a mesh that many nodes show is made for each, up to a bound. */
bat_status bat_gltf_parse(const char *bytes, size_t size, bat_document *out, int *left_out,
                          bat_problem *problem);
bool bat_gltf_is_binary(const char *bytes, size_t size);
/* Whether it is JSON that says that it is glTF. */
bool bat_gltf_is_text(const char *text, size_t size);

#endif
