/* A shape becomes a path object with one curve per subpath. */
#include "curve/curve.h"
#include "document/clip.h"
#include "document/digest.h"
#include "document/document.h"
#include "document/object.h"
#include "format/svg/digest.h"
#include "format/svg/geometry.h"
#include "format/svg/walk.h"
#include "kinds/primitive.h"

#include <batten/bezier.h>

#include <math.h>
#include <stdlib.h>

static void count_paths(bat_svg_report *report, int curves) {
    report->paths++;
    report->curves += curves;
}

/* The tolerance for one path: an error that is negligible on a large path is large on a small one. */
static double tolerance_for(const bat_svg_options *options, int segments, const double *points) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    if (!(options->share > 0)) return options->tolerance;
    for (size_t i = 0; i < 2 * (3 * (size_t)segments + 1); i++) {
        low[i % 2] = fmin(low[i % 2], points[i]);
        high[i % 2] = fmax(high[i % 2], points[i]);
    }
    return fmin(options->tolerance, options->share * fmax(high[0] - low[0], high[1] - low[1]));
}

/* Where there are markers, their vertices stay: the seam of what is closed, and all if those between are marked. */
static bat_seams joints_for(const bat_markers *markers) {
    if (!markers) return BAT_SEAMS_MERGED;
    return bat_markers_marked(markers)->markers[BAT_MARKER_MID] ? BAT_SEAMS_KEPT : BAT_SEAMS_ENDS;
}

bat_svg_drawn bat_svg_subpath_curve(const bat_outline *outline, int index, const bat_svg_options *options,
                                    const bat_markers *markers, bat_curve **out) {
    const bat_subpath *path = &outline->subpaths[index];
    const double *points = outline->points + 2 * path->first;
    bool moves = false, good = true;
    for (size_t k = 0; k < 2 * (3 * (size_t)path->segments + 1); k++) {
        good = good && fabs(points[k]) <= BAT_COORDINATE_MAX;
        moves = moves || points[k] != points[k % 2];
    }
    if (good && !moves) return BAT_SVG_DOT;
    if (!good) return BAT_SVG_BROKEN;
    double error;
    const bat_status status = bat_curve_from_seams(
        2, 3, path->closed, path->segments, points, options->corner,
        tolerance_for(options, path->segments, points), joints_for(markers), out, &error);
    if (status == BAT_MEMORY) return BAT_SVG_NO_MEMORY;
    return status == BAT_OK || status == BAT_TOLERANCE ? BAT_SVG_CURVE : BAT_SVG_BROKEN;
}

/* A subpath without a length shows its two caps: a line that is too short for more is one, too. */
static bat_svg_drawn make_dot(const bat_outline *outline, int index, double width,
                              const bat_svg_options *options, bat_curve **out) {
    enum { SHARE = 200 }; /* of the stroke's width, on either side */
    const double *at = outline->points + 2 * outline->subpaths[index].first, half = width / SHARE;
    double points[8], error;
    if (!(at[0] - half < at[0] && at[0] < at[0] + half)) return BAT_SVG_DOT; /* too far out for its width */
    for (int k = 0; k < 4; k++) {
        points[2 * k] = at[0] + half * (2 * k - 3) / 3;
        points[2 * k + 1] = at[1];
    }
    const bat_status status = bat_curve_from_bezier(2, 3, false, 1, points, options->corner,
                                                    tolerance_for(options, 1, points), out, &error);
    if (status == BAT_MEMORY) return BAT_SVG_NO_MEMORY;
    return status == BAT_OK || status == BAT_TOLERANCE ? BAT_SVG_CURVE : BAT_SVG_DOT;
}

/* Makes one curve for each subpath that has a length, or is seen without one. */
static int make_curves(bat_svg_walk *w, uint32_t element, const bat_style *style, const bat_markers *markers,
                       bat_curve **curves) {
    const bool dot = style->stroked && style->cap != BAT_CAP_BUTT;
    int count = 0;
    for (int i = 0; i < w->outline.subpath_count && w->status == BAT_OK; i++) {
        bat_svg_drawn what = bat_svg_subpath_curve(&w->outline, i, w->options, markers, &curves[count]);
        if (what == BAT_SVG_DOT && dot)
            what = make_dot(&w->outline, i, style->width, w->options, &curves[count]);
        switch (what) {
        case BAT_SVG_CURVE: count++; break;
        case BAT_SVG_NO_MEMORY: w->status = BAT_MEMORY; break;
        case BAT_SVG_DOT: bat_svg_note(&w->notes, element, dot ? BAT_LOSS_BROKEN : BAT_LOSS_COUNT); break;
        default: bat_svg_note(&w->notes, element, BAT_LOSS_BROKEN); break;
        }
    }
    return count;
}

/* The object with its paint; without, where the paint has numbers that no object can have. Takes the object over. */
static bat_object *with_paint(bat_svg_walk *w, uint32_t element, bat_object *object, const bat_paint *paint) {
    bat_object *made = NULL;
    const bat_status status = bat_object_with_paint(object, paint, &made);
    if (status == BAT_MEMORY) w->status = status;
    if (!made) {
        bat_svg_note(&w->notes, element, BAT_LOSS_GRADIENT);
        return object;
    }
    bat_object_release(object);
    return made;
}

/* The object with its markers. Takes the object over. */
static bat_object *with_markers(bat_svg_walk *w, bat_object *object, const bat_markers *markers) {
    bat_object *made = NULL;
    if (bat_object_with_markers(object, markers, &made) != BAT_OK) w->status = BAT_MEMORY;
    if (!made) return object;
    bat_object_release(object);
    return made;
}

/* Into the document, or into the marker that is drawn. Takes the object over. */
static void put(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, bat_object *object, int curves) {
    if (w->collected && !w->unseen) {
        bat_svg_collect(w, s, object);
    } else if (w->collected) {
        bat_object_release(object);
    } else {
        bat_svg_put_object(w, element, s->style.shown, object);
        if (w->unseen)
            w->report->hidden++;
        else
            count_paths(w->report, curves);
    }
}

/* A rectangle, a circle or an ellipse stays one. */
static void make_shape(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, bat_object **object) {
    bat_svg_shape_holder holder;
    const bat_svg_shape shape = bat_svg_shape_of(w, element, s, &holder);
    bat_primitive own, mapped;
    bat_object *made = NULL;
    if (!bat_svg_shape_primitive(&shape, bat_svg_tree_name(w->tree, element), &own) ||
        !bat_primitive_map(&own, s->matrix, &mapped))
        return;
    const bat_status status = bat_object_with_primitive(*object, &mapped, &made);
    if (status == BAT_MEMORY) w->status = status;
    if (status != BAT_OK) return;
    bat_object_release(*object);
    *object = made;
}

/* What is read again as it was takes no memory of its own. The two documents have about the same order. */
static void share(bat_svg_walk *w, bat_object *object) {
    enum { AHEAD = 16 };
    for (int i = 0; w->like && i < AHEAD; i++) {
        const bat_object *other = bat_document_at(w->like, w->liked + i);
        if (!other) break;
        if (bat_object_share_curves(object, other) == 0) continue;
        w->liked += i;
        break;
    }
    w->liked++;
}

static void add_object(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, const double box[4],
                       const bat_svg_painted *painted, const bat_markers *markers) {
    const bat_style *style = &painted->style;
    const char *name = bat_svg_find_name(w, element);
    bat_curve **curves = malloc((size_t)w->outline.subpath_count * sizeof *curves);
    if (!curves) {
        w->status = BAT_MEMORY;
        return;
    }
    int count = make_curves(w, element, style, markers, curves);
    bat_object *object = NULL;
    bat_status status = w->status;
    if (status == BAT_OK && count > 0)
        status = bat_object_create_path(w->collected ? 1 : bat_document_new_id(w->document), name, style,
                                        count, curves, &object);
    else
        for (int i = 0; i < count; i++) bat_curve_free(curves[i]);
    if (object && count == 1 && !w->collected) make_shape(w, element, s, &object);
    if (object && !bat_paint_is_plain(&painted->paint))
        object = with_paint(w, element, object, &painted->paint);
    if (object && markers) object = with_markers(w, object, markers);
    if (object && bat_svg_clip_object(s, box, &object) == BAT_MEMORY) status = BAT_MEMORY;
    if (object && !w->collected) share(w, object);
    if (object) {
        put(w, element, s, object, count);
    } else if (count > 0 && status != BAT_OK) { /* a stroke width out of bounds */
        bat_svg_note(&w->notes, element, BAT_LOSS_BROKEN);
    }
    if (status == BAT_MEMORY || status == BAT_COUNT) w->status = status;
    free(curves);
}

/* As bat_svg_draw_shape, what is in w->outline. */
static void draw_outline(bat_svg_walk *w, uint32_t element, bat_svg_scope *s, const bat_markers *markers,
                         uint64_t marked) {
    bat_svg_painted painted;
    double box[4];
    bat_outline_box(&w->outline, box);
    bat_outline_transform(&w->outline, s->matrix);
    bat_svg_resolve_style(w, element, s, box, &painted);
    if (s->mask) bat_svg_mask_paint(w, element, box, s);
    w->boxed = w->boxed || s->boxed;
    const bat_style style = painted.style;
    if (!style.stroked && !style.filled && !markers) {
        bat_svg_note(&w->notes, element, BAT_LOSS_INVISIBLE);
        return;
    }
    bat_svg_note_style(w, element, s, &painted);
    if (s->clip_digest && !w->unseen) w->digest = bat_digest_number(w->digest, s->clip_digest);
    if (!w->unseen) w->digest = bat_svg_digest(w->digest, &w->outline, &style, &painted.paint);
    if (markers && !w->unseen) w->digest = bat_digest_number(w->digest, marked);
    add_object(w, element, s, box, &painted, markers);
    if (w->shows) bat_svg_show(w, s, &painted, marked);
}

void bat_svg_draw_shape(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s) {
    if (!s->style.visible) {
        bat_svg_note(&w->notes, element, BAT_LOSS_INVISIBLE);
        return;
    }
    uint64_t marked = 0;
    const char *const *named = s->style.markers;
    const bool some = named[BAT_MARKER_START] || named[BAT_MARKER_MID] || named[BAT_MARKER_END];
    bat_markers *markers = some ? bat_svg_markers(w, element, s, &marked) : NULL;
    bat_svg_shape_holder holder;
    const bat_svg_shape shape = bat_svg_shape_of(w, element, s, &holder);
    bat_outline_clear(&w->outline);
    if (!bat_svg_shape_outline(&shape, bat_svg_tree_name(w->tree, element), &w->outline))
        bat_svg_note(&w->notes, element, bat_svg_shape_loss(w, element, &s->style));
    if (w->outline.failed || w->outline.full) w->status = w->outline.failed ? BAT_MEMORY : BAT_COUNT;
    if (w->outline.subpath_count > 0 && w->status == BAT_OK) {
        bat_svg_scope own = *s;
        own.clip = bat_clip_retain(s->clip);
        draw_outline(w, element, &own, markers, marked);
        bat_clip_release(own.clip);
    }
    bat_markers_release(markers);
}
