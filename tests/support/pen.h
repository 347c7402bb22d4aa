/* Deterministic pen strokes and small documents for tests of the engine. */
#ifndef BATTEN_TESTS_PEN_H
#define BATTEN_TESTS_PEN_H

#include <batten/batten.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct pen {
    bat_editor *editor;
    bat_device device;
    uint32_t contact, buttons, modifiers;
    double time;
} pen;

static inline pen pen_for(bat_editor *editor) {
    return (pen){.editor = editor,
                 .device = BAT_DEVICE_PEN,
                 .contact = 1,
                 .buttons = BAT_BUTTON_PRIMARY,
                 .time = 1000};
}

/* One event, 4 ms after the last. */
static inline void pen_event(pen *p, bat_pointer_phase phase, double x, double y) {
    p->time += 4;
    bat_pointer event = {.phase = phase,
                         .device = p->device,
                         .contact = p->contact,
                         .buttons = phase == BAT_POINTER_HOVER || phase == BAT_POINTER_UP ? 0 : p->buttons,
                         .modifiers = p->modifiers,
                         .x = x,
                         .y = y,
                         .pressure = 0.5 + 0.25 * sin(p->time / 100),
                         .tilt_x = 20,
                         .tilt_y = -5,
                         .time = p->time};
    bat_editor_pointer(p->editor, 1, &event);
}

/* A point of a stroke for t in 0..1. */
typedef void pen_path(double t, const double *numbers, double out[2]);

/* x0 y0 x1 y1 bulge: a straight line, or an arch that rises by bulge in its middle (down is positive y). */
static inline void pen_arch(double t, const double *n, double out[2]) {
    double lift = 4 * t * (1 - t) * n[4], dx = n[2] - n[0], dy = n[3] - n[1],
           length = sqrt(dx * dx + dy * dy);
    if (length == 0) length = 1;
    out[0] = n[0] + t * dx + lift * dy / length;
    out[1] = n[1] + t * dy - lift * dx / length;
}

/* Down, then `count` moves along the path; the pen stays down. */
static inline void pen_begin(pen *p, pen_path *path, const double *numbers, int count) {
    double at[2];
    path(0, numbers, at);
    pen_event(p, BAT_POINTER_DOWN, at[0], at[1]);
    for (int i = 1; i <= count; i++) {
        path((double)i / count, numbers, at);
        pen_event(p, BAT_POINTER_MOVE, at[0], at[1]);
        if (i % 8 == 0) bat_editor_frame(p->editor);
    }
}

static inline void pen_stroke(pen *p, pen_path *path, const double *numbers, int count) {
    double at[2];
    pen_begin(p, path, numbers, count);
    path(1, numbers, at);
    pen_event(p, BAT_POINTER_UP, at[0], at[1]);
}

static inline void pen_line(pen *p, double x0, double y0, double x1, double y1, double bulge) {
    pen_stroke(p, pen_arch, (double[]){x0, y0, x1, y1, bulge}, 60);
}

/* A cubic curve with count control points along y = height, alternating by wave. */
static inline bat_curve *pen_curve(double x, double y, double step, double wave, int count) {
    double points[64], knots[40];
    for (int i = 0; i < count; i++) {
        points[2 * i] = x + step * i;
        points[2 * i + 1] = y + wave * sin(i);
    }
    for (int i = 0; i < count + 4; i++) knots[i] = i < 4 ? 0 : i >= count ? count - 3 : i - 3;
    bat_curve *curve = NULL;
    bat_curve_create(2, 3, false, (size_t)count, points, count + 4, knots, &curve);
    return curve;
}

/* Appends a path of one curve, taking ownership of it; returns the path's id. */
static inline bat_id pen_add(bat_document *document, bat_curve *curve) {
    bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    bat_id id = bat_document_new_id(document);
    bat_object_create_path(id, "line", &style, 1, &curve, &object);
    bat_document_insert(document, bat_document_count(document), object);
    bat_object_release(object);
    return id;
}

/* An editor of 1000 x 800 px on a page of the same size with two curves: y = 200 and y = 600, x 200 to 800.
 * One document unit is one pixel and the origins agree. */
static inline bat_editor *pen_editor(void) {
    bat_document *document = NULL;
    bat_editor *editor = NULL;
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    pen_add(document, pen_curve(200, 200, 60, 0, 11));
    pen_add(document, pen_curve(200, 600, 60, 0, 11));
    bat_editor_create(&editor);
    bat_editor_resize(editor, 1000, 800, 1);
    bat_editor_open(editor, document, "test");
    bat_editor_command(editor, "zoom-100");
    return editor;
}

static inline const bat_item *pen_live(const bat_frame *frame, bat_role role) {
    for (uint32_t i = 0; i < frame->live_count; i++)
        if (frame->live[i].role == (uint32_t)role) return &frame->live[i];
    return NULL;
}

#endif
