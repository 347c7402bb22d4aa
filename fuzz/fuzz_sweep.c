/* Any bytes as a SWEEP. The surface that is made of one that can be read is within its tolerance at the places that are
 * looked at. */
#include <batten/format.h>
#include <batten/format_space.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { POINTS = 24 }; /* larger curves take too long */

static bool small(const bat_curve *curve) {
    double reach = 0;
    const size_t size = bat_curve_count(curve) * (size_t)bat_curve_dimension(curve);
    for (size_t i = 0; i < size; i++) reach = fmax(reach, fabs(bat_curve_points(curve)[i]));
    return bat_curve_count(curve) <= POINTS && reach < 1e6 && bat_curve_size(curve) > 1e-3 * reach;
}

static bool small_function(const bat_function *f) {
    double value[3];
    const double domain[3] = {0, 0.5, 1};
    if (f->curve && !small(f->curve)) return false;
    for (int k = 0; k < 3; k++) {
        bat_function_eval(f, domain[k], value);
        if (!(fabs(value[0]) < 100)) return false;
    }
    return true;
}

static void check(const bat_sweep *sweep, double reach) {
    bat_surface *surface = NULL;
    bat_sweep_report report;
    double du[2], dv[2], folds[4][2];
    size_t count = 0;
    bat_sweep_domain(sweep, BAT_U, du), bat_sweep_domain(sweep, BAT_V, dv);
    if (bat_sweep_folds(sweep, 4, folds[0], &count) != BAT_OK) abort();
    for (size_t i = 0; i < count && i < 4; i++)
        if (!(folds[i][0] <= folds[i][1] && folds[i][0] >= du[0] && folds[i][1] <= du[1])) abort();
    if (!isfinite(bat_sweep_holonomy(sweep))) abort();
    const double tolerance = 0.02 * reach;
    if (bat_sweep_surface(sweep, tolerance, &surface, &report) != BAT_OK) return; /* too wild a twist */
    for (int k = 0; k <= 6; k++) {
        const double u = du[0] + (du[1] - du[0]) * k / 7, v = dv[0] + (dv[1] - dv[0]) * k / 7;
        bat_sweep_point at;
        double on[3], far = 0;
        bat_sweep_at(sweep, u, v, &at);
        bat_surface_eval(surface, u, v, 0, on);
        for (int c = 0; c < 3; c++) far = hypot(far, on[c] - at.point[c]);
        if (!(far <= 1.5 * tolerance)) abort(); /* between the places that the fit looks at */
    }
    bat_surface_free(surface);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bat_sweep_source source;
    bat_problem problem;
    if (bat_sweep_read((const char *)data, size, &source, &problem) != BAT_OK) return 0;
    bat_sweep *sweep = NULL;
    if (bat_function_check(&source.options.twist, NULL) != BAT_OK) abort();
    if (small(source.path) && small(source.profile) && small_function(&source.options.twist) &&
        small_function(&source.options.scale) &&
        bat_sweep_create(source.path, source.profile, &source.options, &sweep) == BAT_OK)
        check(sweep, bat_curve_size(source.path) + bat_curve_size(source.profile));
    bat_sweep_free(sweep);
    bat_sweep_source_clear(&source);
    bat_sweep_options defaults;
    bat_sweep_options_init(&defaults, sizeof defaults);
    bat_function none = defaults.scale;
    bat_function_clear(&none);
    return 0;
}
