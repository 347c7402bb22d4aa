/* Internal to surfaces: triangles. */
#ifndef BATTEN_FORM_TESSELLATE_H
#define BATTEN_FORM_TESSELLATE_H

#include "form/surface/steps.h"

/* A row of vertices (u) or a column (v). */
typedef struct bat_tile_stop {
    double beside; /* where normals are taken: at the stop, or just beside it */
    int span;      /* which of bat_steps.span it belongs to */
    bool joint;    /* the next stop is at the same parameter: between them is a crease, and no triangle */
} bat_tile_stop;

struct bat_tessellation {
    size_t count[2]; /* stops of u and v */
    bool wraps[2];   /* triangles join the last stop to the first */
    bat_tile_stop *stop[2];
    double *at[2]; /* parameters */
    double domain[2][2];
    double *points, *normals;
    size_t triangle_count;
    int *triangles;
};

/* The stops of both directions for the steps. */
bat_status bat_stops_create(const bat_surface *surface, const bat_steps *steps, bat_tessellation *out);
/* Evaluates rows and columns, given by their numbers, ascending. */
bat_status bat_tessellation_fill(bat_tessellation *t, const bat_surface *surface, size_t row_count,
                                 const size_t *rows, size_t column_count, const size_t *columns);

#endif
