/* Makes texts from files, and names of files, safe for a terminal or a browser. */
#ifndef BATTEN_APPS_CLEAN_H
#define BATTEN_APPS_CLEAN_H

#include <stddef.h>

enum { CLEAN_ROOM = 5 };

/*
 * Cleans the next character of text: valid UTF-8 is kept, an invalid byte becomes \xNN, and control characters
 * and line ends (including U+0085, U+2028 and U+2029) become a space. Returns how many bytes were read, 0 at the
 * end.
 */
size_t clean_next(const char *text, char out[CLEAN_ROOM]);
/* Cleans all of text, cut after the last character that fits. Returns the length of the result. */
size_t clean_text(const char *text, char *out, size_t room);

#endif
