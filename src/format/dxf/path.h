/* Lines and arcs that follow each other, as cubic Béziers; without arcs, as a polyline. */
#ifndef BATTEN_FORMAT_DXF_PATH_H
#define BATTEN_FORMAT_DXF_PATH_H

#include "format/dxf/dxf.h"
#include "format/model/full.h"

typedef struct bat_dxf_path {
    bat_numbers points; /* x y z each; three more for each piece after the first point */
    bool begun, curved, failed;
} bat_dxf_path;

void bat_dxf_begin(bat_dxf_path *path, const double at[3]);
/* A line of no length is left out. */
void bat_dxf_line(bat_dxf_path *path, const double to[3]);
/* The points centre + cos t x + sin t y, t in radians; at most 30 degrees a piece. Begins the path if nothing has. */
void bat_dxf_sweep(bat_dxf_path *path, const double centre[3], const double x[3], const double y[3],
                   double from, double to);
/* From where the path is: an arc in the plane of x and y, whose bulge is the tangent of a quarter of its angle. */
void bat_dxf_bulge(bat_dxf_path *path, const double to[3], double bulge);
/* The curve, put in its place; NULL with BAT_OK: it has no length. closed: the path ends where it began. Frees the path. */
bat_status bat_dxf_path_curve(bat_dxf_path *path, bool closed, const bat_dxf_place *place,
                              const bat_svg_options *how, bat_curve **out);

#endif
