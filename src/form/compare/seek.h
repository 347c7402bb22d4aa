/* Internal: the nearest points of a reference for places that follow each other. */
#ifndef BATTEN_FORM_COMPARE_SEEK_H
#define BATTEN_FORM_COMPARE_SEEK_H

#include <batten/compare.h>

/* Where the last nearest point was: on which thing, and at which parameters of a surface. Begins with zeros. */
typedef struct bat_seek {
    bool is_known;
    size_t thing;
    double at[2];
} bat_seek;

/* bat_reference_nearest, sooner where the point is near the last one. The arguments are not NULL. */
bat_status bat_reference_seek(const bat_reference *reference, const double point[3], bat_seek *seek,
                              double closest[3], double *distance);

#endif
