/* Any bytes as WIRES, applied to a grid of points: what is far away keeps its bits, what moves does not go further than
 * the wires and their turns take it, and the references put everything back. */
#include <batten/format.h>
#include <batten/format_space.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { SIDE = 5, COUNT = SIDE * SIDE * SIDE, CURVE_MOST = 24, WIRES_MOST = 4 };

static bool small(const bat_wires_source *source) {
    for (size_t i = 0; i < BAT_WIRE_CURVES * source->count; i++) {
        const bat_curve *curve = source->owned[i];
        if (!curve) continue;
        if (bat_curve_count(curve) > CURVE_MOST) return false;
        const size_t size = bat_curve_count(curve) * (size_t)bat_curve_dimension(curve);
        for (size_t k = 0; k < size; k++)
            if (!(fabs(bat_curve_points(curve)[k]) < 1e6)) return false;
    }
    for (size_t i = 0; i < source->count; i++) {
        const bat_curve *const curves[2] = {source->wires[i].radius.curve, source->wires[i].scale.curve};
        for (int k = 0; k < 2; k++)
            if (curves[k] && bat_curve_count(curves[k]) > CURVE_MOST) return false;
    }
    return source->count <= WIRES_MOST;
}

static void check(const bat_wires_source *source) {
    double rest[3 * COUNT], points[3 * COUNT], largest = 0;
    int edges[2 * COUNT], torn[2 * COUNT];
    bat_binding *b = NULL;
    bat_wire_report report;
    size_t count = 0, wrong;
    const double step = fmax(bat_curve_size(source->owned[0]) / 4, 1e-3);
    const double *origin = bat_curve_points(source->owned[0]);
    for (int i = 0; i < COUNT; i++) {
        rest[3 * i] = origin[0] + step * (i % SIDE - 1),
                 rest[3 * i + 1] = origin[1] + step * (i / SIDE % SIDE - 1);
        rest[3 * i + 2] = step * (i / SIDE / SIDE - 1);
        edges[2 * i] = i, edges[2 * i + 1] = (i + 1) % COUNT;
    }
    memcpy(points, rest, sizeof rest);
    if (bat_wires_bind(source->count, source->wires, COUNT, points, &source->options, &b, &wrong) != BAT_OK)
        return;
    if (bat_binding_torn(b, COUNT, edges, COUNT, torn, &count) != BAT_OK || count > COUNT) abort();
    const bat_status status = bat_binding_apply(b, (const bat_curve *const *)source->curves, points, &report,
                                                &wrong);
    if (status == BAT_OK) {
        size_t moved = 0;
        for (int i = 0; i < COUNT; i++) {
            moved += memcmp(points + 3 * i, rest + 3 * i, 3 * sizeof *rest) != 0;
            for (int c = 0; c < 3; c++) {
                if (!isfinite(points[3 * i + c])) abort();
                largest = fmax(largest, fabs(points[3 * i + c] - rest[3 * i + c]));
            }
        }
        if (moved != report.moved || moved > bat_binding_count(b) || largest > 1.001 * report.largest + 1e-9)
            abort();
    } else if (status != BAT_NUMBER) {
        abort();
    }
    bat_binding_free(b);
}

/* Without a scale, the references themselves move nothing. */
static void check_rest(bat_wires_source *source) {
    double points[3] = {1, 2, 3};
    const bat_curve *references[WIRES_MOST];
    bat_binding *b = NULL;
    for (size_t i = 0; i < source->count; i++) {
        bat_function_clear(&source->wires[i].scale);
        source->wires[i].scale = bat_function_of(1);
        references[i] = source->wires[i].reference;
    }
    if (bat_wires_bind(source->count, source->wires, 1, points, NULL, &b, NULL) != BAT_OK) return;
    if (bat_binding_apply(b, references, points, NULL, NULL) != BAT_OK) abort();
    if (points[0] != 1 || points[1] != 2 || points[2] != 3) abort();
    bat_binding_free(b);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bat_wires_source source;
    bat_problem problem;
    bat_wire_options options;
    bat_wire_options_init(&options, sizeof options);
    if (bat_wires_read((const char *)data, size, &source, &problem) != BAT_OK) return 0;
    if (small(&source)) {
        check(&source);
        check_rest(&source);
    }
    bat_wires_source_clear(&source);
    return 0;
}
