/* Inside the sketch hand: a polyline with its arc lengths. */
#ifndef BATTEN_HANDS_SKETCH_PATH_H
#define BATTEN_HANDS_SKETCH_PATH_H

#include <batten/base.h>

typedef struct bat_stroke_path {
    const double *points, *arc; /* arc[i]: length from the start */
    size_t count, m;
} bat_stroke_path;

double bat_path_distance(const double *a, const double *b, size_t m);
/* Writes the arc lengths of a polyline. */
void bat_path_measure(const double *points, size_t count, size_t m, double *arc);
/* The point at arc length s (clamped), linear between samples. */
void bat_path_at(const bat_stroke_path *path, double s, double *out);
/* The same for places in ascending order, of 2 samples or more; *at: 0 for the first. */
void bat_path_walk(const bat_stroke_path *path, double s, size_t *at, double *out);
/* The angle by which the way through a, b, c turns at b: 0 when straight on. */
double bat_path_turn(const double *a, const double *b, const double *c, size_t m);

#endif
