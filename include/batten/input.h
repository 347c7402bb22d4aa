/* Batten: what goes into the engine: pointers, the wheel, keys, the size of the window. */
#ifndef BATTEN_INPUT_H
#define BATTEN_INPUT_H

#include <batten/base.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct bat_editor bat_editor;

typedef enum bat_pointer_phase {
    BAT_POINTER_HOVER, /* near, without contact; of a finger: there are some, which hints then speak to */
    BAT_POINTER_DOWN,
    BAT_POINTER_MOVE,
    BAT_POINTER_UP,
    BAT_POINTER_CANCEL,
    BAT_POINTER_LEAVE
} bat_pointer_phase;
typedef enum bat_device { BAT_DEVICE_MOUSE, BAT_DEVICE_PEN, BAT_DEVICE_TOUCH } bat_device;
enum { BAT_SHIFT = 1, BAT_CTRL = 2, BAT_ALT = 4, BAT_META = 8 };
enum { BAT_BUTTON_PRIMARY = 1, BAT_BUTTON_SECONDARY = 2, BAT_BUTTON_MIDDLE = 4, BAT_BUTTON_ERASER = 32 };

typedef struct bat_pointer {
    bat_pointer_phase phase;
    bat_device device;
    uint32_t contact; /* pointer id */
    uint32_t buttons, modifiers;
    double x, y;                  /* view pixels, origin top left */
    double pressure;              /* 0..1 */
    double tilt_x, tilt_y, twist; /* degrees */
    double width, height;         /* of the contact, view pixels; 0: not known */
    double time;                  /* milliseconds, the host's clock */
    bool predicted;               /* for the overlay only, never part of a stroke */
} bat_pointer;

/* Events in order of time, including all coalesced ones. Events with bad numbers are dropped. */
BAT_API void bat_editor_pointer(bat_editor *editor, size_t count, const bat_pointer *events);
/* dx, dy in pixels; the wheel zooms with Ctrl (or by a pinch on a trackpad). */
BAT_API void bat_editor_wheel(bat_editor *editor, double x, double y, double dx, double dy,
                              uint32_t modifiers, double time);
/* Shows the view on the way of its last jump (frame.h: jumps), at that share of it, 0 to 1. It has arrived unless this is
 * called; it arrives at 1, and with the next pointer that goes down, wheel or command. For hosts that animate it. */
BAT_API void bat_editor_glide(bat_editor *editor, double share);
/* key: as KeyboardEvent.key. True when the engine used it (the host then prevents its default). */
BAT_API bool bat_editor_key(bat_editor *editor, const char *key, bool down, uint32_t modifiers, double time);
BAT_API void bat_editor_resize(bat_editor *editor, double width, double height, double pixel_ratio);

#ifdef __cplusplus
}
#endif
#endif
