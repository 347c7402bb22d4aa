/* Any bytes as a SPLINE, a SHAPE and EDITS of it. What can be read gives finite numbers or an error status;
 * splines pass through their points, and a point inserted on the curve does not move the curve. */
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/levels.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check_insert(const bat_spline *spline, const bat_tangents_options *options, int segments) {
    bat_spline longer;
    void *block = NULL;
    int index;
    double deviation;
    bat_status status = bat_tangents_insert(spline, segments / 2, 0.375, options, &longer, &block, &index,
                                            &deviation);
    if (status != BAT_OK) return;
    if (longer.count != spline->count + 1 || index <= 0 || (size_t)index >= longer.count || !(deviation >= 0))
        abort();
    if (bat_tangents(&longer, options, NULL, NULL, NULL, NULL) != BAT_OK) abort();
    bat_free(block);
}

/* The k of a direction is in its range, and a shape from the spline exists exactly when the status is BAT_OK. */
static void check_base(const bat_spline *spline) {
    bat_tangents_options options;
    bat_tangents_options_init(&options, sizeof options);
    bat_shape *shape = NULL;
    const int size = spline->dimension;
    for (int i = 1; (size_t)i + 1 < spline->count; i++) {
        double c0[3], c1[3];
        const double *p = spline->points + i * size;
        for (int d = 0; d < size; d++) c0[d] = p[d] - p[d - size], c1[d] = p[d + size] - p[d];
        double k = bat_tangents_k(size, c0, c1, spline->tangents ? spline->tangents + i * size : c0);
        if (!isnan(k) && !(k >= 0 && k <= 1)) abort();
    }
    bat_status status = bat_shape_from_spline(spline, &options, NULL, &shape);
    if ((status == BAT_OK) != (shape != NULL)) abort();
    bat_shape_free(shape);
}

static void check_spline(const bat_spline *spline) {
    for (int choice = 0; choice < 10; choice++) {
        bat_tangents_options options = {sizeof options,
                                        choice < 9 ? (bat_tangents_mode)(choice % 3) : BAT_TANGENTS_ROUND,
                                        (bat_tangents_default)(choice / 3 % 3)};
        bat_joint *joints = malloc((spline->count + 1) * sizeof *joints);
        double *bezier = NULL;
        int segments = 0, size = spline->dimension;
        bat_curve *curve = NULL;
        if (joints && bat_tangents(spline, &options, joints, &segments, &bezier, &curve) == BAT_OK) {
            for (int i = 0; i < 4 * segments * size; i++)
                if (!isfinite(bezier[i])) abort();
            for (size_t i = 0; i < spline->count; i++)
                if (!joints[i].dropped && !isnan(joints[i].k) && !(joints[i].k >= 0 && joints[i].k <= 1))
                    abort();
            for (int i = 0; i + 1 < segments; i++)
                if (memcmp(bezier + (4 * i + 3) * size, bezier + 4 * (i + 1) * size,
                           (size_t)size * sizeof(double)))
                    abort();
            check_insert(spline, &options, segments);
        } else if (bezier || curve) {
            abort();
        }
        free(joints);
        bat_free(bezier);
        bat_curve_free(curve);
    }
}

/* The first line break separates the SHAPE from the EDITS. */
static void check_shape(const char *text, size_t size) {
    const char *cut = memchr(text, '\n', size);
    size_t first = cut ? (size_t)(cut - text) : size;
    bat_shape *shape = NULL, *back = NULL;
    bat_problem problem;
    char *written = NULL;
    size_t length = 0;
    if (bat_shape_read(text, first, &shape, &problem) != BAT_OK) {
        if (shape) abort();
        return;
    }
    if (cut) bat_shape_edit(shape, cut + 1, size - first - 1, &problem);
    if (bat_shape_write(shape, &written, &length) == BAT_OK) {
        if (bat_shape_read(written, length, &back, &problem) == BAT_OK) bat_shape_free(back);
        bat_free(written);
    }
    bat_shape_free(shape);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *text = (const char *)data;
    bat_spline spline;
    void *block = NULL;
    bat_problem problem;
    if (bat_spline_read(text, size, &spline, &block, &problem) == BAT_OK) {
        if (spline.count <= 200) check_spline(&spline);
        if (spline.count <= 200) check_base(&spline);
        bat_free(block);
    }
    check_shape(text, size);
    return 0;
}
