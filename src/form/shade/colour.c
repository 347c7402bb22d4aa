/* Looks: the colour of a place of a surface from its normal, the eye and its curvature (light.def). */
#include "form/shade/colour.h"
#include "base/vec.h"

#include <math.h>

typedef struct light {
    double x, y, z, strength;
} light;

static const light lights[] = {
#define BAT_LIGHT(name, x, y, z, strength) {x, y, z, strength},
#include "form/shade/light.def"
};

#define BAT_SHADE(name, value) static const double name = value;
#define BAT_TINT(name, red, green, blue) static const double name[3] = {red, green, blue};
#include "form/shade/light.def"

static double matte(const double normal[3]) {
    double sum = AMBIENT;
    for (size_t k = 0; k < sizeof lights / sizeof *lights; k++) {
        const double way[3] = {lights[k].x, lights[k].y, lights[k].z};
        sum += lights[k].strength * fmax(0, (vec_dot3(normal, way) + WRAP) / (1 + WRAP));
    }
    return sum;
}

double bat_shade_wave(const bat_seen_place *place) {
    const double *n = place->normal, *eye = place->eye;
    const double x = fmin(fmax(2 * vec_dot3(n, eye) * n[1] - eye[1], -1), 1);
    double before = 1, wave = x;
    for (int k = 1; k < (int)STRIPES; k++) {
        const double next = 2 * x * wave - before;
        before = wave, wave = next;
    }
    return wave;
}

/* 0 dark, 1 light. */
static double stripe(const bat_seen_place *place) {
    const double wave = bat_shade_wave(place);
    if (!(place->soft > 0)) return wave > 0;
    return fmin(fmax(0.5 + wave / place->soft, 0), 1);
}

static void mix(const double *a, const double *b, double w, double out[3]) {
    for (int k = 0; k < 3; k++) out[k] = a[k] + w * (b[k] - a[k]);
}

void bat_shade_legend(double share, double out[3]) {
    const double w = fmin(fmax(share, -1), 1);
    mix(NEUTRAL, w < 0 ? COLD : WARM, fabs(w), out);
}

void bat_shade_colour(bat_look look, uint32_t colour, const bat_seen_place *place, double out[3]) {
    const double own[3] = {(colour >> 24) / 255.0, ((colour >> 16) & 255) / 255.0,
                           ((colour >> 8) & 255) / 255.0};
    double lit = 1;
    switch (look) {
    case BAT_LOOK_ZEBRA: mix(STRIPE_DARK, STRIPE_LIGHT, stripe(place), out); break;
    case BAT_LOOK_GAUSS:
    case BAT_LOOK_MEAN:
        bat_shade_legend(place->share, out);
        lit = SOFT + (1 - SOFT) * matte(place->normal);
        break;
    case BAT_LOOK_LINES: out[0] = out[1] = out[2] = 1; break;
    default:
        for (int k = 0; k < 3; k++) out[k] = (colour ? own[k] : CLAY[k]) * (place->back ? BACK[k] : 1);
        lit = matte(place->normal);
        break;
    }
    for (int k = 0; k < 3; k++) out[k] = fmin(out[k] * lit, 1);
}
