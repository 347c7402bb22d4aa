/* Internal: samples of a thing that is compared with a reference. */
#ifndef BATTEN_FORM_COMPARE_SUMS_H
#define BATTEN_FORM_COMPARE_SUMS_H

#include "form/compare/seek.h"

enum { BAT_SUMS_PEAKS = 16, BAT_SUMS_MOST = 1 << 24 };

/* A sample from which the greatest distance is sought further. */
typedef struct bat_peak {
    double x[2], step[2]; /* parameters, and how far its neighbours are */
    double distance;
    size_t piece; /* of the thing: the number of a triangle */
} bat_peak;

/* A point of the thing at parameters of a piece, which are first moved into what the piece covers. */
typedef void bat_sums_place(const void *thing, size_t piece, double x[2], double point[3]);

/* A sum of weighted squares, as shares of the greatest of them, so that none is lost below what a double holds. */
typedef struct bat_squares {
    double greatest, sum; /* greatest: the root of the greatest square */
} bat_squares;

typedef struct bat_sums {
    const bat_reference *reference;
    const void *thing;
    bat_sums_place *place;
    bat_seek seek;
    bat_deviation found;           /* mean: a sum */
    double plain;                  /* a sum without weights */
    bat_squares weighted, squares; /* with weights and without */
    double reach; /* the greatest coordinate: distances are rounded to some of its last bits */
    bat_peak peaks[BAT_SUMS_PEAKS],
        piece; /* the greatest of as many pieces, falling; that of the piece in hand */
    size_t peak_count;
} bat_sums;

/* How far samples are apart at most; 0: 1/32 of the size. BAT_ARGUMENT: it is below 0 or not a number. */
bat_status bat_sums_begin(bat_sums *sums, double spacing, double size);
/* Begins a piece (a span, a triangle); ends the one before. */
void bat_sums_piece(bat_sums *sums, size_t piece, const double step[2]);
/* The distance at a place of the piece in hand, with a weight in the sums. */
bat_status bat_sums_add(bat_sums *sums, const double x[2], double weight, double *distance);
/* The same with a distance that is known already, and counts as no sample. */
void bat_sums_weigh(bat_sums *sums, const double x[2], double distance, double weight);
/* Seeks the greatest distance from the peaks; hands over what was found. */
bat_status bat_sums_finish(bat_sums *sums, bat_deviation *out);

#endif
