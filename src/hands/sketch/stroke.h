/* Inside the sketch hand: a pen stroke made clean (docs/math sketch 5.2). All lengths in pixels. */
#ifndef BATTEN_HANDS_SKETCH_STROKE_H
#define BATTEN_HANDS_SKETCH_STROKE_H

#include <batten/sketch.h>

typedef struct bat_clean {
    int dimension;
    size_t count;
    double *points; /* resampled by arc length; owned */
    double *arc;    /* arc[i]: length from the start; owned */
    double length;
    double sigma; /* noise */
    double grain; /* size of what is drawn */
    double share; /* of the tolerance, that a drawing of this size can bear */
    size_t corner_count;
    size_t *corners; /* indices of kept corners, ascending, ends excluded; owned */
} bat_clean;

/* What a live session has shown long enough: smoothed samples that stay where they are, or nearly. Owned by the session.
 */
typedef struct bat_clean_memory {
    double *points; /* in pixels, one for each finite, distinct sample */
    size_t count, room;
    size_t fixed; /* so many of the first stay where they are; the others move a little */
    size_t fresh; /* so many of the last samples were not shown long enough */
} bat_clean_memory;

typedef struct bat_clean_options {
    double scale;             /* 1 / pixel: document units to pixels */
    const double *origin;     /* subtracted first */
    double tolerance;         /* pixels */
    bool corners;             /* look for corners */
    bat_clean_memory *memory; /* NULL except while the pen is down */
} bat_clean_options;

/* BAT_DOT when nothing is left that is 8 px long. NaN and infinite samples are dropped. */
bat_status bat_clean_stroke(const bat_stroke *stroke, const bat_clean_options *options, bat_clean *out);
void bat_clean_free(bat_clean *clean);
void bat_clean_reverse(bat_clean *clean);
/* The point at arc length s (clamped), linear between samples. */
void bat_clean_at(const bat_clean *clean, double s, double *point);
/* Direction (unit) and curvature vector at arc length s, from a quadratic least-squares fit over `window` px
 * that stays inside the stroke. */
void bat_clean_frame(const bat_clean *clean, double s, double window, double *point, double *direction,
                     double *curvature);
/* Sum of absolute turning angles along the stroke, radians. */
double bat_clean_turning(const bat_clean *clean);
/* Keeps samples first..last only. */
void bat_clean_cut(bat_clean *clean, size_t first, size_t last);
/* Whether the ends meet as those of a closed figure do. */
bool bat_clean_closes(const bat_clean *clean);

#endif
