/* Where entities are put. */
#include "base/real.h"
#include "format/dxf/dxf.h"

#include <math.h>

static const bat_dxf_place DOCUMENT = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};

void bat_dxf_put(const bat_dxf_place *place, const double p[3], double out[3]) {
    const double from[3] = {p[0], p[1], p[2]};
    for (int i = 0; i < 3; i++) {
        const double *m = place->m + 4 * i;
        double sum = m[3];
        for (int k = 0; k < 3; k++)
            if (m[k] != 0) sum += m[k] * from[k];
        out[i] = sum == 0 ? 0 : sum; /* no -0 */
    }
}

bat_dxf_place bat_dxf_within(const bat_dxf_place *outer, const bat_dxf_place *inner) {
    bat_dxf_place out = {{0}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++) {
            double sum = j == 3 ? outer->m[4 * i + 3] : 0;
            for (int k = 0; k < 3; k++) sum += outer->m[4 * i + k] * inner->m[4 * k + j];
            out.m[4 * i + j] = sum;
        }
    return out;
}

void bat_dxf_across(const double a[3], const double b[3], double out[3]) {
    for (int k = 0; k < 3; k++) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    const double length = bat_hypot(bat_hypot(out[0], out[1]), out[2]);
    for (int k = 0; k < 3 && length > 0; k++) out[k] /= length;
}

bat_dxf_place bat_dxf_axes(const double extrusion[3]) {
    const double length = bat_hypot(bat_hypot(extrusion[0], extrusion[1]), extrusion[2]);
    if (!(length > 0)) return DOCUMENT;
    const double z[3] = {extrusion[0] / length, extrusion[1] / length, extrusion[2] / length};
    const bool steep = fabs(z[0]) < 1.0 / 64 && fabs(z[1]) < 1.0 / 64;
    const double up[3] = {0, steep, !steep};
    double x[3], y[3];
    bat_dxf_across(up, z, x);
    bat_dxf_across(z, x, y);
    return (bat_dxf_place){{x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0}};
}
