#include "format/obj/lines.h"

#include "text/number.h"

#include <string.h>

bat_obj_line bat_obj_lines(const char *text, size_t size, size_t start) {
    bat_obj_line line = {
        .at = text + start, .end = text + start, .rest = text + start, .text_end = text + size};
    for (size_t i = 0; i < start; i++) line.number += text[i] == '\n';
    return line;
}

static const char *statement_end(const char *at, const char *end) {
    for (; at < end; at++) {
        const char *before = at;
        if (*at != '\n') continue;
        if (before[-1] == '\r') before--;
        if (before[-1] != '\\') break;
    }
    return at;
}

bool bat_obj_next(bat_obj_line *line) {
    for (; line->at < line->end; line->at++) line->number += *line->at == '\n';
    if (line->rest >= line->text_end) return false;
    line->number++;
    line->at = line->rest;
    line->end = statement_end(line->at + (*line->at != '\n'), line->text_end);
    line->rest = line->end + (line->end < line->text_end);
    return true;
}

static bool is_blank(char byte) { return byte == ' ' || byte == '\t' || byte == '\r' || byte == '\n'; }

static void skip_blanks(bat_obj_line *line) {
    for (; line->at < line->end && (is_blank(*line->at) || *line->at == '\\'); line->at++)
        line->number += *line->at == '\n';
}

bool bat_obj_number(bat_obj_line *line, double *value) {
    skip_blanks(line);
    const char *after = line->at < line->end ? bat_number_scan(line->at, line->end, value) : NULL;
    if (!after) return false;
    line->at = after;
    return true;
}

void bat_obj_skip_word(bat_obj_line *line) {
    while (line->at < line->end && !is_blank(*line->at) && *line->at != '\\') line->at++;
}

size_t bat_obj_word(bat_obj_line *line, const char **out) {
    skip_blanks(line);
    *out = line->at;
    bat_obj_skip_word(line);
    return (size_t)(line->at - *out);
}

size_t bat_obj_rest(bat_obj_line *line, const char **out) {
    skip_blanks(line);
    *out = line->at;
    size_t size = (size_t)(line->end - line->at);
    while (size && is_blank((*out)[size - 1])) size--;
    return size;
}

bool bat_obj_is(const char *word, size_t size, const char *what) {
    return size == strlen(what) && memcmp(word, what, size) == 0;
}
