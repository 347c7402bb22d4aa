/* Base 64 (RFC 4648, section 4): how pictures are stored in text. */
#ifndef BATTEN_TEXT_BASE64_H
#define BATTEN_TEXT_BASE64_H

#include "text/text.h"

/* White space is skipped. into: room for 3/4 of `size`, plus 3. BAT_SYNTAX: the text is not base 64. */
bat_status bat_base64_read(const char *text, size_t size, unsigned char *into, size_t *made);
void bat_base64_write(bat_text *text, const void *bytes, size_t size);

#endif
