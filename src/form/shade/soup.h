/* Internal to pictures: triangles as they are seen. */
#ifndef BATTEN_FORM_SOUP_H
#define BATTEN_FORM_SOUP_H

#include "form/shade/shade.h"
#include "form/view/view.h"

typedef struct bat_corner {
    double x, y;      /* pixels */
    double far;       /* along the gaze */
    double normal[3]; /* right, up, towards the eye; unit */
    double value;     /* curvature */
} bat_corner;

typedef struct bat_soup {
    bat_gaze gaze;
    bat_corner *corner;
    size_t corners, corner_room;
    int (*triangle)[3];
    int *owner; /* of each triangle: which surface */
    size_t triangles, triangle_room;
} bat_soup;

/* Adds the triangles of a surface, cut off at the near plane. */
bat_status bat_soup_add(bat_soup *soup, const bat_viewpoint *view, const bat_surface *surface, int owner,
                        bat_look look);
bat_status bat_soup_add_mesh(bat_soup *soup, const bat_viewpoint *view, const bat_polymesh *mesh, int owner);
void bat_soup_clear(bat_soup *soup);

#endif
