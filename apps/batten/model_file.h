/* Files of other programs that hold shapes in space, as the program writes them. */
#ifndef BATTEN_APPS_MODEL_FILE_H
#define BATTEN_APPS_MODEL_FILE_H

#include "format/models.h"

/* Writes the file; in: the name that failures are reported under. Returns 0, or an exit status. */
int model_put(const char *in, const char *out, const bat_model_format *format, const bat_model *model,
              const bat_dividing *how);

#endif
