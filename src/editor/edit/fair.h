/* Fairing a stretch of a curve, as if a smoothing stroke had run along it. */
#ifndef BATTEN_EDITOR_EDIT_FAIR_H
#define BATTEN_EDITOR_EDIT_FAIR_H

#include <batten/sketch.h>

/* The stretch within `reach` of u (along the curve, document units). Closed: it may leave the domain, and is at most
 * one period long. */
void bat_fair_range(const bat_curve *curve, double u, double reach, double range[2]);
/* Fairs the range (closed: in any period); the curve moves by at most `limit` document units. pixel: the length of a
 * view pixel in document units. */
bat_status bat_fair_curve(const bat_curve *curve, const double range[2], double limit, double pixel,
                          bat_curve **out);

#endif
