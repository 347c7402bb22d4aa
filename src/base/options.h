/*
 * Option structs of callers compiled against any version. Each begins with its size, and later versions only add
 * members at the end: members that the caller does not know keep their defaults, and members that the library
 * does not know are not read.
 */
#ifndef BATTEN_SRC_OPTIONS_H
#define BATTEN_SRC_OPTIONS_H

#include <batten/base.h>

/*
 * own: `whole` bytes that hold the defaults, overwritten with what is given (NULL: nothing). least: the size in
 * the first version, which is the offset of the first member added since. BAT_ARGUMENT: the given size is below
 * `least`.
 */
bat_status bat_options_read(const void *given, size_t least, size_t whole, void *own);
/* Fills the `size` bytes of a caller's options with the `whole` bytes of defaults, and any bytes left over
 * with zeros; never writes beyond `size`. */
void bat_options_give(const void *defaults, size_t whole, size_t size, void *options);

#endif
