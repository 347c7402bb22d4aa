/* A drawing in any of the formats: read by its name or its content, written by its name. */
#ifndef BATTEN_APPS_DRAWING_H
#define BATTEN_APPS_DRAWING_H

#include "program.h"

#include "format/formats.h"

#include <batten/bezier.h>
#include <batten/format.h>

typedef struct drawing_file {
    const bat_format *format;
    bat_document *document;
    bat_svg_report report; /* zeros except for formats with losses */
} drawing_file;

/* format NULL: recognised from the text. Under the name of a format for parts (.json), a native document is
 * read, too. options NULL: bat_svg_defaults. */
bat_status drawing_parse(const char *text, size_t size, const bat_format *format,
                         const bat_svg_options *options, drawing_file *out, bat_problem *problem);
/* The format that a file's name means; NULL: none. */
const bat_format *drawing_format(const char *name);
/* Reads the file called name ("-": standard input); of a PDF, its first page. Returns 0, or an exit status after reporting the failure. */
int drawing_read(const char *name, const bat_svg_options *options, drawing_file *out);
void drawing_free(drawing_file *drawing);

int drawing_curve_count(const bat_document *document);
/* Says on standard error that the drawing's size was taken to be 96 px an inch, where it says none itself. */
void drawing_remark_size(const char *name, const bat_document *document);
/* Prints a remark about what an import left out, if anything. */
void drawing_remark(const char *name, const drawing_file *drawing);

/* The document keeps the file that it was read from: writing it as a drawing loses nothing. */
bool drawing_keeps_file(const drawing_file *drawing);
/* One line on standard error: what of such a file is not shown; nothing when all is. */
void drawing_remark_kept(const char *name, const drawing_file *drawing);
/* One line on standard error: what saving over a file that is not kept would lose, all of it by name. */
void drawing_remark_lost(const char *name, const drawing_file *drawing);
/* Whether OUT may be written, which may be the same file as IN: if something in it would be lost, only if
 * lossy (picture: the output is a picture, which does not keep the drawing). Returns 0, or an exit status
 * after reporting the failure. */
int drawing_may_replace(bool lossy, const drawing_file *drawing, const char *in, const char *out,
                        bool picture);

/* The document as text, to be freed with bat_free. name: used when reporting a failure. Returns 0, or an exit
 * status after reporting the failure. */
int drawing_print(const bat_document *document, const bat_format *format, const char *name, char **text,
                  size_t *size);

typedef struct drawing_writing {
    const char *in, *out; /* may be the same file */
    bool lossy;           /* then, too, all of it may be written anew */
} drawing_writing;

/* The same as SVG, in the file that the document keeps. Where an edit cannot be said in that file, it is written anew, which is
 * said in one line; over IN only if lossy. native, precision: as of bat_svg_write_within. */
int drawing_print_svg(const bat_document *document, bool native, double precision, const drawing_writing *how,
                      char **text, size_t *size);
/* As drawing_print, or drawing_print_svg where the format is SVG. */
int drawing_print_over(const bat_document *document, const bat_format *format, const drawing_writing *how,
                       char **text, size_t *size);

/* The drawing as a result: to the file of -o, or in its own format to standard output. */
int drawing_put(const struct cli_arguments *arguments, const drawing_file *drawing);

#endif
