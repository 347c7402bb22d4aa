/*
 * Options as a caller of any version has them. Each begins with its size, and a version that knows more members has them
 * behind: what a caller does not know keeps its default, what the library does not know is not read.
 */
#ifndef BATTEN_SRC_OPTIONS_H
#define BATTEN_SRC_OPTIONS_H

#include <batten/base.h>

/*
 * own: `whole` bytes that hold the defaults, and are laid over by what is given (NULL: nothing). least: the size as of the
 * first version, where the first member that was added since begins. BAT_ARGUMENT: a smaller one.
 */
bat_status bat_options_read(const void *given, size_t least, size_t whole, void *own);
/* Fills the `size` bytes of a caller's options with defaults of `whole` bytes, the rest with zeros; none beyond them. */
void bat_options_give(const void *defaults, size_t whole, size_t size, void *options);

#endif
