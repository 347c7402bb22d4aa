/* The table of files of other programs that hold shapes in space. */
#ifndef BATTEN_FORMAT_MODELS_H
#define BATTEN_FORMAT_MODELS_H

#include "format/model/model.h"

typedef struct bat_model_format {
    const char *name, *also; /* how names of its files end, without the dot; also: or so, NULL: only so */
    /* What is written comes back as it was; */
    bat_status (*write)(const bat_model *model, char **bytes, size_t *size);
    /* or triangles, of which one side is the outer one. */
    bat_parts_writer *divide;
    const char *holds;
    double unit;      /* of the file, in millimetres */
    bool up_is_y;     /* else up is z */
    bool of_drawings; /* a drawing becomes such a file by its name alone */
} bat_model_format;

/* By its name ("stl"), in upper or lower case; NULL: there is none. */
const bat_model_format *bat_model_format_named(const char *name);
/* By the extension of a file name ("a.stl"); NULL: no format has it. */
const bat_model_format *bat_model_format_called(const char *file);

typedef struct bat_dividing {
    double tolerance; /* greatest distance of triangles and lines; 0: 1e-4 of the model's size */
    bool cap;         /* open rims are filled: bat_parts_close */
    bool always;      /* into triangles also where the format holds surfaces, if it holds triangles */
} bat_dividing;
/* What a file holds, in its own axes and unit. */
typedef struct bat_model_told {
    double size[3];
    size_t triangle_count, open_count; /* open: edges of triangles without a neighbour */
} bat_model_told;
/* Writes the model; told: may be NULL. Statuses as of bat_gltf_write. */
bat_status bat_model_format_write(const bat_model_format *format, const bat_model *model,
                                  const bat_dividing *how, char **bytes, size_t *size, bat_model_told *told);

#endif
