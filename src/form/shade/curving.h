/* Internal to pictures: the curvature that a look colours, at the vertices of triangles. */
#ifndef BATTEN_FORM_CURVING_H
#define BATTEN_FORM_CURVING_H

#include "form/shade/shade.h"

/* At a vertex of the mesh, by its row and column: the curvature of the look, or 0 for looks without one; where there is
 * none (a pole), that of a place just inside. */
double bat_curving_value(const bat_surface *surface, const bat_mesh *mesh, size_t row, size_t column,
                         bat_look look);
/* The range of colours: the size of all but the most extreme values. Overwrites them; 0 when there are none. */
double bat_curving_range(size_t count, double *values);

#endif
