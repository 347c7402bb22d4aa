/* An object as buffers in space, which stay as they are while the view turns: lines, and of a surface triangles. */
#ifndef BATTEN_EDITOR_SCENE_SOLID_H
#define BATTEN_EDITOR_SCENE_SOLID_H

#include "form/mesh/facets.h"
#include "form/shade/shade.h"
#include <batten/document.h>
#include <batten/frame.h>

enum { BAT_SOLID_CORNER = 7, BAT_SOLID_POINT = 4 }; /* numbers of a vertex: of triangles, of a line */

/* How finely, about which origin, and for which look. */
typedef struct bat_grain {
    double origin[3]; /* subtracted from all points */
    int scale;        /* chords are within a tenth of a view pixel at 2^scale pixels a unit */
    bat_look look;
} bat_grain;

/* A surface in place of an object's: as a stroke under way would make it. It differs where the parameter of the direction
 * lies between moved[0] and moved[1] (bat_surface_redraw_report). */
typedef struct bat_guise {
    bat_id object;
    const bat_surface *surface; /* borrowed */
    bat_direction direction;
    double moved[2];
} bat_guise;
enum { BAT_GUISES = 2 }; /* at a time */

typedef struct bat_solid {
    bat_grain grain;
    uint32_t version; /* 0: nothing has been made */
    bat_tessellation *mesh;
    bat_facets facets; /* of a polygon mesh, in its place */
    float *corners;    /* of the triangles */
    uint32_t moved
        [4]; /* first row, end of the rows, first column, end of the columns that the last update moved */
    uint32_t line_version;
    float *points; /* of the lines; the first and the last are there twice */
    uint32_t point_count;
    float low[3], high[3]; /* of all */
    bool old;              /* the object has been replaced since: set by the scene */
    bool coarse;           /* what moved is too bent for its triangles */
    bool guised;           /* it shows a guise, which differs there: */
    bat_direction direction;
    double differs[2];
    /* The outline of a surface in the view that was seen last, as lines; with the versions of the view and of the lines that it
     * belongs to. */
    uint32_t rim_version, rim_view, rim_lines;
    float *rim;
    uint32_t rim_count;
} bat_solid;

/* Brings the buffers up to date; guise NULL: the object as it is. versions: the counter that new versions are taken from.
 * After a failure there is nothing in them. */
bat_status bat_solid_update(bat_solid *solid, const bat_object *object, const bat_grain *grain,
                            const bat_guise *guise, uint32_t *versions);
void bat_solid_clear(bat_solid *solid);
void bat_solid_free(bat_solid *solid); /* one from malloc, or NULL */

/* The picture of all solids, and what it needs to be made again (scene/space.h). */
typedef struct bat_space_kept {
    bat_space space;
    bat_viewpoint seen, before; /* of the picture; of the one before */
    uint32_t views;             /* how often the view has changed */
    bat_space_item *items;
    double origin[3];
    uint32_t measured; /* the newest version among the surfaces when the range of curvature was found */
} bat_space_kept;

void bat_space_free(bat_space_kept *kept); /* NULL is fine */

/* For bat_solid_update: makes the lines of the object anew; surface: in place of its own, or NULL. */
bat_status bat_solid_lines(bat_solid *solid, const bat_object *object, const bat_surface *surface);

/* Makes the outline of the object's surface in the view anew; without a surface, with too many patches, or where it can't be
 * traced, it has none. */
bat_status bat_solid_outline(bat_solid *solid, const bat_object *object, const bat_viewpoint *view);

#endif
