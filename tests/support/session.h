/* Random sessions: a stream of bytes becomes events of every kind, sensible or not. Shared by the random session test
 * and the fuzzer. */
#ifndef BATTEN_TESTS_SESSION_H
#define BATTEN_TESTS_SESSION_H

#include "support/pen.h"

/* Bytes in order; zeros once they are used up. */
typedef struct session_bytes {
    const uint8_t *data;
    size_t size, at;
} session_bytes;

/* Fills data with random bytes from *seed, which advances. */
static inline session_bytes session_random(uint8_t *data, size_t size, uint64_t *seed) {
    for (size_t i = 0; i < size; i++) {
        *seed = *seed * 6364136223846793005u + 1442695040888963407u;
        data[i] = (uint8_t)(*seed >> 56);
    }
    return (session_bytes){data, size, 0};
}

static inline uint8_t session_byte(session_bytes *bytes) {
    size_t at = bytes->at++;
    return at < bytes->size ? bytes->data[at] : (uint8_t)0;
}

static inline double session_place(session_bytes *bytes) {
    uint8_t high = session_byte(bytes), low = session_byte(bytes);
    if (high == 255) {
        static const double odd[] = {NAN, INFINITY, -INFINITY, 1e300, -1e300, 1e-320, -0.0, 1e6};
        return odd[low & 7];
    }
    return (high * 256 + low) / 65.536 - 20; /* mostly in a window of 960 px */
}

/* A whole stroke with a number of samples, so that a session is more than noise. */
static inline void session_stroke(bat_editor *editor, session_bytes *bytes, double *time) {
    static const double rows[] = {200, 600, 400, 300};
    pen p = pen_for(editor);
    uint8_t kind = session_byte(bytes);
    p.time = *time;
    for (unsigned i = 0; i < 9 && kind & 4; i++) { /* lift all other contacts, so that this one draws */
        p.device = (bat_device)(i % 3);
        p.contact = i / 3;
        pen_event(&p, BAT_POINTER_CANCEL, 0, 0);
    }
    p.contact = 1;
    p.device = (bat_device)(kind % 3);
    p.modifiers = kind & 8 ? BAT_ALT : 0;
    double y = rows[kind >> 4 & 3] + session_byte(bytes) % 10, x = 150 + 3 * session_byte(bytes);
    double length = 20 + session_byte(bytes), bulge = session_byte(bytes) - 128;
    double rise = kind & 64 ? session_byte(bytes) - 128 : 0;
    pen_begin(&p, pen_arch, (double[]){x, y, x + length, y + rise, bulge / 2}, 12 + session_byte(bytes) % 40);
    if (kind & 128) { /* held until it becomes a figure, and dragged */
        p.time += 450;
        pen_event(&p, BAT_POINTER_MOVE, x + length, y + rise);
        pen_event(&p, BAT_POINTER_MOVE, x + length + bulge, y + rise);
    }
    if (session_byte(bytes) % 16) pen_event(&p, BAT_POINTER_UP, x + length, y + rise);
    *time = p.time;
}

static inline void session_event(bat_editor *editor, session_bytes *bytes, double *time) {
    static const char *const commands[] = {
        "undo",           "redo",      "accept",       "cancel",        "view-fit",      "zoom-in",
        "zoom-out",       "zoom-100",  "tool-pan",     "tool-sketch",   "save",          "tolerance-up",
        "tolerance-down", "hold-pan",  "pan-left",     "nonsense",      "tool-tangents", "tool-tangents",
        "point-next",     "point-add", "point-delete", "point-default", "nudge-up",      "free-curve"};
    static const char *const keys[] = {"z",   "y",   "Enter",     "Escape",    " ", "[", "]",
                                       "Alt", "1",   "f",         "n",         "h", "",  "+",
                                       "t",   "Tab", "Backspace", "ArrowLeft", "d"};
    static const char *const properties[] = {"tolerance", "transition-width", "keep-corners",
                                             "palm-rejection"};
    uint8_t what = session_byte(bytes);
    *time += what % 32;
    if (what < 120) {
        bat_pointer event = {.phase = (bat_pointer_phase)(what % 6),
                             .device = (bat_device)(what / 6 % 3),
                             .contact = what / 18 % 3u,
                             .time = *time};
        uint8_t more = session_byte(bytes);
        event.buttons = more % 4 ? BAT_BUTTON_PRIMARY : (uint32_t)more;
        event.modifiers = more & 64 ? more >> 4 : 0u;
        event.predicted = (more & 31) == 31;
        event.x = session_place(bytes);
        event.y = session_place(bytes);
        event.pressure = session_place(bytes) / 900;
        event.width = more & 128 ? event.pressure * 200 : 0;
        bat_editor_pointer(editor, 1, &event);
    } else if (what < 200) {
        session_stroke(editor, bytes, time);
    } else if (what < 210) {
        double x = session_place(bytes), y = session_place(bytes), dy = session_place(bytes) - 450;
        bat_editor_wheel(editor, x, y, session_byte(bytes) - 128.0, dy, what & 7u, *time);
    } else if (what < 220) {
        uint8_t more = session_byte(bytes);
        bat_editor_key(editor, keys[more % 19], more < 200, what & 7u, *time);
    } else if (what < 240) {
        bat_editor_command(editor, commands[session_byte(bytes) % 24]);
    } else if (what < 245) {
        double width = session_place(bytes), height = session_place(bytes);
        bat_editor_resize(editor, width, height, session_place(bytes) / 300);
    } else if (what < 250) {
        uint8_t more = session_byte(bytes);
        bat_editor_set(editor, properties[more % 4], session_place(bytes) / 40);
    } else {
        bat_editor_frame(editor);
    }
}

#endif
