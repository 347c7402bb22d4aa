/* Bytes become a stroke that is drawn in parts, with a preview after each. Previews are valid curves, and the commit
 * equals the one-shot call. */
#include "strokes.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { PART = 9 };

/* False: the session was cancelled, or there was none. */
static bool draw(const scene *s, bat_sketch_kind kind, bool cancel, bat_status *status, bat_curve **made) {
    const size_t size = (size_t)s->stroke.dimension;
    bat_sketch_live *live;
    if (bat_sketch_live_begin(s->a, s->stroke.dimension, kind, &s->options, &live) != BAT_OK) return false;
    for (size_t i = 0; i < s->stroke.count; i += PART) {
        const bat_stroke part = {.dimension = s->stroke.dimension,
                                 .count = i + PART < s->stroke.count ? PART : s->stroke.count - i,
                                 .points = s->stroke.points + i * size};
        if (bat_sketch_live_add(live, &part) != BAT_OK) abort();
        bat_curve *shown = NULL;
        const bat_status previewed = bat_sketch_live_preview(live, &shown, NULL);
        check_made(previewed, shown);
        bat_curve_free(shown);
    }
    if (cancel) {
        bat_sketch_live_cancel(live);
        return false;
    }
    *status = bat_sketch_live_commit(live, made, NULL);
    return true;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bytes in = {data, size};
    const int choice = small(&in, 255), what = choice / 4 % 8;
    scene s;
    scene_read(&in, choice % 4 == 0, &s);
    bat_curve *made = NULL, *expected = NULL;
    bat_status status = BAT_OK, once;
    const bat_sketch_kind kind = what == 0 || !s.a ? BAT_SKETCH_NEW
                                 : what == 1       ? BAT_SKETCH_SMOOTH
                                                   : BAT_SKETCH_REDRAW;
    if (draw(&s, kind, what == 2, &status, &made)) {
        if (kind == BAT_SKETCH_NEW)
            once = bat_sketch_new(&s.stroke, false, &s.options, &expected, NULL);
        else if (kind == BAT_SKETCH_SMOOTH)
            once = bat_sketch_smooth(s.a, &s.stroke, &s.options, &expected, NULL);
        else
            once = bat_sketch(s.a, &s.stroke, &s.options, &expected, NULL);
        check_made(once, expected);
        if (status != once || (expected && !bat_curve_is_equal(expected, made))) abort();
    }
    bat_curve_free(made);
    bat_curve_free(expected);
    scene_free(&s);
    return 0;
}
