/* A drawing in any of the formats: read by its name or its first character, written by its name. */
#ifndef BATTEN_APPS_DRAWING_H
#define BATTEN_APPS_DRAWING_H

#include "program.h"

#include "format/formats.h"

#include <batten/bezier.h>
#include <batten/format.h>

typedef struct drawing_file {
    const bat_format *format;
    bat_document *document;
    bat_svg_report report; /* zero but for SVG */
} drawing_file;

/* format NULL: told from the text. A native document is read under the name of a
 * format of parts, too (.json). options NULL: bat_svg_defaults. */
bat_status drawing_parse(const char *text, size_t size, const bat_format *format,
                         const bat_svg_options *options, drawing_file *out, bat_problem *problem);
/* The file called name ("-": standard input). Returns 0, or an exit status after telling. */
int drawing_read(const char *name, const bat_svg_options *options, drawing_file *out);
void drawing_free(drawing_file *drawing);

int drawing_curve_count(const bat_document *document);
/* What an import left out, as a remark, when anything was. */
void drawing_remark(const char *name, const drawing_file *drawing);

/* Whether OUT may be written, which may be IN: only with --lossy when something of it would be lost (a picture holds no
 * drawing). Returns 0, or an exit status after telling. */
int drawing_may_replace(const cli_arguments *arguments, const drawing_file *drawing, const char *in,
                        const char *out, bool picture);
#define OPTION_LOSSY                                                                                         \
    { "--lossy", NULL, "write over the input even when something of it is lost" }

/* The document as text (bat_free). name: for the failure's line. Returns 0, or an exit status after telling. */
int drawing_print(const bat_document *document, const bat_format *format, const char *name, char **text,
                  size_t *size);

#endif
