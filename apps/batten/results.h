/* Results as JSON, and the CURVE, SURFACE and STROKE files that commands read. These functions report
 * failures. */
#ifndef BATTEN_APPS_RESULTS_H
#define BATTEN_APPS_RESULTS_H

#include "text/text.h"

#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/sketch.h>
#include <batten/nearest.h>

/* Reads data into *out, as bat_curve_read does. */
typedef bat_status data_reader(const char *data, size_t size, void *out, bat_problem *problem);
/* Reads a file with a reader; problem: as the reader left it. */
int read_data(const char *name, data_reader *reader, void *out, bat_problem *problem);
/* OBJECTs are JSON; a file called .obj is read as OBJ, and holds one of the kind that is wanted. */
int read_curve(const char *name, bat_curve **out);
int read_surface(const char *name, bat_surface **out); /* of a RELIEF the finest */
int read_relief(const char *name, bat_relief **out);   /* a SURFACE is the base of one without levels */
/* All of a file. */
int read_model(const char *name, bat_model *out);
/* Free *block with bat_free. */
int read_stroke(const char *name, bat_stroke *out, void **block);

/* "[1,2]" */
void put_numbers(bat_text *text, const double *numbers, size_t count);
/* "[[1,2],[3,4]]": count points of `dimension` numbers, `stride` doubles apart. */
void put_points(bat_text *text, const double *numbers, size_t count, int dimension, size_t stride);
/* Adds a line end to the text, writes it to standard output, and releases it. */
int write_text(bat_text *text);
/* From now on a curve goes back to its place in a drawing (address.h), which is written to this file; its report is a
 * remark. NULL: to standard output. lossy: over what it came from even if something is lost. */
void write_back_to(const char *file, bool lossy);
int write_curve(const bat_curve *curve);
/* Writes the surface with its report (JSON), which is released; NULL: without one. */
int write_surface(const bat_surface *surface, bat_text *report);
/* The same for a mesh. */
int write_mesh(const bat_polymesh *mesh, bat_text *report);
/* Writes the curve with its report (JSON), which is released. */
int write_curve_reported(const bat_curve *curve, bat_text *report);
/* An array of curves, each with the report, which is released; NULL: without one. */
int write_curves(size_t count, bat_curve *const *curves, bat_text *report);
/* The same with "max_error" as the report; frees the curves. */
int write_curves_within(size_t count, bat_curve **curves, double max_error);
/* Writes the curve with its report to standard output. */
int write_sketch(const bat_curve *curve, const bat_sketch_report *report);
/* The same, with the greatest distance of a raw sample. */
int write_pen(const bat_curve *curve, const bat_sketch_report *report, double raw_error);
/* Reports what a sketch's status means for the user; stroke: the name of the stroke file. */
int fail_sketch(const char *stroke, bat_status status, const bat_sketch_report *report,
                const bat_sketch_options *options);

#endif
