/* How a stroke is shown: the ink, the fit, and the part of the old curve that is replaced. */
#include "base/vec.h"
#include "editor/edit/curves_of.h"
#include "editor/edit/mirror.h"
#include "editor/scene/paint.h"
#include "editor/scene/path.h"
#include "editor/show/axis.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/tools/sketch/parts.h"
#include "editor/view/stage.h"
#include <batten/bezier.h>
#include <math.h>
#include <string.h>

static const float FIT_WIDTH = 2, STRETCH_WIDTH = 4;
static const float AHEAD = 0.5F;       /* share of the opacity that what is predicted has */
static const double LABEL_AWAY = 22;   /* px above the pen */
static const double KNOT_RADIUS = 3.5; /* px */
static const double PRESSED_WITHIN = 0.25, CORNER = 0.02; /* px, radians: of a line that is still drawn */
static const double SURE_AFTER = 20,
                    SURE = 0.1; /* px; how much cheaper the best reading is, per pixel of stroke */

/* Marks the knots strictly inside u0..u1, in whichever period they lie. */
static void mark_knots(bat_overlay *overlay, const bat_curve *curve, double u0, double u1, double radius) {
    const double *knots = bat_curve_knots(curve);
    int count = bat_curve_knot_count(curve), marks = 0;
    double domain[2];
    bat_curve_domain(curve, domain);
    double period = domain[1] - domain[0];
    bool closed = bat_curve_is_closed(curve);
    for (int i = 0; i < count && marks < 2000; i++) {
        if (i && knots[i] == knots[i - 1]) continue;
        for (int k = closed ? -1 : 0; k <= (closed ? 1 : 0); k++) {
            double u = knots[i] + k * period, point[BAT_DIMENSION_MAX];
            if (!(u > u0 && u < u1) || (closed && i == count - 1)) continue;
            bat_curve_eval(curve, u, 0, point);
            double at[2];
            bat_map_look(overlay->path.map, bat_curve_dimension(curve), point, at);
            bat_overlay_mark(overlay, at, radius);
            marks++;
        }
    }
}

/* The part of a fit that is new; whole: all of it. */
static void new_part(const bat_curve *curve, const bat_sketch_report *report, bool whole, double range[2]) {
    bat_curve_domain(curve, range);
    if (!whole && report->changed_new[0] < report->changed_new[1])
        memcpy(range, report->changed_new, 2 * sizeof *range);
}

/* The knots of the new part, if knots are shown. */
static void show_knots(const bat_context *c, bat_overlay *overlay, const bat_curve *curve,
                       const bat_sketch_report *report, bool whole) {
    double range[2];
    if (c->settings->values[BAT_PROPERTY_SHOW_KNOTS] == 0) return;
    new_part(curve, report, whole, range);
    bat_overlay_item(overlay, BAT_ROLE_KNOT, BAT_ITEM_FILLED, 0);
    mark_knots(overlay, curve, range[0], range[1], KNOT_RADIUS * bat_stage_pixel(c->stage));
}

/* Shows the fit: its new part, or all of a new curve; with its knots if knots are shown. */
static void show_fit(const bat_context *c, bat_overlay *overlay, bat_role role, const bat_curve *curve,
                     const bat_sketch_report *report, bool whole) {
    double range[2];
    new_part(curve, report, whole, range);
    bat_overlay_item(overlay, role, BAT_ITEM_STROKED, FIT_WIDTH);
    bat_overlay_stretch(overlay, curve, range[0], range[1]);
    show_knots(c, overlay, curve, report, whole);
}

/* What the stroke draws with: the style and the width along it of the object that changes, or of the new one. */
static const bat_style *drawn_with(const bat_context *c, const bat_sketching *s, bat_width_profile *profile) {
    const bat_edit *edit = &s->edit;
    const bat_document *document = c->session->document;
    const bat_object *object = edit->kind == BAT_EDIT_NEW
                                   ? NULL
                                   : bat_document_at(document, bat_document_find(document, edit->object));
    *profile = (bat_width_profile){0};
    if (object) *profile = bat_object_widths(object);
    if (s->preview.stop_count) *profile = (bat_width_profile){s->preview.stop_count, s->preview.stops};
    return object ? bat_object_style(object) : &edit->style;
}

/* Begins an item in the line's own colour and width. */
static bat_item *begin_line(bat_overlay *overlay, bat_role role, const bat_style *style, uint32_t flags) {
    bat_overlay_item(overlay, role, flags, 0);
    bat_item *item = &overlay->items[overlay->count - 1];
    bat_paint_style(style, item);
    item->flags = flags;
    if (flags == BAT_ITEM_FILLED) item->fill = item->stroke;
    return item;
}

/* The whole curve as wide along it as it will be. False: it is as wide everywhere, or cannot be covered. */
static bool show_cover(const bat_edit *edit, const bat_style *style, const bat_width_profile *profile,
                       const bat_curve *curve, bat_overlay *overlay) {
    const bat_nib nib = {style->width, style->cap, style->join, fmax(style->miter_limit, 1)};
    size_t cubics = 0;
    double *points = NULL;
    if (!profile->count || bat_curve_dimension(curve) != 2 || bat_stage_tilted(&edit->stage) ||
        bat_curve_cover_width(curve, &nib, profile, PRESSED_WITHIN * edit->options.pixel, CORNER, &cubics,
                              &points) != BAT_OK)
        return false;
    begin_line(overlay, BAT_ROLE_FIT, style, BAT_ITEM_FILLED);
    for (size_t i = 0; i < cubics; i++) {
        const double *b = points + 8 * i;
        if (i == 0 || memcmp(b, b - 2, 2 * sizeof *b) != 0) bat_path_move(&overlay->path, b[0], b[1]);
        bat_path_cubic(&overlay->path, b + 2);
    }
    bat_free(points);
    return true;
}

/* The line as it will be: what is fitted, or as long as there is no fit, or none that is sure, what the pen has drawn. */
static void show_line(const bat_context *c, const bat_edit *edit, const bat_style *style,
                      const bat_width_profile *profile, const bat_sketching_preview *fit, bool whole,
                      bat_overlay *overlay) {
    if (!style->stroked || !(style->width > 0)) {
        if (fit) show_fit(c, overlay, BAT_ROLE_FIT, fit->curve, &fit->report, whole);
        return;
    }
    if (fit && show_cover(edit, style, profile, fit->curve, overlay)) return;
    begin_line(overlay, fit ? BAT_ROLE_FIT : BAT_ROLE_INK, style, BAT_ITEM_STROKED);
    double range[2];
    if (!fit) {
        bat_overlay_polyline(overlay, edit->samples.count, edit->samples.points);
        return;
    }
    new_part(fit->curve, &fit->report, whole, range);
    bat_overlay_stretch(overlay, fit->curve, range[0], range[1]);
}

/* The stretch covers the old line, so it has to be as wide. */
static float stretch_width(const bat_context *c, bat_id id) {
    const bat_object *object = bat_document_at(c->session->document,
                                               bat_document_find(c->session->document, id));
    const bat_width_profile profile = object ? bat_object_widths(object) : (bat_width_profile){0};
    return fmaxf(STRETCH_WIDTH, object ? bat_sketching_width(c, bat_object_style(object), &profile) + 2 : 0);
}

static void show_stretch(const bat_context *c, bat_overlay *overlay, const bat_edit *edit,
                         const bat_sketch_report *report) {
    const bat_curve *target = bat_edit_curve(c->session->document, edit, edit->object, edit->curve);
    if (!target || !(report->changed[0] < report->changed[1])) return;
    bat_overlay_item(overlay, BAT_ROLE_STRETCH, BAT_ITEM_STROKED, stretch_width(c, edit->object));
    bat_overlay_stretch(overlay, target, report->changed[0], report->changed[1]);
}

/* Whether the meaning is certain; always so for a new line. Until then both ink and fit are drawn as possible
 * outcomes. */
static bool sure(const bat_sketching *s) {
    const bat_meaning *m = &s->meaning;
    if (s->forced || s->smoothing || s->edit.kind == BAT_EDIT_NEW || m->count < 2) return true;
    const double length = bat_intent_length(m->intent);
    return length >= SURE_AFTER && m->readings[1].cost - m->readings[0].cost >= SURE * length;
}

/* Shows what the edit does on the other side of the axis, when it turns `before` (NULL: a new line) into `fit`; as long
 * as a new line has no fit, the image of its ink. */
static void show_other_side(bat_context *c, const bat_edit *edit, const bat_curve *before,
                            const bat_curve *fit, bat_overlay *overlay) {
    const bool fresh = edit->kind == BAT_EDIT_NEW;
    bat_curve *ghost = NULL;
    if (fit && (fresh || before))
        bat_mirror_preview(c, &edit->mirror, edit->options.pixel, edit->options.tolerance, before, fit,
                           &ghost);
    bat_axis_show_ghost(&edit->mirror, overlay, fresh ? edit->samples.count : 0, edit->samples.places, ghost);
    bat_curve_free(ghost);
}

/* From the ink through the pen to the predicted points. */
static void show_ahead(const bat_context *c, const bat_sketching *s, const bat_style *style,
                       bat_overlay *overlay) {
    const bat_samples *samples = &s->edit.samples;
    if ((!s->predicted_count && !(s->steady.reach > 0)) || !samples->count) return;
    double pen[2];
    const double *last = samples->points + 2 * (samples->count - 1);
    if (style->stroked)
        begin_line(overlay, BAT_ROLE_PREDICTED, style, BAT_ITEM_STROKED)->opacity *= AHEAD;
    else
        bat_overlay_item(overlay, BAT_ROLE_PREDICTED, BAT_ITEM_STROKED, FIT_WIDTH);
    bat_path_move(&overlay->path, last[0], last[1]);
    bat_stage_seen(c->stage, s->hover, pen);
    bat_path_line(&overlay->path, pen[0], pen[1]);
    for (size_t i = 0; i < s->predicted_count; i++)
        bat_path_line(&overlay->path, s->predicted[2 * i], s->predicted[2 * i + 1]);
}

/* The figure that a held stroke could become, with its name. */
static void show_offer(const bat_context *c, const bat_sketching *s, bat_overlay *overlay) {
    const bat_figure *figure = &s->hold.figure;
    double at[2];
    if (figure->kind == BAT_FIGURE_NONE) return;
    bat_overlay_item(overlay, BAT_ROLE_GHOST, BAT_ITEM_STROKED, FIT_WIDTH);
    for (size_t i = 0; i < figure->count; i++) {
        bat_stage_seen(c->stage, figure->points + 2 * i, at);
        (i ? bat_path_line : bat_path_move)(&overlay->path, at[0], at[1]);
    }
    bat_stage_seen(c->stage, s->hover, at);
    bat_overlay_label(overlay, BAT_ROLE_VALUE, at, 0, -LABEL_AWAY, bat_word(c, bat_hold_word(figure->kind)));
}

void bat_sketching_show_stroke(bat_context *c, bat_sketching *s, bat_overlay *overlay) {
    const bat_sketching_preview *preview = &s->preview;
    const bat_samples *samples = &s->edit.samples;
    const bat_curve *target = NULL;
    const int dimension = bat_stage_dimension(&s->edit.stage);
    const bool one = bat_sketching_one_changes(&s->edit);
    const bat_sketching_preview *fit = preview->curve && sure(s) ? preview : NULL;
    bat_width_profile profile;
    const bat_style *style = drawn_with(c, s, &profile);
    if (one) target = bat_edit_curve(c->session->document, &s->edit, s->edit.object, s->edit.curve);
    if (s->edit.kind != BAT_EDIT_NEW && (!target || !preview->curve))
        bat_sketching_highlight(c, overlay, dimension, s->edit.object, s->edit.curve);
    if (s->edit.kind == BAT_EDIT_JOIN)
        bat_sketching_highlight(c, overlay, dimension, s->edit.other, s->edit.other_curve);
    for (int i = 1; i < s->edit.part_count; i++)
        bat_sketching_highlight(c, overlay, dimension, s->edit.part[i].object, s->edit.part[i].curve);
    if (fit && target) show_stretch(c, overlay, &s->edit, &preview->report);
    bat_sketching_show_ground(c, &s->edit.stage, overlay);
    bat_followers_show(c, &s->preview.followers, overlay);
    bat_sketching_halo(overlay, BAT_ROLE_INK, bat_sketching_width(c, style, &(bat_width_profile){0}));
    bat_overlay_polyline(overlay, samples->count, samples->points);
    show_line(c, &s->edit, style, &profile, fit, !one, overlay);
    if (fit)
        show_knots(c, overlay, fit->curve, &fit->report, !one);
    else if (preview->curve)
        show_fit(c, overlay, BAT_ROLE_GHOST, preview->curve, &preview->report, !one);
    if (s->edit.mirror.on) show_other_side(c, &s->edit, target, preview->curve, overlay);
    show_ahead(c, s, style, overlay);
    show_offer(c, s, overlay);
}

/* The curve as it is, under what it would become. */
static void show_present(const bat_context *c, bat_overlay *overlay, bat_id object, int curve) {
    const bat_curve *now = bat_edit_target(c->session->document, object, curve);
    if (!now) return;
    bat_overlay_item(overlay, BAT_ROLE_STRETCH, BAT_ITEM_STROKED, stretch_width(c, object));
    bat_path_curve(&overlay->path, now);
}

void bat_sketching_show_refit(bat_context *c, const bat_sketching *s, bat_overlay *overlay) {
    const bat_again *again = &s->again;
    const bat_edit *edit = &again->edit[again->at];
    const bat_curve *now = bat_edit_target(c->session->document, edit->object, edit->curve);
    const bat_curve *before = again->before;
    if (!now) return;
    show_present(c, overlay, edit->object, edit->curve);
    for (int i = 1; i < again->fit.count; i++)
        show_present(c, overlay, edit->part[i].object, edit->part[i].curve);
    for (int i = 0; i < again->fit.count; i++)
        show_fit(c, overlay, BAT_ROLE_FIT, again->fit.curve[i], NULL, true);
    if (!edit->mirror.on || again->fit.count > 1) return;
    /* The twin, where there is one, is by now that of the present curve. */
    const bool own = before && bat_mirror_twins(&edit->mirror, before, before, edit->options.pixel);
    show_other_side(c, edit, !before || own ? before : now, again->fit.curve[0], overlay);
}

/* The fit that awaits confirmation. */
void bat_sketching_show_pending(const bat_context *c, const bat_sketching *s, bat_overlay *overlay) {
    const bat_edit *edit = &s->pending;
    bool whole = !bat_sketching_one_changes(edit);
    if (!whole) show_stretch(c, overlay, edit, &s->pending_report);
    show_fit(c, overlay, BAT_ROLE_PENDING, s->pending_result.curve[0], &s->pending_report, whole);
}
