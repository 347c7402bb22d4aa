#include "format/dxf/pairs.h"

#include "document/format.h"
#include "text/json.h"
#include "text/number.h"
#include <batten/curve.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COMMENT = 999, CODE_MAX = 99999 };

static bool is_blank(char byte) { return byte == ' ' || byte == '\t' || byte == '\r' || byte == '\f'; }

/* The next line, without blanks around it; false: there is none. */
static bool next_line(bat_dxf_scan *scan, const char **text, size_t *size) {
    if (scan->at >= scan->end) return false;
    const char *from = scan->at, *to = memchr(from, '\n', (size_t)(scan->end - from));
    if (!to) to = scan->end;
    scan->at = to < scan->end ? to + 1 : to;
    scan->line++;
    while (from < to && is_blank(*from)) from++;
    while (to > from && is_blank(to[-1])) to--;
    *text = from, *size = (size_t)(to - from);
    return true;
}

bat_status bat_dxf_wrong(long line, bat_status status, const char *message, bat_problem *problem) {
    char place[40];
    snprintf(place, sizeof place, "line %ld", line);
    return bat_problem_set(problem, status, place, message);
}

static bool code_of(const char *text, size_t size, int *out) {
    const bool minus = size > 0 && *text == '-';
    int code = 0;
    size_t i = minus;
    if (i == size) return false;
    for (; i < size; i++) {
        if (text[i] < '0' || text[i] > '9') return false;
        code = 10 * code + (text[i] - '0');
        if (code > CODE_MAX) return false;
    }
    *out = minus ? -code : code;
    return true;
}

bat_status bat_dxf_next(bat_dxf_scan *scan, bat_dxf_pair *out, bat_problem *problem) {
    do {
        const char *text = NULL;
        size_t size = 0;
        while (size == 0 && next_line(scan, &text, &size)) {
        } /* past empty lines */
        *out = (bat_dxf_pair){0, "EOF", 3, scan->line};
        if (size == 0) return BAT_OK;
        if (!code_of(text, size, &out->code))
            return bat_dxf_wrong(scan->line, BAT_SYNTAX, "expected a group code, found something else",
                                 problem);
        if (!next_line(scan, &out->text, &out->size))
            return bat_dxf_wrong(scan->line, BAT_SYNTAX,
                                 "expected a value after the group code, found the end", problem);
        out->line = scan->line;
    } while (out->code == COMMENT);
    return BAT_OK;
}

static char upper(char c) { return c >= 'a' && c <= 'z' ? (char)(c - 32) : c; }

bool bat_dxf_is(const bat_dxf_pair *pair, int code, const char *text) {
    if (pair->code != code || pair->size != strlen(text)) return false;
    for (size_t i = 0; i < pair->size; i++)
        if (upper(pair->text[i]) != text[i]) return false;
    return true;
}

bat_status bat_dxf_number(const bat_dxf_pair *pair, double *out, bat_problem *problem) {
    const char *end = pair->text + pair->size;
    if (bat_number_scan(pair->text, end, out) != end)
        return bat_dxf_wrong(pair->line, BAT_SYNTAX, "expected a number, found something else", problem);
    if (!(fabs(*out) <= BAT_COORDINATE_MAX))
        return bat_dxf_wrong(pair->line, BAT_NUMBER, "expected a number up to 1e75, found a greater one",
                             problem);
    return BAT_OK;
}

int bat_dxf_sniff(const char *text, size_t size) {
    static const char binary[] = "AutoCAD Binary DXF";
    const size_t start = bat_format_start(text, size);
    bat_dxf_scan scan = {text + start, text + size, 0};
    bat_dxf_pair pair;
    if (size - start >= sizeof binary - 1 && !memcmp(text + start, binary, sizeof binary - 1)) return 90;
    return bat_dxf_next(&scan, &pair, NULL) == BAT_OK && bat_dxf_is(&pair, 0, "SECTION") ? 90 : 0;
}

/* ---- records ---- */

bat_status bat_dxf_record_read(bat_dxf_scan *scan, bat_dxf_pair *head, bat_dxf_record *out,
                               bat_problem *problem) {
    out->count = 0;
    do {
        if (out->count == out->room) {
            const size_t room = 2 * out->room + 32;
            bat_dxf_pair *pairs = realloc(out->pairs, room * sizeof *pairs);
            if (!pairs) return bat_problem_set(problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
            out->pairs = pairs, out->room = room;
        }
        out->pairs[out->count++] = *head;
        const bat_status status = bat_dxf_next(scan, head, problem);
        if (status != BAT_OK) return status;
    } while (head->code != 0);
    return BAT_OK;
}

void bat_dxf_record_clear(bat_dxf_record *record) {
    free(record->pairs);
    *record = (bat_dxf_record){.pairs = NULL};
}

const bat_dxf_pair *bat_dxf_find(const bat_dxf_record *record, int code) {
    for (size_t i = 1; i < record->count; i++)
        if (record->pairs[i].code == code) return &record->pairs[i];
    return NULL;
}

bat_status bat_dxf_get(const bat_dxf_record *record, int code, double left_out, double *out,
                       bat_problem *problem) {
    const bat_dxf_pair *pair = bat_dxf_find(record, code);
    *out = left_out;
    return pair ? bat_dxf_number(pair, out, problem) : BAT_OK;
}

bat_status bat_dxf_get_point(const bat_dxf_record *record, int code, double out[3], bat_problem *problem) {
    bat_status status = BAT_OK;
    for (int k = 0; k < 3 && status == BAT_OK; k++)
        status = bat_dxf_get(record, code + 10 * k, 0, &out[k], problem);
    return status;
}
