/* The lines and parameters of an IGES file (version 5.3, sections 2.2.1 to 2.2.4). */
#include "format/iges/iges.h"

#include "text/json.h"
#include "text/number.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 80, LETTER = 72 };

static bat_status wrong(bat_problem *problem, long line, bat_status status, const char *message) {
    char place[40];
    snprintf(place, sizeof place, "line %ld", line);
    return bat_problem_set(problem, status, place, message);
}

/* The line at `text`; returns where the next one begins. */
static const char *cut_line(const char *text, const char *end, bat_iges_line *out) {
    const char *stop = memchr(text, '\n', (size_t)(end - text));
    const char *next = stop ? stop + 1 : end;
    if (!stop) stop = end;
    while (stop > text && (stop[-1] == '\r' || stop[-1] == '\0' || stop[-1] == '\x1a')) stop--;
    out->at = text;
    out->width = stop - text < COLUMNS ? (int)(stop - text) : COLUMNS;
    return next;
}

static bool is_blank(const bat_iges_line *line) {
    for (int i = 0; i < line->width; i++)
        if (line->at[i] != ' ' && line->at[i] != '\t') return false;
    return true;
}

/* Puts the line into the run of its section, which must not come before the present one. */
static bat_status sort_in(const bat_iges_line *line, size_t index, int *section, bat_iges_file *out,
                          bat_problem *problem) {
    static const char letters[] = "SGDPT";
    bat_iges_run *const runs[] = {NULL, &out->globals, &out->directory, &out->parameters, NULL};
    const char letter = line->width > LETTER ? line->at[LETTER] : ' ';
    if (index == 0 && (letter == 'B' || letter == 'C'))
        return wrong(problem, line->number, BAT_UNSUPPORTED,
                     letter == 'B' ? "expected lines of 80 columns, found the binary form"
                                   : "expected lines of 80 columns, found the compressed form");
    const char *found = letter == '\0' ? NULL : strchr(letters, letter);
    if (!found)
        return wrong(problem, line->number, BAT_SYNTAX,
                     "expected the letter of a section (S, G, D, P, T) in column 73, found none");
    const int now = (int)(found - letters);
    if (now < *section)
        return wrong(problem, line->number, BAT_SYNTAX, "expected sections in the order S, G, D, P, T");
    if (runs[now] && now != *section) runs[now]->first = index;
    if (runs[now]) runs[now]->count++;
    *section = now;
    return BAT_OK;
}

bat_status bat_iges_split(const char *text, size_t size, bat_iges_file *out, bat_problem *problem) {
    size_t most = 1, count = 0;
    for (size_t i = 0; i < size; i++) most += text[i] == '\n';
    bat_iges_file made = {.lines = malloc(most * sizeof *made.lines)};
    if (!made.lines) return bat_problem_set(problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
    const char *at = text, *end = text + size;
    bat_status status = BAT_OK;
    int section = 0;
    for (long number = 1; at < end && status == BAT_OK && section < 4; number++) {
        bat_iges_line line = {.number = number};
        at = cut_line(at, end, &line);
        if (is_blank(&line)) continue;
        made.lines[count] = line;
        status = sort_in(&line, count++, &section, &made, problem);
    }
    if (status == BAT_OK && made.globals.count == 0)
        status = wrong(problem, count ? made.lines[count - 1].number : 1, BAT_SYNTAX,
                       "expected a section G, found none");
    if (status == BAT_OK && made.directory.count % 2 != 0)
        status = wrong(problem, made.lines[made.directory.first + made.directory.count - 1].number,
                       BAT_SYNTAX, "expected two lines of section D for each entity, found one");
    if (status == BAT_OK)
        *out = made;
    else
        free(made.lines);
    return status;
}

long bat_iges_field(const bat_iges_line *line, int field) {
    long value = 0;
    bool negative = false;
    for (int i = 8 * field; i < 8 * field + 8 && i < line->width; i++) {
        const char c = line->at[i];
        if (c == '-') negative = true;
        if (c >= '0' && c <= '9') value = 10 * value + (c - '0');
    }
    return negative ? -value : value;
}

/* ---- parameters ---- */

bat_iges_reader bat_iges_reader_of(const bat_iges_file *file, bat_iges_run run, int width) {
    const bat_iges_line *first = file->lines + run.first;
    return (bat_iges_reader){.line = first,
                             .end = first + run.count,
                             .width = width,
                             .delimiter = ',',
                             .record = ';',
                             .ended = run.count == 0};
}

long bat_iges_line_number(const bat_iges_reader *reader) {
    return reader->line < reader->end ? reader->line->number : reader->end[-1].number;
}

static int peek(const bat_iges_reader *reader) {
    if (reader->line >= reader->end) return -1;
    return reader->column < reader->line->width ? (unsigned char)reader->line->at[reader->column] : ' ';
}

static int take(bat_iges_reader *reader) {
    const int c = peek(reader);
    if (c >= 0 && ++reader->column >= reader->width) {
        reader->column = 0;
        reader->line++;
    }
    return c;
}

static void skip_blanks(bat_iges_reader *reader) {
    while (peek(reader) == ' ' || peek(reader) == '\t') (void)take(reader);
}

/* Takes what follows a parameter: nothing but blanks, and a delimiter. */
static bool take_delimiter(bat_iges_reader *reader) {
    skip_blanks(reader);
    const int c = take(reader);
    reader->ended = c < 0 || c == reader->record;
    return reader->ended || c == reader->delimiter;
}

/* A text after its count and H: so many characters, whatever they are. */
static bat_iges_value read_text(bat_iges_reader *reader, long count) {
    bat_iges_value value = {.kind = BAT_IGES_TEXT};
    for (long i = 0; i < count; i++) {
        const int c = take(reader);
        if (c < 0) return (bat_iges_value){.kind = BAT_IGES_BAD};
        if (i + 1 < BAT_IGES_ROOM) value.text[i] = (char)c;
    }
    if (!take_delimiter(reader)) value.kind = BAT_IGES_BAD;
    return value;
}

/* A number, with D or E before the exponent; anything else (a logical value, a word) is a text. */
static void judge(bat_iges_value *value, size_t size) {
    char digits[BAT_IGES_ROOM];
    while (size && value->text[size - 1] == ' ') value->text[--size] = '\0';
    if (size == 0) {
        value->kind = BAT_IGES_DEFAULT;
        return;
    }
    for (size_t i = 0; i < size; i++)
        digits[i] = value->text[i] == 'D' || value->text[i] == 'd' ? 'E' : value->text[i];
    const char *after = bat_number_scan(digits, digits + size, &value->number);
    value->kind = after == digits + size ? BAT_IGES_NUMBER : BAT_IGES_TEXT;
}

bat_iges_value bat_iges_next(bat_iges_reader *reader) {
    bat_iges_value value = {.kind = BAT_IGES_DEFAULT};
    size_t size = 0;
    long count = 0;
    bool digits = true;
    if (reader->ended) return value;
    skip_blanks(reader);
    for (;;) {
        const int c = take(reader);
        reader->ended = c < 0 || c == reader->record;
        if (reader->ended || c == reader->delimiter) break;
        if (c == 'H' && digits && size > 0) return read_text(reader, count);
        if (size + 1 >= BAT_IGES_ROOM && c != ' ') return (bat_iges_value){.kind = BAT_IGES_BAD};
        digits = digits && c >= '0' && c <= '9' && size < 9;
        if (digits) count = 10 * count + (c - '0');
        if (size + 1 < BAT_IGES_ROOM) value.text[size++] = (char)c;
    }
    judge(&value, size);
    return value;
}

/* One of the two: 1H and the character, or nothing for the usual one. */
static bool read_delimiter(bat_iges_reader *reader, char usual, char *out) {
    *out = usual;
    skip_blanks(reader);
    if (peek(reader) != '1') return take(reader) == reader->delimiter;
    (void)take(reader);
    if (take(reader) != 'H') return false;
    const int c = take(reader);
    if (c <= ' ' || (c >= '0' && c <= '9') || strchr("+-.DEH", c)) return false;
    *out = (char)c;
    return true;
}

bool bat_iges_delimiters(bat_iges_reader *reader) {
    const bool said = peek(reader) == '1';
    if (!read_delimiter(reader, ',', &reader->delimiter)) return false;
    if (said && take(reader) != reader->delimiter) return false;
    const bool again = peek(reader) == '1';
    char record;
    if (!read_delimiter(reader, ';', &record)) return false;
    if (record == reader->delimiter) return false;
    reader->record = record;
    return !again || take_delimiter(reader);
}
