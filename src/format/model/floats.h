/* Numbers of 32 bits, least byte first, as binary files hold them. */
#ifndef BATTEN_FORMAT_FLOATS_H
#define BATTEN_FORMAT_FLOATS_H

#include "text/text.h"

/* BAT_NUMBER: one of them is beyond the range of 32-bit floats. */
bat_status bat_floats_check(const double *numbers, size_t count);
void bat_text_word(bat_text *text, uint32_t word);
/* Rounded to the nearest float. */
void bat_text_float(bat_text *text, double number);
/* Puts a word over what was written at that place. */
void bat_text_patch(bat_text *text, size_t at, uint32_t word);

/* Read back; 4 bytes each. */
uint32_t bat_word_at(const char *bytes);
double bat_float_at(const char *bytes);

#endif
