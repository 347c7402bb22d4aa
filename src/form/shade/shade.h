/* Pictures of surfaces: triangles in a view, a depth for each of 3 x 3 samples a pixel, and a colour by the look. The same
 * bits everywhere. */
#ifndef BATTEN_FORM_SHADE_H
#define BATTEN_FORM_SHADE_H

#include <batten/mesh.h>
#include <batten/view.h>

enum {
    BAT_SHADE_SIDE = 3,            /* samples of a pixel across and down */
    BAT_SHADE_PIXELS_MAX = 1 << 24 /* of a picture */
};

typedef enum bat_look {
    BAT_LOOK_SHADED,
    BAT_LOOK_ZEBRA,
    BAT_LOOK_GAUSS,
    BAT_LOOK_MEAN,
    BAT_LOOK_LINES, /* paper: hides what is behind it, and is as light as that */
    BAT_LOOK_COUNT
} bat_look;

typedef struct bat_shaded {
    const bat_surface *surface;
    uint32_t colour;          /* 0xRRGGBBAA, without alpha; 0: that of clay */
    const bat_polymesh *mesh; /* not NULL: in place of the surface; it has no curvature */
} bat_shaded;

typedef struct bat_shading {
    int width, height;
    uint8_t *rgba; /* of each pixel, by rows; multiplied by alpha */
    float *
        depth; /* of each sample, 3 width x 3 height: distance from the eye along the gaze; INFINITY: nothing */
    double range; /* curvature: the colours run from -range to range */
} bat_shading;

/*
 * Shades surfaces as they are seen; the view's size is that of the picture, in whole pixels. Chords of the triangles are
 * within 0.1 pixels. What is behind the eye, or in perspective nearer than a thousandth of the target's distance, is cut
 * off. Statuses as bat_viewpoint_check; BAT_ARGUMENT: the size is not whole; BAT_COUNT: too many pixels. Free with
 * bat_shading_free. O(samples + triangles).
 */
bat_status bat_shade(const bat_viewpoint *view, size_t count, const bat_shaded *surfaces, bat_look look,
                     bat_shading **out);
void bat_shading_free(bat_shading *shading); /* NULL is fine */
/* Whether a point is behind what was shaded; up to `slack` behind it, it is not, nor where the surface ends
 * within a sample of it. pixel and depth: as bat_viewpoint_project gives them. */
bool bat_shading_hides(const bat_shading *shading, const double pixel[2], double depth, double slack);

#endif
