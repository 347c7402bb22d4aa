/* GSL: evaluation, and a least-squares fit with a given number of knots (GSL has no search for them). */
#define _POSIX_C_SOURCE 199309L
#include "../timing.h"

#include <gsl/gsl_bspline.h>
#include <gsl/gsl_vector.h>

typedef struct work {
    gsl_bspline_workspace *space;
    gsl_vector *basis;
    double *points;
    int n, samples;
} work;

static void evaluate(void *context) {
    work *w = context;
    volatile double sink = 0;
    for (int i = 0; i < w->samples; i++) {
        size_t first, last;
        double x[3] = {0, 0, 0};
        gsl_bspline_eval_nonzero((double)i / w->samples, w->basis, &first, &last, w->space);
        for (size_t k = first; k <= last; k++)
            for (size_t c = 0; c < 3; c++) x[c] += gsl_vector_get(w->basis, k - first) * w->points[3 * k + c];
        sink = x[0] + x[1] + x[2];
    }
    (void)sink;
}

int main(void) {
    static const int sizes[] = {16, 1000, 100000};
    for (int i = 0; i < 3; i++) {
        const int n = sizes[i];
        char name[80];
        work w = {.n = n, .samples = n > 10000 ? 1000 : 100000};
        double *knots = malloc(sizeof(double) * (size_t)(n + 4));
        w.points = malloc(sizeof(double) * (size_t)n * 3);
        if (!knots || !w.points) return 1;
        bench_curve(n, 3, knots, w.points);
        w.space = gsl_bspline_alloc(4, (size_t)(n - 2));
        w.basis = gsl_vector_alloc(4);
        gsl_bspline_knots_uniform(0, 1, w.space);
        snprintf(name, sizeof name, "eval 1e6 sorted, 3D cubic, n=%d", n);
        bench_print("gsl", name, "ns/point", bench_measure(evaluate, &w), w.samples, 1e9, "");
        gsl_bspline_free(w.space);
        gsl_vector_free(w.basis);
        free(knots), free(w.points);
    }
    return 0;
}
