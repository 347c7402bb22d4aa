/* A document's page, its physical size and how it stands, together. */
#ifndef BATTEN_SRC_SHEET_H
#define BATTEN_SRC_SHEET_H

#include "document/document.h"

typedef struct bat_sheet {
    double page[4]; /* x, y, width, height in document units; width 0: no page */
    double scale;   /* millimetres of a unit */
    bat_unit unit;
    bat_stand stand; /* how the page stands in a room */
} bat_sheet;

bat_sheet bat_sheet_of(const bat_document *document);
/* BAT_NUMBER: out of range; the document is as it was. */
bat_status bat_sheet_put(bat_document *document, const bat_sheet *sheet);
bool bat_sheet_has_page(const bat_sheet *sheet);
bool bat_sheet_same(const bat_sheet *a, const bat_sheet *b); /* bit for bit */

/* A page of another width and height, in units of `now`, whose upper left corner stays where it is. */
bat_sheet bat_sheet_resized(const bat_sheet *now, const double size[2]);
/* The same page with everything on it: a unit becomes longer or shorter, so that what filled the page fits the new one, in
 * its middle. Needs a page. */
bat_sheet bat_sheet_scaled(const bat_sheet *now, const double size[2]);

#endif
