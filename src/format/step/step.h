/* Internal to STEP: the instances of a file, and what of them is a B-spline. */
#ifndef BATTEN_FORMAT_STEP_H
#define BATTEN_FORMAT_STEP_H

#include "format/model/full.h"
#include "format/model/model.h"
#include "format/step/tokens.h"

/* What the names of an instance say of it. */
enum {
    BAT_STEP_CURVE = 1,   /* a B-spline curve, of any kind */
    BAT_STEP_SURFACE = 2, /* a B-spline surface */
    BAT_STEP_BOUNDS = 4,  /* refers to curves that bound something */
    BAT_STEP_LENGTH = 8,  /* a unit of length */
    BAT_STEP_UNITS = 16,  /* a context with units */
    BAT_STEP_PLAIN = 32,  /* says nothing of its own about shape */
    BAT_STEP_POINT = 64,
    BAT_STEP_FACE = 128 /* a part of a surface, or all of it */
};

typedef struct bat_step_instance {
    double id;
    bat_step_place body; /* after the = */
    int flags;
    bool bounds; /* a curve that belongs to the boundary of something */
} bat_step_instance;

typedef struct bat_step_file {
    const char *end;
    bat_step_instance *list; /* by ascending id */
    size_t count;
} bat_step_file;

/* Fills problem with the line. Returns status. */
bat_status bat_step_wrong(const bat_step_place *at, bat_status status, const char *message,
                          bat_problem *problem);

/* The instances of all DATA sections. Release with bat_free(list). BAT_SYNTAX, BAT_MEMORY. */
bat_status bat_step_index(const char *text, size_t size, bat_step_file *out, bat_problem *problem);
/* NULL: there is none. */
bat_step_instance *bat_step_find(const bat_step_file *file, double id);

/* Whether a face is all of its surface: what bounds it are at most two seams, each there and back. O(log instances). */
bool bat_step_is_whole(const bat_step_file *file, const bat_step_instance *face);

/* Millimetres of the file's unit of length; 1 when it has none. BAT_UNSUPPORTED: several that differ. */
bat_status bat_step_unit(const bat_step_file *file, double *out, bat_problem *problem);

/* A B-spline as it is written. */
typedef struct bat_step_spline {
    int directions;
    double degree[2];
    size_t rows;         /* of a surface's points */
    bat_numbers points;  /* ids */
    bat_numbers many[2]; /* the multiplicities of knots */
    bat_numbers knots[2];
    bat_numbers weights;
    char
        form; /* how knots follow from degree and count where they are left out: 'B'ezier, 'U'niform, 'Q'uasi-uniform */
} bat_step_spline;
/* The lists of *out are released by bat_step_spline_clear, whatever it returns. */
bat_status bat_step_read_spline(const bat_step_instance *instance, bat_step_spline *out,
                                bat_problem *problem);
void bat_step_spline_clear(bat_step_spline *spline);

#endif
