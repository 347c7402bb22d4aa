/*
 * Batten: what version 0.1 called otherwise. Programs written for it compile, with a warning for each call that has a
 * new name; CHANGELOG.md has the table. batten.h brings this header, define BATTEN_ONLY_0_2 before it to do without.
 * It goes with version 0.3.
 *
 * Here are the calls whose name alone changed, and bat_editor_pointer, which every shell of the editor calls: in C it
 * takes its last two arguments in either order. Where other calls changed their order, the compiler says so.
 */
#ifndef BATTEN_BEFORE_0_2_H
#define BATTEN_BEFORE_0_2_H

#include <batten/curve.h>
#include <batten/document.h>
#include <batten/input.h>
#include <batten/levels.h>

#if defined(__GNUC__)
#define BAT_BEFORE_0_2(now) __attribute__((deprecated("it is " #now " now"))) static inline
#else
#define BAT_BEFORE_0_2(now) static inline
#endif

BAT_BEFORE_0_2(bat_curve_is_closed) bool bat_curve_closed(const bat_curve *curve) {
    return bat_curve_is_closed(curve);
}

BAT_BEFORE_0_2(bat_curve_is_equal) bool bat_curve_equal(const bat_curve *a, const bat_curve *b) {
    return bat_curve_is_equal(a, b);
}

BAT_BEFORE_0_2(bat_object_is_hidden) bool bat_object_hidden(const bat_object *object) {
    return bat_object_is_hidden(object);
}

BAT_BEFORE_0_2(bat_object_is_locked) bool bat_object_locked(const bat_object *object) {
    return bat_object_is_locked(object);
}

BAT_BEFORE_0_2(bat_shape_is_muted) bool bat_shape_muted(const bat_shape *shape, int level) {
    return bat_shape_is_muted(shape, level);
}

BAT_BEFORE_0_2(bat_document_insert)
bat_status bat_document_put(bat_document *document, int index, const bat_object *after) {
    return bat_document_insert(document, index, after);
}

#if !defined(__cplusplus) && defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
static inline void bat_editor_pointer_before_0_2(bat_editor *editor, const bat_pointer *events,
                                                 size_t count) {
    bat_editor_pointer(editor, count, events);
}

#define bat_editor_pointer(editor, first, second)                                                            \
    _Generic((first), bat_pointer *                      \
             : bat_editor_pointer_before_0_2, const bat_pointer * \
             : bat_editor_pointer_before_0_2, default    \
             : (bat_editor_pointer))((editor), (first), (second))
#endif

#endif
