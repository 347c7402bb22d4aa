/* The module's own snprintf: libc's adds 13 kB of features that are not used here. */
#ifndef BATTEN_MODULE_PRINT_H
#define BATTEN_MODULE_PRINT_H

#include <stdarg.h>
#include <stddef.h>

/* As vsnprintf: %s %c %d %u %x %g %e %f %%, with 0, width, precision (a number or *), l and z. Any other conversion
 * is copied literally, with everything after it; tests/house checks that there is none. */
int bat_print(char *out, size_t room, const char *format, va_list values);

#endif
