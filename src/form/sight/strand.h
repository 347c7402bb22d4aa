/* Internal: lines of a scene as polylines in the image, with the means to find their points exactly. */
#ifndef BATTEN_FORM_STRAND_H
#define BATTEN_FORM_STRAND_H

#include "form/trace/meet.h"
#include "form/trace/silhouette.h"
#include <batten/sight.h>

typedef struct bat_bead {
    double uv[4]; /* on the strand's surfaces */
    double t;     /* of its curve */
    vec at;
    double pixel[2], depth;
} bat_bead;

/* Places on a strand are counted in beads: 2.5 is half way from the third to the fourth. */
typedef struct bat_split {
    double place;
    bool corner; /* lines do not go on smoothly */
} bat_split;

typedef struct bat_strand {
    bat_line_kind kind;
    size_t source;
    const bat_surface *side[2]; /* it lies on; NULL: none */
    bat_curve *curve;           /* owned; its points, where it has one */
    int direction;              /* of a parameter line: which of u and v is constant */
    double fixed;
    bat_bead *beads;
    size_t count, room;
    bat_split *splits;
    size_t split_count, split_room;
} bat_strand;

typedef struct bat_sight_scene {
    const bat_line_scene *scene;
    bat_gaze gaze;
    bat_surface_finder **finders;
    bat_strand *strands;
    size_t count, room;
    double near; /* depth before which nothing is drawn */
    bool whole;
} bat_sight_scene;

/* All strands of the scene. */
bat_status bat_strands_make(bat_sight_scene *s);
void bat_strands_free(bat_sight_scene *s);
/* The exact point of a strand at a place. */
void bat_strand_locate(const bat_sight_scene *s, const bat_strand *strand, double place, bat_bead *out);
/* How far the image of what lies between two beads is from the window and as much again around it, in pixels: there lines are
 * coarse, so that no work goes into what is not seen. 0: within, or not all of it is before the eye. */
double bat_sight_beyond(const bat_sight_scene *s, const bat_bead *a, const bat_bead *b);
/* det(S_u, S_v, gaze) of a surface, and its derivatives (may be NULL). */
double bat_strand_facing(const bat_sight_scene *s, const bat_surface *surface, const double uv[2],
                         double gradient[2]);
bat_status bat_strand_split(bat_strand *strand, double place, bool corner);

/* What is all seen or all hidden; the list is the caller's to free. */
typedef struct bat_seen_stretch {
    double from, to;
    bool hidden;
} bat_seen_stretch;
bat_status bat_strand_stretches(const bat_sight_scene *s, const bat_strand *strand, bat_seen_stretch **out,
                                size_t *count);

/* Checks the data and makes the strands, split; free with bat_sight_close. */
bat_status bat_sight_open(bat_sight_scene *s, const bat_viewpoint *view, const bat_line_scene *scene);
void bat_sight_close(bat_sight_scene *s);

/* Finds where visibility can change, in order. */
bat_status bat_strands_split(bat_sight_scene *s);

#endif
