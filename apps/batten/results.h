/* Results as JSON, and the CURVE and STROKE files that commands take. Failures are told here. */
#ifndef BATTEN_APPS_RESULTS_H
#define BATTEN_APPS_RESULTS_H

#include "text/text.h"

#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/sketch.h>
#include <batten/nearest.h>

/* Reads data into *out, as bat_curve_read does. */
typedef bat_status data_reader(const char *data, size_t size, void *out, bat_problem *problem);
/* A file through a reader; problem: as the reader left it. */
int read_data(const char *name, data_reader *reader, void *out, bat_problem *problem);
int read_curve(const char *name, bat_curve **out);
int read_surface(const char *name, bat_surface **out);
/* *block: bat_free. */
int read_stroke(const char *name, bat_stroke *out, void **block);

/* "[1,2]" */
void put_numbers(bat_text *text, const double *numbers, size_t count);
/* "[[1,2],[3,4]]": count points of `dimension` numbers, `stride` doubles apart. */
void put_points(bat_text *text, const double *numbers, size_t count, int dimension, size_t stride);
/* Ends the text with a line end, and writes it to standard output. Releases it. */
int write_text(bat_text *text);
int write_curve(const bat_curve *curve);
/* The surface with its report (JSON), which is released. */
int write_surface(const bat_surface *surface, bat_text *report);
/* The curve with its report, to standard output. */
int write_sketch(const bat_curve *curve, const bat_sketch_report *report);
/* What a sketch's status means for the user; stroke: the stroke file's name. */
int fail_sketch(const char *stroke, bat_status status, const bat_sketch_report *report,
                const bat_sketch_options *options);

#endif
