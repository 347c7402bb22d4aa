/* Grounds: what the pen draws on. The page is one, a plane in space another. A ground is a row of the table in
 * ground.c: it defines where the ray that the view sends through a pixel meets the ground. */
#ifndef BATTEN_EDITOR_VIEW_GROUND_H
#define BATTEN_EDITOR_VIEW_GROUND_H

#include <batten/document.h>

enum { BAT_GROUND_NUMBERS = 9 };

/* From the eye: a point on the ray, and its direction, of length 1. */
typedef struct bat_ray {
    double from[3], along[3];
} bat_ray;

/* A point on the ground: in space (on the page z is 0), in the ground's own coordinates, and the length of a view
 * pixel there in document units. */
typedef struct bat_hit {
    double at[3], own[2], pixel;
} bat_hit;

typedef struct bat_ground bat_ground;

typedef struct bat_ground_type {
    const char *name; /* as written in journals */
    int dimension;    /* of curves drawn on it: 2 on the page, otherwise 3 */
    int numbers;      /* how many numbers describe its position, at most BAT_GROUND_NUMBERS */
    bool (*good)(const double *numbers);
    /* out->pixel is preset to its length across the ray. BAT_SINGULAR: seen edge-on; BAT_NUMBER: too far away. */
    bat_status (*hit)(const bat_ground *ground, const bat_ray *ray, bat_hit *out);
} bat_ground_type;

struct bat_ground {
    const bat_ground_type *type;
    double numbers[BAT_GROUND_NUMBERS]; /* unused ones are 0 */
    bat_id object;                      /* the ground as an object; 0: not in the document */
};

bat_ground bat_ground_page(void);
/* The object as a ground; false: it cannot be drawn on. */
bool bat_ground_of(const bat_object *object, bat_ground *out);
/* The names by index; NULL after the last. */
const char *bat_ground_name(int index);
/* The ground with this name and these numbers; false: no such name, or the numbers do not describe such a ground. */
bool bat_ground_named(const char *name, int count, const double *numbers, bat_ground *out);
/* Two directions that span it, of length 1, at right angles. */
void bat_ground_axes(const bat_ground *ground, double x[3], double y[3]);
/* Whether both lie in the same place, whichever object they are. */
bool bat_ground_same(const bat_ground *a, const bat_ground *b);

#endif
