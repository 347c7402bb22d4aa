/* Grounds: what the pen draws on: the page, a plane in space, the ruled surface of a curve in space, a surface. A ground
 * is a row of the table in ground.c: it defines where the ray that the view sends through a pixel meets the ground. */
#ifndef BATTEN_EDITOR_VIEW_GROUND_H
#define BATTEN_EDITOR_VIEW_GROUND_H

#include <batten/document.h>

enum { BAT_GROUND_NUMBERS = 9 };

/* From the eye: a point on the ray, and its direction, of length 1. */
typedef struct bat_ray {
    double from[3], along[3];
} bat_ray;

/* A point on the ground: in space (on the page z is 0), in the ground's own coordinates, the ground's normal there, and
 * the length of a view pixel there in document units. */
typedef struct bat_hit {
    double at[3], own[2], normal[3], pixel;
    bool beside; /* beside the surface, on the plane that touched it where the stroke left it */
} bat_hit;

typedef struct bat_ground bat_ground;
struct bat_casters; /* casters.h */

typedef struct bat_ground_type {
    const char *name; /* as written in journals */
    int dimension;    /* of curves drawn on it: 2 on the page, otherwise 3 */
    int numbers;      /* how many numbers describe its position, at most BAT_GROUND_NUMBERS */
    bool (*good)(const double *numbers);
    /* last: of the sample before on the same stroke, or NULL. out->pixel is preset to its length across the ray.
     * BAT_SINGULAR: seen edge-on; BAT_NUMBER: too far away; BAT_FAR: the ray misses it; BAT_STATE: the document does not
     * have it; BAT_MEMORY. */
    bat_status (*hit)(const bat_ground *ground, struct bat_casters *casters, const bat_ray *ray,
                      const bat_hit *last, bat_hit *out);
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
/* The plane through a point, spanned by two axes of length 1 at right angles. */
bat_ground bat_ground_plane(const double origin[3], const double x[3], const double y[3]);
/* The same as a plane that a view brings along, which is no object of the drawing. */
bat_ground bat_ground_of_view(const double origin[3], const double x[3], const double y[3]);
bool bat_ground_is_of_view(const bat_ground *ground);
/* The ruled surface of a curve of an object: the curve's points moved along a direction of length 1. */
bat_ground bat_ground_ruled(bat_id object, int curve, const double along[3]);
/* Whether it is the ruled surface of this curve. */
bool bat_ground_rules(const bat_ground *ground, bat_id object, int curve);
/* Whether rays can miss it. */
bool bat_ground_bounded(const bat_ground *ground);
/* Two directions that span it, of length 1, at right angles; for what is not a plane those of the page. */
void bat_ground_axes(const bat_ground *ground, double x[3], double y[3]);
/* A place of a plane or the page, from its own coordinates. */
void bat_ground_at(const bat_ground *ground, const double own[2], double at[3]);
/* Whether both lie in the same place, whichever object they are. */
bool bat_ground_same(const bat_ground *a, const bat_ground *b);

#endif
