/* What is compared: the curves, surfaces and meshes of a file, or of one object of a drawing. */
#ifndef BATTEN_APPS_COMPARED_H
#define BATTEN_APPS_COMPARED_H

#include "program.h"

#include "format/model/drawn.h"

#include <batten/compare.h>

/* One of the three. */
typedef struct compared_thing {
    uint64_t id; /* of the object; 0: none */
    char *name;
    bat_curve *curve;
    bat_surface *surface;
    bat_polymesh *mesh;
} compared_thing;

typedef struct compared {
    size_t count;
    compared_thing *things;
    double scale; /* millimetres of a unit; 0: bare numbers */
    bat_unit unit;
    bool is_model;   /* of a file of shapes in space, which lies in its page as on a wall */
    bat_stand stand; /* of a drawing's page */
} compared;

/* word: a file, or FILE#NAME, an object of a drawing by its name or id. Returns 0, or an exit status after reporting the failure. */
int compared_read(const char *word, compared *out);
/* Moves b into the units and the page of a: bare numbers stay, and the page of a model stands as that of the drawing. */
int compared_align(const compared *a, compared *b);
/* What distances are measured to; borrows the things. */
bat_status compared_reference(const compared *of, bat_reference **out);
void compared_clear(compared *all);

#endif
