/* Writes shapes in space as files of other programs. */
#include "model_file.h"
#include "io.h"
#include "program.h"

#include <batten/bezier.h>

static int fail_write(const char *in, const bat_model_format *format, bat_status status) {
    switch (status) {
    case BAT_MEMORY: return fail_memory();
    case BAT_COUNT: return fail_data(in, NULL, "expected %s, found nothing that makes a file", format->holds);
    case BAT_NUMBER:
        return fail_data(in, NULL,
                         "expected numbers up to 3.4e38, which the file's 32 bits hold, found greater ones");
    case BAT_TOLERANCE:
        return fail_data(
            in, NULL,
            "expected a tolerance that 16 million triangles, 1024 steps a span, can meet, found a "
            "finer one");
    default: return fail_data(in, NULL, "%s", bat_status_message(status));
    }
}

int model_put(const char *in, const char *out, const bat_model_format *format, const bat_model *model,
              const bat_dividing *how) {
    char *bytes = NULL;
    size_t size = 0;
    const bat_status status = bat_model_format_write(format, model, how, &bytes, &size, NULL);
    const int failed = status == BAT_OK ? io_write(out, bytes, size) : fail_write(in, format, status);
    bat_free(bytes);
    return failed;
}
