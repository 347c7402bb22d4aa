/* A curve inside a drawing has an address, FILE#NAME or FILE#NAME/N: an object's name or id, and which of its curves
 * (0 by default). A result can go back to the place where a curve was read. */
#ifndef BATTEN_APPS_ADDRESS_H
#define BATTEN_APPS_ADDRESS_H

#include "drawing.h"
#include "program.h"

#include <batten/curve.h>
#include <batten/document.h>

/* Whether the word is an address: it has a '#' with something before and behind it, and no file has that name. */
bool is_address(const char *word);
/* Whether it is the object's name, or its id. */
bool address_names(const bat_object *object, const char *name);
/* A copy of the curve there. The drawing of the first address is kept until address_release. Returns 0, or an exit
 * status after reporting the failure. */
int address_read(const char *word, bat_curve **out);
/* The same as a drawing of one curve. */
int address_read_drawing(const char *word, drawing_file *out);
/* Writes the drawing of the first address to a file, with another curve in its place; over the file that it came from only
 * if nothing is lost, or lossy. */
int address_write(const bat_curve *curve, const char *file, bool lossy);
void address_release(void);

#endif
