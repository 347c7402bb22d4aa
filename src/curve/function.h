#ifndef BATTEN_CURVE_FUNCTION_H
#define BATTEN_CURVE_FUNCTION_H

#include <batten/function.h>

/* *to is not cleared first. On failure it is a number. */
bat_status bat_function_copy(const bat_function *from, bat_function *to);

#endif
