/* Silhouettes: the zeros of det(S_u, S_v, gaze), a polynomial on each span (docs/math/surfaces.md). */
#include "form/trace/silhouette.h"

#include <math.h>
#include <string.h>

static const double edge_on = 1e-7; /* relative size of the determinant: the patch is seen from its edge */
static const double rounding = 1e-12;
static const double chord = 3e-3; /* pixels */

/* The net with x and y across the gaze, z along it, from the eye. */
static void see(const bat_gaze *gaze, int points, const double *net, double *seen) {
    for (int i = 0; i < points; i++) {
        const vec p = vec_sub(vec_load(net + 3 * i, 3), gaze->eye);
        vec_store((vec){vec_dot(p, gaze->right), vec_dot(p, gaze->above), vec_dot(p, gaze->ahead)},
                  seen + 3 * i);
    }
}

/* The greatest of |S_u| or |S_v|, bounded by the net. */
static double speed(const double *net, const int degree[2], int direction) {
    const int row = 3 * (degree[1] + 1), step = direction == 0 ? row : 3;
    double most = 0;
    for (int i = 0; i <= degree[0] - (direction == 0); i++)
        for (int j = 0; j <= degree[1] - (direction == 1); j++) {
            const double *a = net + i * row + 3 * j;
            const vec way = {a[step] - a[0], a[step + 1] - a[1], a[step + 2] - a[2]};
            most = fmax(most, vec_dot(way, way));
        }
    return degree[direction] * sqrt(most);
}

/* Whether an edge is a single point: a pole. */
static bool is_pole(const double *net, const int degree[2], int direction, bool end, double size) {
    const int row = 3 * (degree[1] + 1), step = direction == 0 ? 3 : row;
    const double *first = net + (!end ? 0 : direction == 0 ? degree[0] * row : 3 * degree[1]);
    for (int k = 1; k <= degree[1 - direction]; k++)
        for (int c = 0; c < 3; c++)
            if (fabs(first[k * step + c] - first[c]) > rounding * size) return false;
    return true;
}

/* The determinant of a net in the gaze's coordinates. */
static void determinant(const bat_gaze *gaze, const double *seen, const int degree[2], bat_poly *out) {
    bat_poly normal, place;
    if (!(gaze->focus > 0)) {
        bat_poly_normal(seen, degree, 2, out);
        return;
    }
    out->degree[0] = -1;
    for (int c = 0; c < 3; c++) {
        bat_poly_normal(seen, degree, c, &normal);
        bat_poly_of_net(seen, degree, c, &place);
        bat_poly_add_product(&normal, &place, 1, out);
    }
}

static bool of_span(const void *user, const bat_cell *cell, bat_poly *out, double *tiny) {
    const bat_silhouette *s = user;
    const int degree[2] = {s->surface->axis[0].degree, s->surface->axis[1].degree};
    const int points = (degree[0] + 1) * (degree[1] + 1);
    double seen[3 * BAT_CELL_POINTS], far = 0;
    see(&s->gaze, points, cell->net, seen);
    for (int i = 0; i < points; i++) far = fmax(far, vec_norm(vec_load(seen + 3 * i, 3)));
    determinant(&s->gaze, seen, degree, out);
    const double su = speed(seen, degree, 0), sv = speed(seen, degree, 1);
    const double depth = s->gaze.focus > 0 ? far : 1, most = bat_poly_most(out);
    if (!(most > edge_on * su * sv * depth)) return false;
    for (int d = 0; d < 2; d++)
        for (int end = 0; end < 2; end++)
            if (is_pole(seen, degree, d, end, s->surface->size)) bat_poly_divide(out, d, end);
    /* what rounding of the coordinates makes of the determinant */
    *tiny = fmax(rounding * bat_poly_most(out), 1e-15 * far * depth * (degree[0] * sv + degree[1] * su));
    return true;
}

void bat_gaze_image(const bat_gaze *gaze, const double point[3], double out[3]) {
    const vec p = vec_sub(vec_load(point, 3), gaze->eye);
    const double far = vec_dot(p, gaze->ahead);
    const double scale = gaze->focus > 0 ? gaze->focus / fmax(far, 1e-300) : 1 / gaze->pixel;
    out[0] = gaze->middle[0] + scale * vec_dot(p, gaze->right);
    out[1] = gaze->middle[1] - scale * vec_dot(p, gaze->above);
    out[2] = far;
}

/* In the image; behind the eye nothing is measured. */
static void place(const void *user, const double point[3], double out[3]) {
    bat_gaze_image(&((const bat_silhouette *)user)->gaze, point, out);
    if (((const bat_silhouette *)user)->gaze.focus > 0 && !(out[2] > 0)) out[0] = out[1] = 0;
    out[2] = 0;
}

bat_status bat_surface_silhouettes(const bat_surface *surface, const bat_viewpoint *view, bat_tracks **out) {
    bat_silhouette s = {.surface = surface};
    if (!surface || !view || !out) return BAT_ARGUMENT;
    bat_status status = bat_gaze_of(view, &s.gaze);
    if (status != BAT_OK) return status;
    return bat_silhouettes_trace(&s, out);
}

bat_status bat_silhouettes_trace(const bat_silhouette *s, bat_tracks **out) {
    const bat_contour contour = {s->surface, s, of_span, place, chord};
    return bat_contour_trace(&contour, out);
}
