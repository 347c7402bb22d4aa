/* Units of length, as files say them. */
#ifndef BATTEN_SRC_UNIT_H
#define BATTEN_SRC_UNIT_H

#include <batten/document.h>

/* Millimetres of a px, of which an inch has 96: the scale of documents that say none. */
#define BAT_PX_MILLIMETRES (25.4 / 96)

/* What one is in millimetres; BAT_UNIT_NONE: 1. */
double bat_unit_millimetres(bat_unit unit);
/* "px", "mm", ...; BAT_UNIT_NONE: "". */
const char *bat_unit_name(bat_unit unit);
/* The word of the native format: the name, and "none" of BAT_UNIT_NONE. */
const char *bat_unit_word(bat_unit unit);
/* The unit of such a word; false: of none, and *out stays. */
bool bat_unit_of_word(const char *word, bat_unit *out);
/* The unit of a length such as "210mm", or of its name alone; BAT_UNIT_PX: it has another, or none. */
bat_unit bat_unit_of(const char *length);
/* Whether the unit is one of paper and rulers, not of screens or of none. */
bool bat_unit_is_physical(bat_unit unit);
/* Whether files say that unit and scale: they are neither one px a unit nor bare numbers, of which the native format alone says
 * that they are bare. */
bool bat_unit_is_said_by(bat_unit unit, double scale);

#endif
