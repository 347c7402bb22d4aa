/* Drawings as results. */
#include "drawing.h"
#include "io.h"
#include "program.h"

#include <batten/bezier.h>

int drawing_put(const cli_arguments *arguments, const drawing_file *drawing) {
    const char *name = arguments->operands[0], *out = arguments_value(arguments, OPTION_OUTPUT);
    const bat_format *format = out ? drawing_format(out) : NULL;
    char *text = NULL;
    size_t size;
    if (!format) format = drawing->format;
    const drawing_writing how = {name, out ? out : "-", arguments_value(arguments, OPTION_LOSSY) != NULL};
    int failed = out ? drawing_may_replace(how.lossy, drawing, name, out, false) : EXIT_DONE;
    if (!failed) failed = drawing_print_over(drawing->document, format, &how, &text, &size);
    if (failed) return failed;
    failed = io_write(out ? out : "-", text, size);
    bat_free(text);
    if (!failed && !(format->keeps && drawing_keeps_file(drawing))) drawing_remark(name, drawing);
    return failed;
}
