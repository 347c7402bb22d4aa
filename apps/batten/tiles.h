/* A drawing in its true size, over as many sheets of paper as it needs. */
#ifndef BATTEN_APPS_TILES_H
#define BATTEN_APPS_TILES_H

#include "paint_cairo.h"

enum { TILES_MAX = 400 }; /* sheets */

typedef struct tiles_layout {
    double sheet[2];          /* mm */
    double margin[2];         /* mm around what a sheet shows: what printers leave white */
    double shown[2], step[2]; /* mm of the drawing on each sheet, and from one to the next */
    double count[2];          /* columns and rows, whole numbers */
} tiles_layout;

/* "A4", "letter", "100x150mm": two sides in mm. False: it is no such size. */
bool tiles_sheet(const char *text, double sheet[2]);
/* How much of a drawing a sheet shows, mm: a tenth of the shorter side, at most 10 mm, is left white around it. */
void tiles_room(const double sheet[2], double room[2]);
/* size: of the drawing, mm. A side that fits the sheet is shown whole, in the middle. overlap: less than both of tiles_room. */
void tiles_plan(const double size[2], const double sheet[2], double overlap, tiles_layout *out);

/* Makes the PDF, as paint_document does: a page a sheet, row by row, with marks where to cut, its row and column, and a square of
 * 50 mm on the first to check the printer by (of 20 or 10 on sheets too small for it). At most TILES_MAX sheets. */
const char *tiles_paint(const bat_document *document, const double view[4], const tiles_layout *layout,
                        uint32_t background, unsigned char **data, size_t *size, paint_left *left);

#endif
