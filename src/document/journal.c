#include "document/journal.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Room for `more` bytes and a final zero. */
static char *grow(char **text, size_t size, size_t *room, size_t more) {
    if (*room - size <= more || !*text) {
        size_t wanted = *room ? 2 * *room : 256;
        while (wanted - size <= more) wanted *= 2;
        char *moved = realloc(*text, wanted);
        if (!moved) return NULL;
        *text = moved;
        *room = wanted;
    }
    return *text + size;
}

void bat_line_free(bat_line *line) {
    free(line->text);
    *line = (bat_line){0};
}

void bat_line_bytes(bat_line *line, const char *bytes, size_t size) {
    char *end = line->failed ? NULL : grow(&line->text, line->size, &line->room, size);
    if (!end) {
        line->failed = true;
        return;
    }
    memcpy(end, bytes, size);
    line->size += size;
}

void bat_line_text(bat_line *line, const char *text) { bat_line_bytes(line, text, strlen(text)); }

void bat_line_string(bat_line *line, const char *text) {
    static const char hex[] = "0123456789abcdef";
    bat_line_text(line, "\"");
    for (const char *at = text; *at; at++) {
        unsigned char c = (unsigned char)*at;
        if (c == '"' || c == '\\')
            bat_line_bytes(line, (char[]){'\\', (char)c}, 2);
        else if (c < 0x20)
            bat_line_bytes(line, (char[]){'\\', 'u', '0', '0', hex[c >> 4], hex[c & 15]}, 6);
        else
            bat_line_bytes(line, at, 1);
    }
    bat_line_text(line, "\"");
}

void bat_line_number(bat_line *line, double number) {
    char digits[40];
    double scaled = round(number * 1e4);
    /* k / 10^4 correctly rounded is the double that the decimal reads back as. */
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
        bat_line_bytes(line, at, (size_t)(digits + sizeof digits - at));
        return;
    }
    for (int precision = 15; precision <= 17; precision++) {
        snprintf(digits, sizeof digits, "%.*g", precision, number);
        if (strtod(digits, NULL) == number) break;
    }
    bat_line_text(line, digits);
}

void bat_line_numbers(bat_line *line, const double *numbers, size_t count, size_t stride) {
    bat_line_text(line, "[");
    for (size_t i = 0; i < count; i++) {
        if (i) bat_line_text(line, ",");
        bat_line_number(line, numbers[i * stride]);
    }
    bat_line_text(line, "]");
}

void bat_line_digest(bat_line *line, uint64_t digest) {
    char text[20] = "\"";
    for (int i = 0; i < 16; i++) text[1 + i] = "0123456789abcdef"[digest >> (60 - 4 * i) & 15];
    text[17] = '"';
    bat_line_bytes(line, text, 18);
}

void bat_journal_free(bat_journal *journal) {
    free(journal->text);
    *journal = (bat_journal){0};
}

bat_status bat_journal_append(bat_journal *journal, const bat_line *line) {
    char *end = line->failed ? NULL : grow(&journal->text, journal->size, &journal->room, line->size + 1);
    if (!end) return BAT_MEMORY;
    memcpy(end, line->text, line->size);
    end[line->size] = '\n';
    journal->size += line->size + 1;
    journal->text[journal->size] = 0;
    return BAT_OK;
}
