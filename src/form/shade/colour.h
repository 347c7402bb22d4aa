/* Internal to pictures: the colour of a sample. */
#ifndef BATTEN_FORM_COLOUR_H
#define BATTEN_FORM_COLOUR_H

#include "form/shade/shade.h"

/* A place of a surface as it is seen. Directions are right, up, towards the eye. */
typedef struct bat_seen_place {
    double normal[3], eye[3]; /* unit: on the side that is seen; towards the eye */
    bool back;                /* the side away from the surface's normal is seen */
    double share;             /* of the range of curvature */
    double soft;              /* zebra: by how much the wave changes over the edge of a stripe */
} bat_seen_place;

/* out: red, green, blue in 0..1. */
void bat_shade_colour(bat_look look, uint32_t colour, const bat_seen_place *place, double out[3]);
/* Zebra: from -1 to 1, light stripes above 0. */
double bat_shade_wave(const bat_seen_place *place);
/* The colour of a share of the range, -1 to 1, without light: for a legend. */
void bat_shade_legend(double share, double out[3]);

#endif
