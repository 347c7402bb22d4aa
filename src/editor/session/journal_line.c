#include "editor/session/journal_line.h"
#include "document/digest.h"
#include <math.h>

void bat_line_number(bat_text *line, double number) {
    char digits[40];
    double scaled = round(number * 1e4);
    /* k / 10^4, correctly rounded, is the double that the decimal reads back as. */
    if (fabs(scaled) < 1e15 && scaled / 1e4 == number && !(number == 0 && signbit(number))) {
        uint64_t left = (uint64_t)fabs(scaled);
        char *at = digits + sizeof digits;
        unsigned fraction = (unsigned)(left % 10000);
        left /= 10000;
        for (int i = 0; i < 4; i++, fraction /= 10)
            if (fraction % 10 || at != digits + sizeof digits) *--at = (char)('0' + fraction % 10);
        if (at != digits + sizeof digits) *--at = '.';
        do *--at = (char)('0' + left % 10);
        while (left /= 10);
        if (number < 0) *--at = '-';
        bat_text_add(line, at, (size_t)(digits + sizeof digits - at));
        return;
    }
    bat_text_number(line, number);
}

void bat_line_numbers(bat_text *line, const double *numbers, size_t count, size_t stride) {
    bat_text_string(line, "[");
    for (size_t i = 0; i < count; i++) {
        if (i) bat_text_string(line, ",");
        bat_line_number(line, numbers[i * stride]);
    }
    bat_text_string(line, "]");
}

void bat_line_digest(bat_text *line, uint64_t digest) {
    char text[17];
    bat_digest_print(digest, text);
    bat_text_json_string(line, text);
}
