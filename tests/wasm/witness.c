/* The functions are wrapped at link time (--wrap; programs.cmake finds them here by the word WRAP): each calls the real one and
 * takes down what came out. None of them may be called in the file that defines it, since linkers differ in
 * whether they wrap that. */
#include "wasm/witness.h"

#include "curve/curve.h"
#include "document/digest.h"
#include "hands/sketch/intent.h"

#include <batten/batten.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { CURVE, DOCUMENT, WRITTEN, VIEW, POINT, NEAR, MEASURE, TRIAD, READING, NOTE, KINDS };
static const char *const names[KINDS] = {"curves",         "documents", "files written", "views",    "points",
                                         "closest points", "measures",  "frames",        "readings", "notes"};
static struct {
    uint32_t count;
    uint64_t sum;
} kinds[KINDS];

static uint64_t mix(uint64_t hash, uint64_t word) {
    hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
    return hash ^ hash >> 29;
}

/* All NaN are one: payload and sign carry nothing. */
static uint64_t mix_number(uint64_t hash, double x) {
    uint64_t bits = 1;
    if (!isnan(x)) memcpy(&bits, &x, sizeof bits);
    return mix(hash, bits);
}

static uint64_t mix_numbers(uint64_t hash, size_t count, const double *x) {
    for (size_t i = 0; i < count; i++) hash = mix_number(hash, x[i]);
    return hash;
}

static uint64_t mix_floats(uint64_t hash, size_t count, const float *x) {
    for (size_t i = 0; i < count; i++) hash = mix_number(hash, (double)x[i]);
    return hash;
}

static uint64_t mix_text(uint64_t hash, const char *text, size_t size) {
    for (size_t i = 0; i < size; i++) hash = mix(hash, (unsigned char)text[i]);
    return mix(hash, size);
}

/* A sum, so that the order in which things are freed does not matter. */
static void note(int kind, uint64_t hash) {
    kinds[kind].count++;
    kinds[kind].sum += mix(hash, 0x632be59bd9b4e019u);
}

static void note_numbers(int kind, size_t count, const double *x) {
    note(kind, mix_numbers(count, count, x));
}

#define WRAP(type, name, ...)                                                                                \
    type __real_##name(__VA_ARGS__);                                                                         \
    type __wrap_##name(__VA_ARGS__);                                                                         \
    type __wrap_##name(__VA_ARGS__)

/* A curve may be given up before it is filled. */
WRAP(bat_status, bat_curve_allocate, int degree, int dimension, bool closed, int count, bat_curve **out) {
    bat_status status = __real_bat_curve_allocate(degree, dimension, closed, count, out);
    if (status != BAT_OK) return status;
    bat_curve *curve = *out;
    memset(curve->knots, 0, (size_t)(curve->spread + degree + 1) * sizeof *curve->knots);
    memset(curve->points, 0, (size_t)(curve->spread * dimension) * sizeof *curve->points);
    return status;
}

WRAP(void, bat_curve_free, bat_curve *curve) {
    if (curve) {
        size_t points = (size_t)bat_point_count(curve) * (size_t)bat_curve_dimension(curve);
        uint64_t hash = mix((uint64_t)bat_curve_degree(curve), points * 2 + bat_curve_is_closed(curve));
        hash = mix_numbers(hash, (size_t)bat_curve_knot_count(curve), bat_curve_knots(curve));
        note(CURVE, mix_numbers(hash, points, bat_curve_points(curve)));
    }
    __real_bat_curve_free(curve);
}

WRAP(void, bat_document_free, bat_document *document) {
    if (document && bat_document_count(document) > 0) note(DOCUMENT, bat_document_digest(document));
    __real_bat_document_free(document);
}

WRAP(bat_status, bat_document_write, const bat_document *document, char **text, size_t *size) {
    bat_status status = __real_bat_document_write(document, text, size);
    if (status == BAT_OK) note(WRITTEN, mix_text(0, *text, *size));
    return status;
}

WRAP(bat_status, bat_svg_write, const bat_document *document, bool native, char **text, size_t *size) {
    bat_status status = __real_bat_svg_write(document, native, text, size);
    if (status == BAT_OK) note(WRITTEN, mix_text(1, *text, *size));
    return status;
}

static uint64_t mix_items(uint64_t hash, uint32_t count, const bat_item *items) {
    for (uint32_t i = 0; i < count; i++) {
        const bat_item *item = &items[i];
        const uint32_t whole[] = {item->id,   item->role, item->flags, item->stroke,
                                  item->fill, item->cap,  item->join,  item->path_count};
        for (size_t k = 0; k < sizeof whole / sizeof *whole; k++) hash = mix(hash, whole[k]);
        hash = mix_floats(hash, 1, &item->width), hash = mix_floats(hash, 1, &item->opacity);
        hash = mix_floats(hash, 4, item->bounds);
        hash = mix_floats(hash, item->path_count, item->path);
    }
    return hash;
}

WRAP(const bat_frame *, bat_editor_frame, bat_editor *editor) {
    const bat_frame *frame = __real_bat_editor_frame(editor);
    uint64_t hash = mix_numbers(mix_numbers(0, 4, frame->view), 2, frame->origin);
    hash = mix_items(mix_items(hash, frame->still_count, frame->still), frame->live_count, frame->live);
    hash = mix_number(mix_number(hash, frame->error), frame->tolerance);
    for (uint32_t i = 0; i < frame->label_count; i++) {
        const bat_label *label = &frame->labels[i];
        hash = mix_floats(mix_floats(hash, 2, label->at), 2, label->offset);
        hash = mix_text(hash, label->text, strlen(label->text));
    }
    hash = mix_text(hash, frame->hint, strlen(frame->hint));
    note(VIEW, mix_text(hash, frame->notice, strlen(frame->notice)));
    return frame;
}

WRAP(void, bat_curve_eval, const bat_curve *curve, double u, int order, double *out) {
    __real_bat_curve_eval(curve, u, order, out);
    note_numbers(POINT, (size_t)((order > 0 ? order : 0) + 1) * (size_t)bat_curve_dimension(curve), out);
}

WRAP(void, bat_curve_eval_left, const bat_curve *curve, double u, int order, double *out) {
    __real_bat_curve_eval_left(curve, u, order, out);
    note_numbers(POINT, (size_t)((order > 0 ? order : 0) + 1) * (size_t)bat_curve_dimension(curve), out);
}

WRAP(bat_status, bat_curve_eval_many, const bat_curve *curve, size_t count, const double *u, int order,
     double *out) {
    bat_status status = __real_bat_curve_eval_many(curve, count, u, order, out);
    if (status == BAT_OK)
        note_numbers(POINT, count * (size_t)(order + 1) * (size_t)bat_curve_dimension(curve), out);
    return status;
}

static void note_near(const bat_near *near, int size) {
    note(NEAR, mix_numbers(mix_number(mix_number(0, near->u), near->distance), (size_t)size, near->point));
}

WRAP(bat_status, bat_curve_nearest, const bat_curve *curve, const double *point, bat_near *out) {
    bat_status status = __real_bat_curve_nearest(curve, point, out);
    if (status == BAT_OK) note_near(out, bat_curve_dimension(curve));
    return status;
}

WRAP(double, bat_curve_at_length, const bat_curve *curve, double u0, double s, double relative) {
    double u = __real_bat_curve_at_length(curve, u0, s, relative);
    return note_numbers(MEASURE, 1, &u), u;
}

WRAP(double, bat_curve_curvature, const bat_curve *curve, double u) {
    double curvature = __real_bat_curve_curvature(curve, u);
    return note_numbers(MEASURE, 1, &curvature), curvature;
}

WRAP(void, bat_curve_bounds, const bat_curve *curve, double *low, double *high) {
    __real_bat_curve_bounds(curve, low, high);
    note_numbers(MEASURE, (size_t)bat_curve_dimension(curve), low);
    note_numbers(MEASURE, (size_t)bat_curve_dimension(curve), high);
}

WRAP(bat_status, bat_frames, const bat_curve *curve, size_t count, const double *u,
     const bat_frame_options *options, bat_frame3 *out, double *holonomy) {
    bat_status status = __real_bat_frames(curve, count, u, options, out, holonomy);
    for (size_t i = 0; i < count && status == BAT_OK; i++) note_numbers(TRIAD, 13, &out[i].u);
    return status;
}

WRAP(void, bat_frame_chain_at, const bat_frame_chain *chain, double u, bat_frame3 *out) {
    __real_bat_frame_chain_at(chain, u, out);
    note_numbers(TRIAD, 13, &out->u);
}

WRAP(bat_status, bat_frame_chain_many, const bat_frame_chain *chain, size_t count, const double *u,
     const bat_frame_arrays *out) {
    bat_status status = __real_bat_frame_chain_many(chain, count, u, out);
    const double *lists[] = {out ? out->point : NULL, out ? out->t : NULL, out ? out->s : NULL,
                             out ? out->r : NULL};
    for (int i = 0; i < 4 && status == BAT_OK; i++)
        if (lists[i]) note_numbers(TRIAD, 3 * count, lists[i]);
    return status;
}

WRAP(bat_status, bat_intent_rank, bat_intent *intent, bool whole, bat_intent_reading *out, int *count) {
    bat_status status = __real_bat_intent_rank(intent, whole, out, count);
    for (int i = 0; i < *count && status == BAT_OK; i++) {
        uint64_t hash = mix_number(mix(out[i].kind, (uint64_t)out[i].count), out[i].cost);
        for (int k = 0; k < out[i].count; k++) {
            const bat_intent_part *part = &out[i].part[k];
            hash = mix_numbers(mix(hash, (uint64_t)part->line * 3 + (uint64_t)(part->sense + 1)), 2,
                               part->along);
        }
        note(READING, hash);
    }
    return status;
}

_Static_assert(sizeof(bat_frame3) == 13 * sizeof(double), "a frame is its numbers");

void witness_number(uint64_t number) { note(NOTE, (uint32_t)number); } /* a size_t has 32 bits there */
void witness_note(const char *text) { note(NOTE, mix_text(0, text, strlen(text))); }

const char *witness_take(void) {
    static char lines[KINDS * 60];
    size_t used = 0;
    for (int i = 0; i < KINDS; i++) {
        char sum[17];
        bat_digest_print(kinds[i].sum, sum);
        used += (size_t)snprintf(lines + used, sizeof lines - used, "%s: %lu %s\n", names[i],
                                 (unsigned long)kinds[i].count, sum);
    }
    memset(kinds, 0, sizeof kinds);
    return lines;
}
