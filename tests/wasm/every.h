/* Included before each program of units.wasm and of its native twin (-include), so that both are given the same: sin and
 * its like differ from libc to libc, in the last bits of what a test asks for. And what WebAssembly has not: files
 * (fopen gets one of the repository from the host), and libc's snprintf, which the module's hides. */
#ifndef BATTEN_TESTS_WASM_EVERY_H
#define BATTEN_TESTS_WASM_EVERY_H

#include "base/real.h"

#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

double units_pow(double x, double y);

#define sin(x) bat_sin(x)
#define cos(x) bat_cos(x)
#define tan(x) bat_tan(x)
#define asin(x) bat_asin(x)
#define acos(x) bat_acos(x)
#define atan(x) bat_atan(x)
#define atan2(y, x) bat_atan2(y, x)
#define exp(x) bat_exp(x)
#define log(x) bat_log(x)
#define hypot(x, y) bat_hypot(x, y)
#define pow(x, y) units_pow(x, y)

#ifdef __wasm__
FILE *host_fopen(const char *path, const char *mode);
int host_vsnprintf(char *out, size_t room, const char *format, va_list values);
int host_snprintf(char *out, size_t room, const char *format, ...) __attribute__((format(printf, 3, 4)));
#define fopen(path, mode) host_fopen(path, mode)
#define vsnprintf(...) host_vsnprintf(__VA_ARGS__)
#define snprintf(...) host_snprintf(__VA_ARGS__)
#endif

#endif
