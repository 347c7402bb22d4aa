/* The module's own snprintf: libc's brings 13 kB of what nobody asks for here. */
#ifndef BATTEN_MODULE_PRINT_H
#define BATTEN_MODULE_PRINT_H

#include <stdarg.h>
#include <stddef.h>

/* As vsnprintf: %s %c %d %u %x %g %e %f %%, with 0, width, precision (a number or *), l and z. A conversion that is
 * not among these comes out as it stands, with all behind it; the house's tests look for such. */
int bat_print(char *out, size_t room, const char *format, va_list values);

#endif
