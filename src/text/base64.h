/* Base 64 (RFC 4648, section 4): how text carries pictures. */
#ifndef BATTEN_TEXT_BASE64_H
#define BATTEN_TEXT_BASE64_H

#include "document/picture.h"
#include "text/text.h"

void bat_base64_write(bat_text *text, const void *bytes, size_t size);
/* The picture that the text holds; white space is passed over, as in data URIs of many lines. BAT_SYNTAX: it is not
 * base 64, or not padded; else what bat_picture_create says. */
bat_status bat_base64_picture(const char *text, size_t size, bat_picture **out);

#endif
