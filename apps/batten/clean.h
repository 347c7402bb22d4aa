/* Texts from files, and names of files, as a terminal or a browser may have them. */
#ifndef BATTEN_APPS_CLEAN_H
#define BATTEN_APPS_CLEAN_H

#include <stddef.h>

enum { CLEAN_ROOM = 5 };

/*
 * The next character of text: valid UTF-8 is kept, a byte that is none becomes \xNN, control characters and line
 * ends (U+0085, U+2028 and U+2029, too) a space. Returns how many bytes it was, 0 at the end.
 */
size_t clean_next(const char *text, char out[CLEAN_ROOM]);
/* All of text, cut at the last character that there is room for. Returns its length. */
size_t clean_text(const char *text, char *out, size_t room);

#endif
