/* The parts of a glTF file: its JSON, the lists in it, and the numbers of its accessors. */
#ifndef BATTEN_FORMAT_GLTF_SOURCE_H
#define BATTEN_FORMAT_GLTF_SOURCE_H

#include "text/json.h"

typedef enum bat_gltf_list {
    BAT_GLTF_ACCESSORS,
    BAT_GLTF_VIEWS,
    BAT_GLTF_BUFFERS,
    BAT_GLTF_MESHES,
    BAT_GLTF_NODES,
    BAT_GLTF_SCENES,
    BAT_GLTF_LISTS
} bat_gltf_list;

typedef struct bat_gltf_buffer {
    const char *bytes;
    size_t size;
    void *own; /* what has to be freed */
} bat_gltf_buffer;

typedef struct bat_gltf_source {
    bat_json json;
    const char *binary; /* the chunk of numbers of a binary file; NULL: none */
    size_t binary_size;
    size_t count[BAT_GLTF_LISTS];
    uint32_t *nodes[BAT_GLTF_LISTS]; /* of JSON */
    bat_gltf_buffer *buffers;        /* as many as are listed */
    bat_problem *problem;
} bat_gltf_source;

/* Borrows the bytes. On failure everything is released. */
bat_status bat_gltf_open(const char *bytes, size_t size, bat_gltf_source *out, bat_problem *problem);
void bat_gltf_close(bat_gltf_source *source);
/* Says what is wrong with an element of a list, which is named. Returns status. */
bat_status bat_gltf_wrong(const bat_gltf_source *source, bat_gltf_list list, size_t index, bat_status status,
                          const char *message);
/* A whole number from 0 to `most`; without one the fallback. False: something else. */
bool bat_gltf_whole(const bat_json *json, uint32_t node, uint64_t most, uint64_t fallback, uint64_t *out);
/* The index of an element of a list that a member gives. False: there is none such. */
bool bat_gltf_index(const bat_gltf_source *source, uint32_t node, bat_gltf_list list, size_t *out);

/* The numbers of an accessor, `width` each: 1, or 3 for places; *numbers is to be freed. *left: how many numbers may still
 * be read, which becomes less. */
bat_status bat_gltf_numbers(bat_gltf_source *source, size_t accessor, int width, uint64_t *left,
                            size_t *count, double **numbers);

#endif
