/* The rows on surfaces as exports of a module, which module.mjs times: the same work as WebAssembly. */
#include "bench.h"

#include <stddef.h>

#define EXPORT(name) __attribute__((export_name(#name)))
EXPORT(name) const char *module_name(int row);
EXPORT(unit) const char *module_unit(int row);
EXPORT(factor) double module_factor(int row);
EXPORT(begin) void *module_begin(int row);
EXPORT(run) void module_run(int row, void *context);
EXPORT(end) void module_end(int row, void *context);

const char *module_name(int row) { return bench_rows_surface[row].name; } /* NULL after the last */
const char *module_unit(int row) { return bench_rows_surface[row].unit; }
double module_factor(int row) { return bench_rows_surface[row].scale / bench_rows_surface[row].per; }
void *module_begin(int row) { return bench_rows_surface[row].begin(bench_rows_surface[row].variant); }
void module_run(int row, void *context) { bench_rows_surface[row].run(context); }
void module_end(int row, void *context) { bench_rows_surface[row].end(context); }
