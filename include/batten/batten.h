/* Batten: everything. */
#ifndef BATTEN_BATTEN_H
#define BATTEN_BATTEN_H

#include <batten/base.h>
#include <batten/types.h>
#include <batten/camera.h>
#include <batten/curve.h>
#include <batten/refine.h>
#include <batten/bezier.h>
#include <batten/drag.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/relate.h>
#include <batten/blend.h>
#include <batten/region.h>
#include <batten/width.h>
#include <batten/fit.h>
#include <batten/interpolate.h>
#include <batten/frames.h>
#include <batten/function.h>
#include <batten/sketch.h>
#include <batten/tangents.h>
#include <batten/levels.h>
#include <batten/surface.h>
#include <batten/check.h>
#include <batten/relief.h>
#include <batten/mesh.h>
#include <batten/compare.h>
#include <batten/wires.h>
#include <batten/sweep.h>
#include <batten/recipe.h>
#include <batten/view.h>
#include <batten/trace.h>
#include <batten/sight.h>
#include <batten/motion.h>
#include <batten/document.h>
#include <batten/paint.h>
#include <batten/format.h>
#include <batten/format_space.h>
#include <batten/input.h>
#include <batten/frame.h>
#include <batten/panels.h>
#include <batten/editor.h>
#ifndef BATTEN_ONLY_0_2
#include <batten/before_0_2.h>
#endif

#endif
