/* The statements of an OBJ file, and the words and numbers of one. */
#ifndef BATTEN_FORMAT_OBJ_LINES_H
#define BATTEN_FORMAT_OBJ_LINES_H

#include <batten/base.h>

/* A statement is one line, or several joined by backslashes. */
typedef struct bat_obj_line {
    const char *at, *end; /* what of it has not been read */
    const char *rest;     /* the text after it, which ends at text_end */
    const char *text_end;
    long number; /* of the line that `at` is in, from 1 */
} bat_obj_line;

/* Before the first statement; `start`: where the text begins, after a mark of byte order and blanks. */
bat_obj_line bat_obj_lines(const char *text, size_t size, size_t start);
/* Goes to the next statement; false at the end. */
bool bat_obj_next(bat_obj_line *line);
/* Reads a number; false when there is none. */
bool bat_obj_number(bat_obj_line *line, double *value);
/* Reads a word and returns its length. */
size_t bat_obj_word(bat_obj_line *line, const char **out);
/* Skips the rest of a word, as in "1/2/3" after the 1. */
void bat_obj_skip_word(bat_obj_line *line);
/* The rest of the statement, without blanks around it. */
size_t bat_obj_rest(bat_obj_line *line, const char **out);
bool bat_obj_is(const char *word, size_t size, const char *what);

#endif
