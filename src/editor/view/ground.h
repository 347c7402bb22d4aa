/* What the pen draws on. The page is one ground among others; a plane in space is the second. A ground is a row of the
 * table in ground.c: what it does with the ray that the view sends through a pixel. */
#ifndef BATTEN_EDITOR_VIEW_GROUND_H
#define BATTEN_EDITOR_VIEW_GROUND_H

#include <batten/document.h>

enum { BAT_GROUND_NUMBERS = 9 };

/* From the eye: a place on it, and its direction, of length 1. */
typedef struct bat_ray {
    double from[3], along[3];
} bat_ray;

/* A place on the ground: in space (on the page z is 0), in coordinates of the ground's own, and the length of a view pixel
 * there, document units. */
typedef struct bat_hit {
    double at[3], own[2], pixel;
} bat_hit;

typedef struct bat_ground bat_ground;

typedef struct bat_ground_type {
    const char *name; /* in journals */
    int dimension;    /* of curves drawn on it: 2 on the page, else 3 */
    int numbers;      /* that say where it lies, BAT_GROUND_NUMBERS at most */
    bool (*good)(const double *numbers);
    /* out->pixel is set before: what it is across the ray. BAT_SINGULAR: seen edge-on; BAT_NUMBER: too far away. */
    bat_status (*hit)(const bat_ground *ground, const bat_ray *ray, bat_hit *out);
} bat_ground_type;

struct bat_ground {
    const bat_ground_type *type;
    double numbers[BAT_GROUND_NUMBERS]; /* those not used are 0 */
    bat_id object;                      /* that it is; 0: none of the document */
};

bat_ground bat_ground_page(void);
/* The object as a ground; false: nothing is drawn on it. */
bool bat_ground_of(const bat_object *object, bat_ground *out);
/* The names, by number; NULL after the last. */
const char *bat_ground_name(int index);
/* Of this name with these numbers; false: there is none, or the numbers are no such ground. */
bool bat_ground_named(const char *name, int count, const double *numbers, bat_ground *out);
/* Whether both lie alike, whatever object they are. */
bool bat_ground_same(const bat_ground *a, const bat_ground *b);

#endif
