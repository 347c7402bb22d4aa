/* Internal to DXF: what a file holds, as curves in the document's axes with their layers and colours.
 *
 * The axes of DXF, y upwards and z towards the eye, are those of a document turned by half a turn about x: (x, -y, -z). One
 * unit of a document that was read is a millimetre; written are millimetres from its lower left corner. */
#ifndef BATTEN_FORMAT_DXF_H
#define BATTEN_FORMAT_DXF_H

#include "format/dxf/pairs.h"
#include "text/text.h"

#include <batten/document.h>
#include <batten/format.h>

typedef struct bat_dxf_layer {
    char *name;      /* UTF-8 */
    uint32_t colour; /* 0xRRGGBBAA */
    double width;    /* millimetres; 0: none is given */
    bool hidden, locked;
    size_t shapes; /* how many are on it */
} bat_dxf_layer;

typedef struct bat_dxf_shape {
    bat_curve *curve;
    size_t layer;
    uint32_t colour;
    double width;
    bool hidden;
} bat_dxf_shape;

typedef struct bat_dxf {
    size_t layer_count, layer_room, shape_count, shape_room;
    bat_dxf_layer *layers;
    bat_dxf_shape *shapes;
    bat_unit unit; /* of the file; mm where it says none */
} bat_dxf;

bat_status bat_dxf_parse(const bat_svg_options *how, const char *text, size_t size, bat_dxf *out,
                         bat_losses *lost, bat_problem *problem);
void bat_dxf_clear(bat_dxf *dxf);

/* ---- one entity ---- */

/* Where entities are put: rows of x y z 1 to x y z of the document. */
typedef struct bat_dxf_place {
    double m[12];
} bat_dxf_place;
bat_dxf_place bat_dxf_within(const bat_dxf_place *outer, const bat_dxf_place *inner);
/* The axes that an entity with this extrusion is drawn in (the "arbitrary axis algorithm"). */
bat_dxf_place bat_dxf_axes(const double extrusion[3]);
/* The unit vector across two, or 0 where they are parallel. */
void bat_dxf_across(const double a[3], const double b[3], double out[3]);
/* out may be the point itself. */
void bat_dxf_put(const bat_dxf_place *place, const double point[3], double out[3]);

/* The curve of an entity. vertices: of a POLYLINE. *out NULL with BAT_OK: it is no curve, or one that cannot be held. */
bat_status bat_dxf_curve(const bat_dxf_record *entity, const bat_dxf_record *vertices, size_t vertex_count,
                         const bat_dxf_place *place, const bat_svg_options *how, bat_curve **out,
                         bat_problem *problem);
bool bat_dxf_is_curve(const bat_dxf_record *entity); /* by its name */

/* ---- colours ---- */

uint32_t
bat_dxf_colour(int index); /* of AutoCAD's 255, as 0xRRGGBBff; white, which paper would hide, as black */
int bat_dxf_index_near(uint32_t colour); /* the one that is nearest */

#endif
