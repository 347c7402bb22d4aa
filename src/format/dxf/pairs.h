/* A DXF file is a row of pairs: a line with a group code, which says what it is about, and a line with its value. */
#ifndef BATTEN_FORMAT_DXF_PAIRS_H
#define BATTEN_FORMAT_DXF_PAIRS_H

#include <batten/base.h>

typedef struct bat_dxf_pair {
    int code;
    const char *text; /* the value, without blanks around it; borrowed from the file */
    size_t size;
    long line; /* of the value */
} bat_dxf_pair;

typedef struct bat_dxf_scan {
    const char *at, *end;
    long line; /* read so far */
} bat_dxf_scan;

/* The next pair; at the end of the text, (0, "EOF"). Comments (999) are skipped. BAT_SYNTAX: no whole number where a code
 * must be, or a code without a value. */
bat_status bat_dxf_next(bat_dxf_scan *scan, bat_dxf_pair *out, bat_problem *problem);
bool bat_dxf_is(const bat_dxf_pair *pair, int code, const char *text); /* in upper or lower case */
/* The value as a number, within 1e75; BAT_SYNTAX or BAT_NUMBER when it is none. */
bat_status bat_dxf_number(const bat_dxf_pair *pair, double *out, bat_problem *problem);
bat_status bat_dxf_wrong(long line, bat_status status, const char *message, bat_problem *problem);
/* How certain it is, 0 to 100, that this is a DXF file. */
int bat_dxf_sniff(const char *text, size_t size);

/* What stands from one pair with code 0 up to the next. */
typedef struct bat_dxf_record {
    bat_dxf_pair *pairs; /* the first is its name */
    size_t count, room;
} bat_dxf_record;
/* Reads the record that begins with *head, and into *head the pair that ends it. */
bat_status bat_dxf_record_read(bat_dxf_scan *scan, bat_dxf_pair *head, bat_dxf_record *out,
                               bat_problem *problem);
void bat_dxf_record_clear(bat_dxf_record *record);
const bat_dxf_pair *bat_dxf_find(const bat_dxf_record *record, int code); /* the first; NULL: none */
/* The number of a code, or what it is where it is left out. */
bat_status bat_dxf_get(const bat_dxf_record *record, int code, double left_out, double *out,
                       bat_problem *problem);
/* Codes code, code + 10 and code + 20, where left out 0. */
bat_status bat_dxf_get_point(const bat_dxf_record *record, int code, double out[3], bat_problem *problem);

#endif
