/* What paints an object beyond its style: immutable, reference-counted, shared by the copies of an object. */
#ifndef BATTEN_DOCUMENT_PAINT_H
#define BATTEN_DOCUMENT_PAINT_H

#include <batten/paint.h>

typedef struct bat_painted bat_painted;
/* The parts of a paint that can change alone. */
typedef enum bat_paint_part {
    BAT_PAINT_FILL,
    BAT_PAINT_STROKE,
    BAT_PAINT_LINE,
    BAT_PAINT_PARTS
} bat_paint_part;

/* There is nothing in it. */
bool bat_paint_is_plain(const bat_paint *paint);
/* Copies the paint. *out NULL with BAT_OK: there is nothing in it. */
bat_status bat_painted_create(const bat_paint *paint, bat_painted **out);
bat_painted *bat_painted_retain(const bat_painted *painted); /* NULL is fine, here and below */
void bat_painted_release(bat_painted *painted);
const bat_paint *bat_painted_paint(const bat_painted *painted);
/* 0: nothing is in it. */
uint64_t bat_painted_digest(const bat_painted *painted);
uint64_t bat_paint_digest(const bat_paint *paint, bat_paint_part part);
/* Mapped by the matrix, with dashes longer by the factor. What cannot be mapped is left out. */
bat_paint bat_paint_mapped(const bat_paint *paint, const double matrix[6], double longer,
                           double dashes[BAT_DASHES_MAX]);
/* A pattern of that picture; alpha: 0 to 255. Fills in the stops, to which it refers. */
bat_gradient bat_paint_pattern(const bat_picture *tile, const double matrix[6], uint32_t alpha,
                               bat_stop stops[2]);
/* The pen of a paint: the identity where it is round. */
void bat_paint_pen(const bat_paint *paint, double pen[4]);

#endif
