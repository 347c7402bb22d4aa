/* The table of files of other programs that hold shapes in space. */
#ifndef BATTEN_FORMAT_MODELS_H
#define BATTEN_FORMAT_MODELS_H

#include <batten/format.h>

typedef struct bat_model_format {
    const char *name, *also; /* how names of its files end, without the dot; also: or so, NULL: only so */
    /* What is written comes back as it was; or: */
    bat_status (*write)(const bat_model *model, char **bytes, size_t *size);
    /* Faces, of which one side is the outer one. */
    bat_status (*divide)(const bat_model *model, double tolerance, char **bytes, size_t *size);
    const char *holds;
    double unit;      /* of the file, in millimetres */
    bool up_is_y;     /* else up is z */
    bool of_drawings; /* drawings are written in it: bat_model_of_drawing */
} bat_model_format;

/* By its name ("stl"), in upper or lower case; NULL: there is none. */
const bat_model_format *bat_model_format_named(const char *name);
/* By the extension of a file name ("a.stl"); NULL: no format has it. */
const bat_model_format *bat_model_format_called(const char *file);
/* Writes the model. tolerance: as of bat_stl_write; formats that hold what was made do not look at it. */
bat_status bat_model_format_write(const bat_model_format *format, const bat_model *model, double tolerance,
                                  char **bytes, size_t *size);

#endif
