/* Internal to STEP: instances as they are written. Each takes the number of the next instance, writes as many as it needs, of
 * which the last is what is meant, and returns the number after it. */
#ifndef BATTEN_FORMAT_STEP_PUT_H
#define BATTEN_FORMAT_STEP_PUT_H

#include "format/model/full.h"

void bat_step_put_id(bat_text *text, uint64_t id);
/* (#1,#2,...) */
void bat_step_put_list(bat_text *text, const bat_numbers *ids);
uint64_t bat_step_put_point(bat_text *text, uint64_t id, const double *point, int size);
uint64_t bat_step_put_curve(bat_text *text, uint64_t id, const bat_curve *curve);
uint64_t bat_step_put_surface(bat_text *text, uint64_t id, const bat_surface *surface);

/* Whether the surface alone bounds a solid: it is closed in both directions, or in one, with a point at each end of the other
 * (within 1e-9 of its size). */
bool bat_step_is_solid(const bat_surface *surface);
/* Such a surface, whose normals point outward, as a solid of one face. BAT_MEMORY. */
bat_status bat_step_put_solid(bat_text *text, uint64_t *id, const bat_surface *surface);

#endif
