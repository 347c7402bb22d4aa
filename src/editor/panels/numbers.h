/* Numeric values of what is chosen, read and entered as text. */
#ifndef BATTEN_EDITOR_PANELS_NUMBERS_H
#define BATTEN_EDITOR_PANELS_NUMBERS_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include "editor/view/unit.h"

/* The value in document units, or degrees; positions along an axis count from the page's corner. False: there is no
 * such value now. */
bool bat_number_now(bat_context *c, bat_number_id id, double *value);

#endif
