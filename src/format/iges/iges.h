/* Internal to IGES: the lines of a file by section, and parameters in free form. A file is lines of 80 columns; column 73
 * names the section: S, G, D, P, T in this order. Two lines of D are one entity, which refers to its parameters in P. */
#ifndef BATTEN_FORMAT_IGES_H
#define BATTEN_FORMAT_IGES_H

#include <batten/base.h>

enum { BAT_IGES_ENTITY = 9, BAT_IGES_MATRIX = 124, BAT_IGES_CURVE = 126, BAT_IGES_SURFACE = 128 };

typedef struct bat_iges_line {
    const char *at;
    int width; /* up to 80, without the line's end */
    long number;
} bat_iges_line;

typedef struct bat_iges_run {
    size_t first, count; /* lines */
} bat_iges_run;

typedef struct bat_iges_file {
    bat_iges_line *lines; /* the lines that are not empty */
    bat_iges_run globals, directory, parameters;
} bat_iges_file;

/* BAT_SYNTAX, BAT_UNSUPPORTED (the binary and the compressed form), BAT_MEMORY. Release with bat_free(lines). */
bat_status bat_iges_split(const char *text, size_t size, bat_iges_file *out, bat_problem *problem);

/* A place in the columns of a run of lines; lines that are too short are filled with blanks. */
typedef struct bat_iges_reader {
    const bat_iges_line *line, *end;
    int column, width;
    char delimiter, record;
    bool ended; /* the record delimiter was read, or the lines have ended */
} bat_iges_reader;

bat_iges_reader bat_iges_reader_of(const bat_iges_file *file, bat_iges_run run, int width);

typedef enum bat_iges_kind { BAT_IGES_BAD, BAT_IGES_DEFAULT, BAT_IGES_NUMBER, BAT_IGES_TEXT } bat_iges_kind;
enum { BAT_IGES_ROOM = 72 };
typedef struct bat_iges_value {
    bat_iges_kind kind; /* BAT_IGES_DEFAULT: left out, or after the end */
    double number;
    char text[BAT_IGES_ROOM]; /* cut to its first characters */
} bat_iges_value;

/* Reads the next parameter. */
bat_iges_value bat_iges_next(bat_iges_reader *reader);
/* Reads the two delimiters, which are the first global parameters. */
bool bat_iges_delimiters(bat_iges_reader *reader);
/* The line that was read last, from 1. */
long bat_iges_line_number(const bat_iges_reader *reader);
/* A whole number in columns 8 field + 1 to 8 field + 8 of a line; 0 where there is none. */
long bat_iges_field(const bat_iges_line *line, int field);

#endif
