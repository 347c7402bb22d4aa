/* Any bytes as a VIEW and, behind a zero byte, as what a stroke is cast on. A view that can be read gives rays that lead
 * back to their pixels; what lands does so on its ray. */
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/sight.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static double length(const double *a) { return hypot(hypot(a[0], a[1]), a[2]); }

static void check_rays(const bat_viewpoint *view) {
    double from[3], way[3], seen[2], depth;
    const double pixel[2] = {view->size[0] / 3, view->size[1] / 5};
    if (bat_viewpoint_check(view, NULL) != BAT_OK) abort();
    if (bat_viewpoint_ray(view, pixel, from, way) != BAT_OK) abort();
    if (!(fabs(length(way) - 1) < 1e-9)) abort();
    if (bat_viewpoint_project(view, view->target, seen, &depth) == BAT_OK && !(depth >= 0)) abort();
}

static void check_cast(const bat_viewpoint *view, const bat_canvas *canvas) {
    enum { COUNT = 6 };
    double pixels[2 * COUNT];
    bat_cast_point out[COUNT];
    size_t landed = 0, found = 0;
    for (int i = 0; i < COUNT; i++)
        pixels[2 * i] = view->size[0] * (0.3 + 0.08 * i),
                   pixels[2 * i + 1] = view->size[1] * (0.45 + 0.02 * i);
    const bat_stroke stroke = {.dimension = 2, .count = COUNT, .points = pixels};
    const double size = canvas->curve     ? bat_curve_size(canvas->curve)
                        : canvas->surface ? bat_surface_size(canvas->surface)
                                          : 0;
    if (bat_cast(view, &stroke, canvas, out, &landed) != BAT_OK) return;
    for (int i = 0; i < COUNT; i++) {
        double from[3], way[3], gap[3];
        if (out[i].fate != BAT_CAST_LANDED) continue;
        found++;
        if (bat_viewpoint_ray(view, pixels + 2 * i, from, way) != BAT_OK) abort();
        for (int c = 0; c < 3; c++) gap[c] = from[c] + out[i].distance * way[c] - out[i].point[c];
        if (!(length(gap) <= 1e-5 * (length(out[i].point) + length(from) + out[i].distance + size))) abort();
    }
    if (found != landed) abort();
}

static void check_pick(const bat_viewpoint *view, const bat_surface *surface) {
    const double pixels[6] = {view->size[0] / 2, view->size[1] / 2, view->size[0] / 3, view->size[1] / 2, 0,
                              view->size[1]};
    const bat_stroke stroke = {.dimension = 2, .count = 3, .points = pixels};
    bat_surface_pick pick;
    double domain[2];
    if (bat_surface_pick_line(view, &stroke, surface, &pick) != BAT_OK) return;
    bat_surface_domain(surface, pick.direction, domain);
    if (!(pick.value >= domain[0] && pick.value <= domain[1]) || pick.used + pick.dropped != 3) abort();
}

static void check_sketch(const bat_viewpoint *view, const bat_surface *surface, bat_direction direction) {
    enum { COUNT = 24 };
    double pixels[2 * COUNT], domain[2];
    for (int i = 0; i < COUNT; i++) {
        pixels[2 * i] = view->size[0] * (0.25 + 0.02 * i);
        pixels[2 * i + 1] = view->size[1] * (0.45 + 0.001 * i * i);
    }
    const bat_stroke stroke = {.dimension = 2, .count = COUNT, .points = pixels};
    bat_surface_sketch_options options;
    bat_surface_sketch_options_init(&options, sizeof options);
    bat_surface_sketch_report report;
    bat_surface *made = NULL;
    options.tolerance = 1e-3 * bat_surface_size(surface);
    bat_surface_domain(surface, direction, domain);
    if (bat_surface_sketch(surface, direction, 0.5 * (domain[0] + domain[1]), view, &stroke, &options, &made,
                           NULL, &report) != BAT_OK)
        return;
    if (!(report.max_error <= options.tolerance) || 3 * report.dropped > COUNT) abort();
    bat_surface_free(made);
}

/* Every point of a track lies on the surface. */
static void check_tracks(const bat_surface *surface, bat_tracks *tracks) {
    const double size = bat_surface_size(surface);
    for (size_t i = 0; i < bat_tracks_count(tracks); i++) {
        const bat_track_point *points;
        const size_t count = bat_tracks_points(tracks, i, &points);
        if (count < 2 || (bat_tracks_is_closed(tracks, i) && count < 3)) abort();
        for (size_t k = 0; k < count; k++) {
            double at[3];
            bat_surface_eval(surface, points[k].uv[0], points[k].uv[1], 0, at);
            for (int c = 0; c < 3; c++) at[c] -= points[k].point[c];
            if (!(length(at) <= 1e-6 * size)) abort();
        }
    }
    for (size_t i = 0; i < bat_tracks_crossing_count(tracks); i++)
        if (!isfinite(bat_tracks_crossing(tracks, i)->point[0])) abort();
    bat_tracks_free(tracks);
}

static void check_traces(const bat_viewpoint *view, const bat_surface *surface) {
    bat_tracks *tracks = NULL;
    double low[3], high[3];
    if (bat_surface_silhouettes(surface, view, &tracks) == BAT_OK) check_tracks(surface, tracks);
    bat_surface_box(surface, low, high);
    for (int c = 0; c < 3; c++) low[c] = 0.5 * (low[c] + high[c]);
    if (bat_surface_section(surface, low, view->up, 1e-2 * bat_surface_size(surface), &tracks) == BAT_OK)
        check_tracks(surface, tracks);
    bat_intersect_options options;
    bat_intersect_options_init(&options, sizeof options);
    options.chord = 0.1 * bat_surface_size(surface), options.leaf = 0.5;
    const double *at = low, half = 0.1 * bat_surface_size(surface), knots[] = {0, 0, 1, 1};
    const double corners[] = {at[0] - half, at[1] - half, at[2],        at[0] - half, at[1] + half, at[2],
                              at[0] + half, at[1] - half, at[2] + half, at[0] + half, at[1] + half, at[2]};
    bat_surface *other = NULL;
    if (bat_surface_create((const int[2]){1, 1}, (const bool[2]){false, false}, (const size_t[2]){2, 2},
                           corners, (const int[2]){4, 4}, knots, knots, &other) != BAT_OK)
        return;
    if (bat_surface_intersect(surface, other, &options, &tracks) == BAT_OK) {
        bat_curve *curve = NULL;
        if (bat_tracks_count(tracks) > 0 &&
            bat_tracks_curve(tracks, 0, 0.1 * bat_surface_size(surface), &curve) == BAT_OK)
            bat_curve_free(curve);
        if (bat_tracks_is_given_up(tracks) && bat_tracks_count(tracks) > 1000) abort();
        check_tracks(surface, tracks);
    }
    bat_surface_free(other);
}

/* Lines are finite. */
static void check_lines(const bat_viewpoint *view, const bat_surface *surface) {
    const bat_line_scene scene = {1, &surface, 0, NULL};
    bat_viewpoint small = *view;
    bat_line_drawing *drawing = NULL;
    small.height *= 40 / small.size[1], small.size[0] = 40, small.size[1] = 40;
    if (bat_line_drawing_create(&small, &scene, &drawing) != BAT_OK) return;
    for (size_t i = 0; i < bat_line_drawing_count(drawing); i++) {
        bat_seen_line line;
        bat_line_drawing_at(drawing, i, &line);
        if (line.segments < 1 || line.source != 0) abort();
        for (int k = 0; k < 6 * line.segments + 2; k++)
            if (!isfinite(line.points[k])) abort();
    }
    (void)bat_line_drawing_is_whole(drawing);
    bat_line_drawing_free(drawing);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *text = (const char *)data, *zero = size ? memchr(text, 0, size) : NULL;
    const size_t first = zero ? (size_t)(zero - text) : size;
    bat_viewpoint view = {.eye = {1, -20, 7}, .up = {0, 0, 1}, .size = {100, 80}, .fov = 40};
    bat_problem problem;
    bat_canvas canvas = {.curve = NULL};
    if (bat_viewpoint_read(text, first, &view, &problem) == BAT_OK) {
        char *again = NULL;
        size_t length_again;
        bat_viewpoint same;
        if (bat_viewpoint_write(&view, &again, &length_again) != BAT_OK) abort();
        if (bat_viewpoint_read(again, length_again, &same, NULL) != BAT_OK) abort();
        bat_free(again);
    }
    check_rays(&view);
    if (zero && bat_canvas_read(zero + 1, size - first - 1, &canvas, &problem) == BAT_OK) {
        const size_t points = canvas.curve     ? bat_curve_count(canvas.curve)
                              : canvas.surface ? bat_surface_count(canvas.surface, BAT_U) *
                                                     bat_surface_count(canvas.surface, BAT_V)
                                               : 1;
        if (points <= 100) check_cast(&view, &canvas);
        if (points <= 100 && canvas.surface) {
            check_pick(&view, canvas.surface);
            check_sketch(&view, canvas.surface, BAT_U);
            check_sketch(&view, canvas.surface, BAT_V);
            check_traces(&view, canvas.surface);
            if (points <= 9) check_lines(&view, canvas.surface);
        }
    }
    bat_canvas_clear(&canvas);
    return 0;
}
