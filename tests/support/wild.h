/* Random sessions with everything that the editor can do: every command and every property of the tables, numbers
 * entered, levels, layers, the list of objects, pictures and the clipboard, besides the events of session.h. */
#ifndef BATTEN_TESTS_WILD_H
#define BATTEN_TESTS_WILD_H

#include "support/pictures.h"
#include "support/session.h"
#include "support/sheet.h"
#include "support/xml.h"
#include <stdio.h>

/* Pastes SVG with arbitrary numbers: open, closed, crowded, of zero length, in a group, under a transform; sometimes
 * with a surface above. */
static inline void wild_paste(bat_editor *editor, session_bytes *bytes) {
    char text[400];
    int n[8];
    for (int i = 0; i < 8; i++) n[i] = session_byte(bytes) * 4 - 20;
    snprintf(text, sizeof text,
             "<svg xmlns='http://www.w3.org/2000/svg'><g transform='rotate(%d) scale(%g)' stroke='red'>"
             "<path d='M%d %dC%d %d %d %d %d %d%sL%d %d'/><ellipse cx='%d' rx='%d' ry='7'/></g></svg>",
             n[0], n[1] / 100.0, n[2], n[3], n[4], n[5], n[6], n[7], n[2], n[3], n[0] & 4 ? "Z" : "", n[1],
             n[1], n[6], n[7]);
    bat_document *document = NULL;
    bat_svg_report report;
    bat_problem problem;
    if (xml_read(text, NULL, &document, &report, &problem) == BAT_OK) {
        if (n[7] & 8) {
            bat_surface *surface = sheet_create();
            if (surface) sheet_add(document, bat_document_new_id(document), surface);
            bat_surface_free(surface);
        }
        bat_editor_paste(editor, document, n[0] & 8);
    }
    bat_document_free(document);
}

static inline void wild_copy(bat_editor *editor, bool cut, bool own) {
    char *text = NULL;
    size_t size = 0;
    bat_document *document = NULL;
    bat_svg_report report;
    bat_problem problem;
    if (bat_editor_copy(editor, cut, &text, &size) == BAT_OK &&
        xml_read(text, NULL, &document, &report, &problem) == BAT_OK)
        bat_editor_paste(editor, document, own);
    bat_document_free(document);
    bat_free(text);
}

/* Sets a property, mostly within its range; sometimes at its ends, beyond them, or to NaN. */
static inline void wild_property(bat_editor *editor, session_bytes *bytes) {
    static const struct {
        const char *name;
        double low, high;
    } properties[] = {
#define PROPERTY(id, name, type, standard, low, high, step, unit, group) {name, low, high},
#include "editor/tables/commands.def"
    };
    unsigned which = session_byte(bytes) % (unsigned)(sizeof properties / sizeof *properties);
    double low = properties[which].low, high = fmin(properties[which].high, low + 300);
    uint8_t share = session_byte(bytes);
    double value = share == 255   ? NAN
                   : share == 254 ? 1e300
                   : share == 253 ? -1
                                  : low + (high - low) * (share % 16) / 15;
    bat_editor_set(editor, properties[which].name, value);
}

static inline bat_id wild_id(const bat_editor *editor, session_bytes *bytes) {
    const bat_document *document = bat_editor_document(editor);
    int count = bat_document_count(document), which = session_byte(bytes);
    return which == 255 || count == 0 ? 77 : bat_object_id(bat_document_at(document, which % count));
}

/* Writes a text, or what is no text. */
static inline void wild_text(bat_editor *editor, unsigned more) {
    static const char *const texts[] = {
        "{\"text\":\"a\\nb\",\"box\":[0,-20,30,40]}",
        "{\"text\":\"\"}",
        "{\"text\":\"c\",\"box\":[0,0,0,0]}",
        "[{\"id\":1,\"text\":\"d\"}]",
        "{\"text\":\"e\",\"box\":[0,-9,9,9],\"size\":7,\"align\":\"end\",\"fill\":\"#11223344\"}",
        "{"};
    const char *text = texts[more % 6];
    bat_editor_write(editor, text, strlen(text), NULL);
    bat_editor_writing(editor);
    bat_editor_texts(editor);
    if (more & 32) bat_editor_command(editor, "text-edit");
}

/* Other calls that hosts make. */
static inline void wild_host(bat_editor *editor, session_bytes *bytes) {
    static const char *const keys[] = {"Ctrl+Q", "Q Shift+Q", "", NULL, "Ctrl+", "+", "\xff"};
    static const char *const words[] = {"{\"HINT_PAN\":\"%\"}", "{}", "[", "{\"TOOL_SKETCH\":\"\u00e4\"}"};
    static const char *const names[] = {"roof", "", "\xed\x95\x9c", "\xff"};
    uint8_t what = session_byte(bytes), more = session_byte(bytes);
    bat_losses lost = {{0}};
    double value = 0;
    switch (what % 11) {
    case 0: bat_editor_get(editor, "tolerance", &value); break;
    case 1:
        value = bat_editor_pressure(editor, more / 200.0 - 0.1);
        if (!(value >= 0.25 && value <= 1)) abort();
        break;
    case 2: bat_editor_bind(editor, more & 1 ? "undo" : "zoom-in", keys[more / 2 % 7]); break;
    case 3: bat_editor_tables(editor); break;
    case 4:
        bat_editor_words(editor, more & 4 ? NULL : words[more % 4], more & 4 ? 0 : strlen(words[more % 4]),
                         NULL);
        break;
    case 5: bat_editor_saved(editor); break;
    case 6:
        lost.count[more % BAT_LOSS_COUNT] = more;
        if (bat_editor_set_losses(editor, more & 1 ? &lost : NULL) == BAT_OK &&
            bat_losses_total(bat_editor_losses(editor)) != (more & 1 ? more : 0))
            abort();
        break;
    case 7: bat_editor_rename(editor, wild_id(editor, bytes), names[more % 4]); break;
    case 8:
        bat_editor_picture(editor, more);
        wild_text(editor, more);
        break;
    case 9:
        bat_editor_refit(editor, more % 7 / 5.0, more & 8);
        bat_editor_refit_other(editor, more % 3 / 2.0, more & 8);
        break;
    default:
        bat_editor_readings(editor);
        bat_editor_read_as(editor, more % 5 - 1);
        bat_editor_seek(editor, more == 255 ? (double)NAN : more / 40.0 - 1);
        if (more & 1) bat_editor_command(editor, "move-play");
        for (int i = 0; i < 3; i++) bat_editor_play(editor, more * 30.0 * i);
        const double stroke[4] = {more % 7 / 6.0, more % 5 / 4.0, more % 11 / 10.0,
                                  more == 254 ? (double)NAN : 0.5};
        if (more & 2) bat_editor_retime(editor, 2, stroke, more & 4);
        bat_editor_move_set(editor, (bat_move_act)(more % 9), more & 16, more % 3, more / 32 * 0.7, more & 8);
        const double size[2] = {more == 253 ? (double)INFINITY : 320, 180},
                     from[2] = {stroke[0] * 320, stroke[1] * 180};
        const double to[2] = {stroke[2] * 320, more == 252 ? (double)NAN : 70};
        if (more & 4) bat_editor_correct(editor, (bat_correction)(more / 8 % 6), size, from, to, more & 1);
        bat_editor_move(editor);
        bat_editor_frame(editor);
        bat_editor_space(editor);
        bat_editor_lens(editor, size);
    }
}

static inline void wild_event(bat_editor *editor, session_bytes *bytes, double *time) {
    static const char *const commands[] = {
#define COMMAND(id, name, keys, when, function) name,
#define HELD(id, name, keys, function) name,
#include "editor/tables/commands.def"
    };
    static const char *const numbers[] = {
#define NUMBER(id, name) name,
#include "editor/tables/commands.def"
    };
    static const char *const texts[] = {"12", "3mm+4", "1/2in", "-7",    "0",      "1e",
                                        "90", "400",   "",      "1e300", "-1e-300"};
    unsigned what = session_byte(bytes), count = sizeof commands / sizeof *commands;
    if (what < 96) {
        bat_editor_command(editor, commands[session_byte(bytes) % count]);
    } else if (what < 112) {
        wild_property(editor, bytes);
    } else if (what < 120) {
        unsigned number = session_byte(bytes) % (unsigned)(sizeof numbers / sizeof *numbers);
        bat_editor_enter(editor, numbers[number], texts[session_byte(bytes) % 11]);
        bat_editor_number(editor, numbers[number]);
    } else if (what < 128) {
        uint8_t more = session_byte(bytes);
        bat_editor_level(editor, (bat_level_act)(more % 4), more / 4 % 5, more / 32 * 0.5, more > 80);
        bat_editor_levels(editor);
    } else if (what < 134) {
        bat_editor_select(editor, wild_id(editor, bytes), what & 1);
    } else if (what < 138) {
        bat_id id = wild_id(editor, bytes);
        bat_editor_choose(editor, id, session_byte(bytes) % 20);
        bat_editor_outline(editor, what == 134 ? 0 : session_byte(bytes), 40);
        bat_editor_outline_points(editor, wild_id(editor, bytes));
        bat_editor_unshown(editor);
        bat_editor_mixed(editor);
        bat_editor_colours(editor);
        bat_editor_history(editor);
        bat_editor_holds(editor);
        bat_editor_said(editor);
    } else if (what < 141) {
        bat_editor_set_state(editor, wild_id(editor, bytes), what == 138, what == 139);
    } else if (what < 144) {
        bat_id id = wild_id(editor, bytes);
        bat_editor_place_layer(editor, id, wild_id(editor, bytes));
        bat_editor_activate_layer(editor, wild_id(editor, bytes));
        bat_editor_layers(editor);
        bat_editor_actions(editor);
        bat_editor_refused(editor);
    } else if (what < 148) {
        wild_paste(editor, bytes);
    } else if (what < 150) {
        wild_copy(editor, what & 1, session_byte(bytes) & 1);
    } else if (what < 152) {
        unsigned char head[HEAD_ROOM];
        uint8_t width = session_byte(bytes), height = session_byte(bytes);
        size_t size = head_png(head, width, height);
        bat_editor_add_picture(editor, head, size, NULL);
    } else if (what < 153) {
        bat_editor_compact(editor);
        bat_editor_go(editor, session_byte(bytes) % 8);
    } else if (what < 154) {
        bat_editor_set_read_only(editor, session_byte(bytes) & 1);
    } else if (what < 162) {
        wild_host(editor, bytes);
    } else {
        session_event(editor, bytes, time);
    }
}

/* Ends whatever operation may still be open. */
static inline void wild_settle(bat_editor *editor) {
    bat_editor_set_read_only(editor, false);
    for (int i = 0; i < 6; i++) bat_editor_command(editor, "cancel");
    bat_editor_frame(editor);
}

#endif
