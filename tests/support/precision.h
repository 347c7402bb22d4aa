/* Lines to snap to, and checks of snapping. Include after cmocka.h. */
#ifndef BATTEN_TESTS_PRECISION_H
#define BATTEN_TESTS_PRECISION_H

#include "base/real.h"
#include "editor/editor.h"
#include "support/editing.h"

/* A polyline of degree 1. */
static inline bat_curve *polyline(int count, const double *points) {
    double knots[16];
    bat_curve *curve = NULL;
    for (int i = 0; i < count + 2; i++) knots[i] = i == 0 ? 0 : i > count ? count - 1 : i - 1;
    assert_int_equal(bat_curve_create(2, 1, false, (size_t)count, points, count + 2, knots, &curve), BAT_OK);
    return curve;
}

static inline bat_curve *segment(double x0, double y0, double x1, double y1) {
    return polyline(2, (double[]){x0, y0, x1, y1});
}

static inline void at_once(const bat_snap *snap, bat_snap_kind kind, double x, double y) {
    if (snap->kind != kind || !(bat_hypot(snap->point[0] - x, snap->point[1] - y) < 1e-9))
        fail_msg("kind %d at %.12g %.12g, not %d at %.12g %.12g", (int)snap->kind, snap->point[0],
                 snap->point[1], (int)kind, x, y);
}

static inline bat_snap snap(bat_editor *editor, double x, double y) {
    double point[2] = {x, y};
    bat_snap_point(&editor->context, 0, NULL, point);
    assert_null(bat_editor_check(editor));
    return editor->snap;
}

static inline int guides(const bat_editor *editor, int axis, double *at) {
    int found = 0;
    double place;
    for (int i = 0; i < bat_document_count(editor->session.document); i++)
        if (bat_object_guide(bat_document_at(editor->session.document, i), &place) == axis) {
            *at = place;
            found++;
        }
    return found;
}

#endif
