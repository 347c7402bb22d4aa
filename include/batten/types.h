/* Batten: the names of the types that several headers speak of only by pointer. Their own headers say what they are. */
#ifndef BATTEN_TYPES_H
#define BATTEN_TYPES_H

typedef struct bat_camera bat_camera;                     /* <batten/camera.h> */
typedef struct bat_canvas bat_canvas;                     /* <batten/view.h> */
typedef struct bat_curve bat_curve;                       /* <batten/curve.h> */
typedef struct bat_document bat_document;                 /* <batten/document.h> */
typedef struct bat_motion bat_motion;                     /* <batten/motion.h> */
typedef struct bat_motion_report bat_motion_report;       /* <batten/motion.h> */
typedef struct bat_polymesh bat_polymesh;                 /* <batten/mesh.h> */
typedef struct bat_recipe bat_recipe;                     /* <batten/recipe.h> */
typedef struct bat_relief bat_relief;                     /* <batten/relief.h> */
typedef struct bat_shape bat_shape;                       /* <batten/levels.h> */
typedef struct bat_sketch_options bat_sketch_options;     /* <batten/sketch.h> */
typedef struct bat_spline bat_spline;                     /* <batten/tangents.h> */
typedef struct bat_stroke bat_stroke;                     /* <batten/sketch.h> */
typedef struct bat_surface bat_surface;                   /* <batten/surface.h> */
typedef struct bat_sweep bat_sweep;                       /* <batten/sweep.h> */
typedef struct bat_take bat_take;                         /* <batten/motion.h> */
typedef struct bat_tangents_options bat_tangents_options; /* <batten/tangents.h> */
typedef struct bat_viewpoint bat_viewpoint;               /* <batten/view.h> */
typedef struct bat_wire bat_wire;                         /* <batten/wires.h> */
typedef struct bat_wire_options bat_wire_options;         /* <batten/wires.h> */

#endif
