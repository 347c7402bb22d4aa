/* Columns of numbers, as spreadsheets and scripts write them, in parts. */
#ifndef BATTEN_FORMAT_JSON_POINTS_H
#define BATTEN_FORMAT_JSON_POINTS_H

#include <batten/base.h>

/* Points in order; a column called "curve" divides them into parts, where what stands in it changes. */
typedef struct bat_point_rows {
    int dimension;
    size_t count, part_count;
    double *points;
    size_t *starts; /* of each part, and the count */
} bat_point_rows;

/* As bat_points_read reads columns. */
bat_status bat_point_rows_read(const char *text, size_t size, bat_point_rows *out, bat_problem *problem);
void bat_point_rows_clear(bat_point_rows *rows);
/* Whether the first line that says anything has two numbers or more, or names columns x and y. */
bool bat_point_rows_are(const char *text, size_t size);

#endif
