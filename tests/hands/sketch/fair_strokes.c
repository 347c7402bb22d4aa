/* For fair_fitpack.py: strokes of known curvature and what the sketch hand makes of them. A stroke a line: the extrema
 * of the true curvature, those of the result, and its points; PLACES places along it, and the samples. Usage:
 * fair_strokes COUNT DEGREE SEED */
#include "curve/curve.h"
#include "support/known_strokes.h"

#include <stdio.h>
#include <stdlib.h>

static bat_status print_made(const sample_set *s, const bat_sketch_options *options) {
    static double k[PLACES], range[2], place[2];
    const bat_stroke stroke = {.dimension = 2, .count = s->count, .points = s->points, .time = s->time};
    bat_curve *curve = NULL;
    const bat_status status = bat_sketch_new(&stroke, false, options, &curve, NULL);
    if (status != BAT_OK) return status;
    bat_curve_domain(curve, range);
    curvatures(curve, range, k);
    printf(" %d %d", extrema(k, PLACES, threshold(k, PLACES)), bat_point_count(curve));
    for (int i = 0; i < PLACES; i++) {
        bat_curve_eval(curve, range[0] + (range[1] - range[0]) * i / (PLACES - 1), 0, place);
        printf(" %.17g %.17g", place[0], place[1]);
    }
    bat_curve_free(curve);
    return BAT_OK;
}

int main(int argc, char **argv) {
    if (argc != 4) return 2;
    static sample_set s;
    bat_sketch_options options = bat_sketch_defaults();
    options.degree = (int)strtol(argv[2], NULL, 10);
    random_source r = {strtoull(argv[3], NULL, 10)};
    const long count = strtol(argv[1], NULL, 10);
    for (long n = 0; n < count; n++) {
        const profile p = random_profile(&r, (int)(n % KINDS));
        draw(&r, &p, n % 2 ? 0.12 : 0.3, &s);
        printf("%d", s.extrema);
        if (print_made(&s, &options) != BAT_OK) return 1;
        for (size_t i = 0; i < 2 * s.count; i++) printf(" %.17g", s.points[i]);
        printf("\n");
    }
    return 0;
}
