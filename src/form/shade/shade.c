/*
 * Pictures of surfaces. In bands of rows: first the nearest triangle at each sample, then the colour of each sample and
 * their mean over the pixel. Along a straight line in the image the depth of a plane is linear in parallel projection,
 * and its reciprocal in perspective.
 */
#include "form/shade/shade.h"
#include "form/shade/colour.h"
#include "form/shade/curving.h"
#include "form/shade/soup.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BAND = 32 /* pixels high */, SIDE = BAT_SHADE_SIDE, SAMPLES = SIDE * SIDE };

/* Samples of a band. */
typedef struct band {
    const bat_soup *soup;
    int width, top, rows; /* in samples */
    float *depth;         /* as bat_shading.depth: `rows` rows from `top` */
    double *key;          /* what is linear in the image, less where nearer */
    int *nearest;         /* triangle, or -1 */
} band;

static double key_of(const bat_soup *soup, const bat_corner *c) {
    return soup->gaze.focus > 0 ? -1 / c->far : c->far;
}

static double depth_of(const bat_soup *soup, double key) { return soup->gaze.focus > 0 ? -1 / key : key; }

/* Twice the signed area of a, b and a place; exactly opposite for b, a, so that no sample falls between triangles. */
static double side_of(const bat_corner *a, const bat_corner *b, double x, double y) {
    const bool turned = a->x > b->x || (a->x == b->x && a->y > b->y);
    const bat_corner *p = turned ? b : a, *q = turned ? a : b;
    const double area = (q->x - p->x) * (y - p->y) - (q->y - p->y) * (x - p->x);
    return turned ? -area : area;
}

static double sample_at(int index) { return (index + 0.5) / SIDE; }

static int clamp_index(double x, int most) { return x > 0 ? (x < most ? (int)x : most) : 0; }

/* Shares of the corners at a place, not divided by the area; false: outside. */
static bool shares_at(const bat_corner *const c[3], double area, double x, double y, double out[3]) {
    for (int k = 0; k < 3; k++) {
        out[k] = side_of(c[(k + 1) % 3], c[(k + 2) % 3], x, y);
        if (area > 0 ? out[k] < 0 : out[k] > 0) return false;
    }
    return true;
}

static void draw(band *b, int triangle) {
    const bat_soup *soup = b->soup;
    const int *index = soup->triangle[triangle];
    const bat_corner *c[3] = {soup->corner + index[0], soup->corner + index[1], soup->corner + index[2]};
    const double low_y = fmin(c[0]->y, fmin(c[1]->y, c[2]->y)),
                 high_y = fmax(c[0]->y, fmax(c[1]->y, c[2]->y));
    if (!(high_y * SIDE >= b->top && low_y * SIDE <= b->top + b->rows)) return;
    const double low_x = fmin(c[0]->x, fmin(c[1]->x, c[2]->x)),
                 high_x = fmax(c[0]->x, fmax(c[1]->x, c[2]->x));
    const double area = side_of(c[0], c[1], c[2]->x, c[2]->y);
    if (!(high_x >= 0 && low_x * SIDE <= b->width) || !(area != 0)) return;
    double key[3], w[3];
    for (int k = 0; k < 3; k++) key[k] = key_of(soup, c[k]) / area;
    const int left = clamp_index(floor(low_x * SIDE - 0.5), b->width - 1);
    const int right = clamp_index(ceil(high_x * SIDE), b->width - 1);
    const int top = clamp_index(floor(low_y * SIDE - 0.5) - b->top, b->rows - 1);
    const int bottom = clamp_index(ceil(high_y * SIDE) - b->top, b->rows - 1);
    for (int i = top; i <= bottom; i++)
        for (int j = left; j <= right; j++) {
            if (!shares_at(c, area, sample_at(j), sample_at(b->top + i), w)) continue;
            const double depth = w[0] * key[0] + w[1] * key[1] + w[2] * key[2];
            const size_t at = (size_t)i * (size_t)b->width + (size_t)j;
            if (!(depth < b->key[at])) continue;
            b->key[at] = depth;
            b->nearest[at] = triangle;
        }
}

/* What the colour of a sample depends on. */
typedef struct palette {
    const bat_soup *soup;
    const bat_shaded *surfaces;
    bat_look look;
    double range;
} palette;

static void towards_eye(const bat_gaze *gaze, double x, double y, double out[3]) {
    vec eye = {0, 0, 1};
    if (gaze->focus > 0) eye = vec_unit((vec){gaze->middle[0] - x, y - gaze->middle[1], gaze->focus});
    vec_store(eye, out);
}

/* The side that is seen is that of the triangle; a normal that was bent past the outline is bent back to it. */
static void face_eye(double normal[3], const double eye[3], bool back) {
    vec n = vec_unit(vec_load(normal, 3));
    const vec e = vec_load(eye, 3);
    if (back) n = vec_scale(n, -1);
    const double cosine = vec_dot(n, e);
    if (cosine < 0) n = vec_unit(vec_sub(n, vec_scale(e, cosine)));
    vec_store(n, normal);
}

static void place_at(const palette *p, int triangle, double x, double y, bat_seen_place *out) {
    const int *index = p->soup->triangle[triangle];
    const bat_corner *c[3] = {p->soup->corner + index[0], p->soup->corner + index[1],
                              p->soup->corner + index[2]};
    const double area = side_of(c[0], c[1], c[2]->x, c[2]->y);
    double w[3], value = 0, sum = 0;
    *out = (bat_seen_place){.back = area > 0}; /* y points down */
    for (int k = 0; k < 3; k++) {
        w[k] = side_of(c[(k + 1) % 3], c[(k + 2) % 3], x, y) / area;
        if (p->soup->gaze.focus > 0) w[k] /= c[k]->far;
        sum += w[k];
    }
    for (int k = 0; k < 3; k++) {
        for (int d = 0; d < 3; d++) out->normal[d] += w[k] / sum * c[k]->normal[d];
        value += w[k] / sum * c[k]->value;
    }
    towards_eye(&p->soup->gaze, x, y, out->eye);
    face_eye(out->normal, out->eye, out->back);
    if (p->range > 0) out->share = value / p->range;
}

static uint8_t byte_of(double share) { return (uint8_t)(fmin(fmax(share, 0), 1) * 255 + 0.5); }

/* The edge of a stripe is as wide as the samples are apart. */
static double softness(int count, const bat_seen_place *place) {
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < count; k++) {
        const double wave = bat_shade_wave(place + k);
        low = fmin(low, wave), high = fmax(high, wave);
    }
    return (high - low) / (SIDE - 1);
}

/* The mean of a pixel's samples. i, j: the pixel's first sample in the band. */
static void resolve_pixel(const band *b, const palette *p, int i, int j, uint8_t rgba[4]) {
    double sum[3] = {0, 0, 0}, colour[3];
    bat_seen_place place[SAMPLES];
    int hit = 0, triangle[SAMPLES];
    for (int k = 0; k < SAMPLES; k++) {
        const int row = i + k / SIDE, column = j + k % SIDE;
        triangle[hit] = b->nearest[(size_t)row * (size_t)b->width + (size_t)column];
        if (triangle[hit] < 0) continue;
        place_at(p, triangle[hit], sample_at(column), sample_at(b->top + row), &place[hit]);
        hit++;
    }
    const double soft = p->look == BAT_LOOK_ZEBRA && hit > 0 ? softness(hit, place) : 0;
    for (int k = 0; k < hit; k++) {
        place[k].soft = soft;
        bat_shade_colour(p->look, p->surfaces[p->soup->owner[triangle[k]]].colour, &place[k], colour);
        for (int c = 0; c < 3; c++) sum[c] += colour[c];
    }
    for (int c = 0; c < 3; c++) rgba[c] = byte_of(sum[c] / SAMPLES);
    rgba[3] = byte_of((double)hit / SAMPLES);
}

static void paint_band(band *b, const palette *p, bat_shading *out) {
    const size_t samples = (size_t)b->width * (size_t)b->rows;
    for (size_t k = 0; k < samples; k++) b->key[k] = INFINITY, b->nearest[k] = -1;
    for (size_t k = 0; k < b->soup->triangles; k++) draw(b, (int)k);
    for (size_t k = 0; k < samples; k++)
        b->depth[k] = b->nearest[k] < 0 ? INFINITY : (float)depth_of(b->soup, b->key[k]);
    for (int i = 0; i < b->rows; i += SIDE) {
        uint8_t *row = out->rgba + 4 * (size_t)((b->top + i) / SIDE) * (size_t)out->width;
        for (int j = 0; j < b->width; j += SIDE) resolve_pixel(b, p, i, j, row + 4 * (j / SIDE));
    }
}

static bat_status range_of(const bat_soup *soup, double *out) {
    *out = 0;
    if (soup->corners == 0) return BAT_OK;
    double *size = malloc(soup->corners * sizeof *size);
    if (!size) return BAT_MEMORY;
    for (size_t k = 0; k < soup->corners; k++) size[k] = soup->corner[k].value;
    *out = bat_curving_range(soup->corners, size);
    free(size);
    return BAT_OK;
}

static bat_status paint(const palette *p, bat_shading *out) {
    const size_t most = (size_t)SAMPLES * BAND * (size_t)out->width;
    band b = {.soup = p->soup, .width = SIDE * out->width};
    b.key = malloc(most * sizeof *b.key), b.nearest = malloc(most * sizeof *b.nearest);
    const bat_status status = b.key && b.nearest ? BAT_OK : BAT_MEMORY;
    for (int y = 0; status == BAT_OK && y < out->height; y += BAND) {
        b.top = SIDE * y, b.rows = SIDE * (out->height - y < BAND ? out->height - y : BAND);
        b.depth = out->depth + (size_t)b.top * (size_t)b.width;
        paint_band(&b, p, out);
    }
    free(b.key), free(b.nearest);
    return status;
}

void bat_shading_free(bat_shading *shading) {
    if (!shading) return;
    free(shading->rgba), free(shading->depth);
    free(shading);
}

static bat_status create(const bat_viewpoint *view, bat_shading **out) {
    const double width = view->size[0], height = view->size[1];
    if (width != floor(width) || height != floor(height) || width < 1 || height < 1) return BAT_ARGUMENT;
    if (width * height > BAT_SHADE_PIXELS_MAX) return BAT_COUNT;
    bat_shading *made = calloc(1, sizeof *made);
    if (!made) return BAT_MEMORY;
    made->width = (int)width, made->height = (int)height;
    made->rgba = malloc(4 * (size_t)width * (size_t)height);
    made->depth = malloc(SAMPLES * (size_t)width * (size_t)height * sizeof *made->depth);
    if (!made->rgba || !made->depth) {
        bat_shading_free(made);
        return BAT_MEMORY;
    }
    *out = made;
    return BAT_OK;
}

bat_status bat_shade(const bat_viewpoint *view, size_t count, const bat_shaded *surfaces, bat_look look,
                     bat_shading **out) {
    bat_soup soup = {.corners = 0};
    if (!out || (count > 0 && !surfaces) || look >= BAT_LOOK_COUNT) return BAT_ARGUMENT;
    bat_status status = bat_gaze_of(view, &soup.gaze);
    if (status != BAT_OK) return status;
    bat_shading *made = NULL;
    status = create(view, &made);
    for (size_t k = 0; k < count && status == BAT_OK; k++)
        status = surfaces[k].mesh ? bat_soup_add_mesh(&soup, view, surfaces[k].mesh, (int)k)
                                  : bat_soup_add(&soup, view, surfaces[k].surface, (int)k, look);
    if (status == BAT_OK && (look == BAT_LOOK_GAUSS || look == BAT_LOOK_MEAN))
        status = range_of(&soup, &made->range);
    if (status == BAT_OK) status = paint(&(palette){&soup, surfaces, look, made->range}, made);
    bat_soup_clear(&soup);
    if (status == BAT_OK)
        *out = made;
    else
        bat_shading_free(made);
    return status;
}

bool bat_shading_hides(const bat_shading *shading, const double pixel[2], double depth, double slack) {
    const double x = floor(pixel[0] * SIDE), y = floor(pixel[1] * SIDE);
    double farthest = -INFINITY;
    for (int i = -1; i <= 1; i++)
        for (int j = -1; j <= 1; j++) {
            const double row = y + i, column = x + j;
            if (!(row >= 0 && row < SIDE * shading->height && column >= 0 && column < SIDE * shading->width))
                continue;
            const size_t at = (size_t)row * (size_t)(SIDE * shading->width) + (size_t)column;
            farthest = fmax(farthest, (double)shading->depth[at]);
        }
    return farthest > -INFINITY && depth > farthest + slack;
}
