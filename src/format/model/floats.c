#include "format/model/floats.h"

#include <float.h>
#include <math.h>
#include <string.h>

bat_status bat_floats_check(const double *numbers, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (!(fabs(numbers[i]) <= FLT_MAX)) return BAT_NUMBER;
    return BAT_OK;
}

static void split(uint32_t word, char out[4]) {
    for (int k = 0; k < 4; k++) out[k] = (char)(word >> 8 * k & 0xFF);
}

void bat_text_word(bat_text *text, uint32_t word) {
    char bytes[4];
    split(word, bytes);
    bat_text_add(text, bytes, sizeof bytes);
}

void bat_text_float(bat_text *text, double number) {
    const float rounded = (float)number;
    uint32_t word;
    memcpy(&word, &rounded, sizeof word);
    bat_text_word(text, word);
}

void bat_text_patch(bat_text *text, size_t at, uint32_t word) {
    if (!text->failed) split(word, text->data + at);
}

uint32_t bat_word_at(const char *bytes) {
    uint32_t word = 0;
    for (int k = 0; k < 4; k++) word |= (uint32_t)(unsigned char)bytes[k] << 8 * k;
    return word;
}

double bat_float_at(const char *bytes) {
    const uint32_t word = bat_word_at(bytes);
    float number;
    memcpy(&number, &word, sizeof number);
    return (double)number;
}
