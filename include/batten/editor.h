/*
 * Batten: the engine. A headless, deterministic editor: no clock, no randomness, no input or output of its own.
 * The host feeds pointer events, keys, commands by name and property values; the engine answers with one frame:
 * what to paint, what to say, what it wants of the host. Every shell (the browser page, the tests, replay) is
 * such a host, and holds no list of commands of its own.
 */
#ifndef BATTEN_EDITOR_H
#define BATTEN_EDITOR_H

#include <batten/document.h>
#include <batten/format.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct bat_editor bat_editor;

BAT_API bat_status bat_editor_create(bat_editor **out);
BAT_API void bat_editor_free(bat_editor *editor);
BAT_API const bat_document *bat_editor_document(const bat_editor *editor);
/* A document opened anew: history emptied, view fitted, journal begun with a snapshot. Takes the document over
 * on success; on failure nothing changes and it stays the caller's. A stroke under way is cancelled. */
BAT_API bat_status bat_editor_open(bat_editor *editor, bat_document *document, const char *name);

/* ---- input ---- */

typedef enum bat_pointer_phase {
    BAT_POINTER_HOVER,
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

/* Events in order of time; coalesced ones are simply all there. Bad numbers are dropped. */
BAT_API void bat_editor_pointer(bat_editor *editor, size_t count, const bat_pointer *events);
/* dx, dy in pixels; zoom: Ctrl or a pinch on a trackpad. */
BAT_API void bat_editor_wheel(bat_editor *editor, double x, double y, double dx, double dy,
                              uint32_t modifiers, double time);
/* key: as KeyboardEvent.key. True when the engine used it (the host then prevents its default). */
BAT_API bool bat_editor_key(bat_editor *editor, const char *key, bool down, uint32_t modifiers, double time);
BAT_API void bat_editor_resize(bat_editor *editor, double width, double height, double pixel_ratio);
/* Commands and properties by name, as the table (commands.def) lists them. BAT_UNSUPPORTED: no such name.
 * BAT_STATE: not now (nothing to undo). */
BAT_API bat_status bat_editor_command(bat_editor *editor, const char *name);
BAT_API bat_status bat_editor_set(bat_editor *editor, const char *property, double value);
BAT_API bat_status bat_editor_get(const bat_editor *editor, const char *property, double *value);
/* Numbers as text, in the unit in force: of what is chosen (the table's numbers), or a property. What is entered may
 * be an expression ("1in + 3mm"); a number of what is chosen is a step of the history. BAT_SYNTAX: no such expression;
 * BAT_STATE: there is nothing it could change now, or a drag is under way; else as bat_editor_set. */
BAT_API bat_status bat_editor_enter(bat_editor *editor, const char *name, const char *text);
/* The number as it is now ("12.5 mm"), "" when there is none; valid until the next call. A property in view pixels is
 * told as the length that it has in the drawing. */
BAT_API const char *bat_editor_number(bat_editor *editor, const char *name);
/* What a pen's pressure (0..1) counts as with the properties as they are: the share of a brush's reach, 0.25..1; it
 * never falls as the pressure rises. 1 when pressure is switched off. */
BAT_API double bat_editor_pressure(const bat_editor *editor, double pressure);
/* The shortcuts of a command, for this editor: keys as the tables write them ("Ctrl+Shift+Z Ctrl+Y"), "" for none,
 * NULL for the default. BAT_UNSUPPORTED: no such command; BAT_ARGUMENT: too long or not well-formed. */
BAT_API bat_status bat_editor_bind(bat_editor *editor, const char *command, const char *keys);
/*
 * The tables as JSON, for menus, panels, the shortcut sheet and the manual, with the present shortcuts:
 * {"commands":[{"name","label","help","keys":[...],"section":key of its word,"hold"}], "properties":[{"name","label","help","type",
 *  "default","low","high","step","unit","choices":[keys of their words, of type choice only]}],
 *  "tools":[{"name","label","help","command","keys":[...]}], "numbers":[names], "strings":{key:text}}. The browser's
 *  module has no helps.
 * Owned by the editor, valid until the next call of it; NULL when out of memory.
 */
BAT_API const char *bat_editor_tables(bat_editor *editor);
/* The words of another language: UTF-8 JSON {key:text}, as the build makes them of the table (words.ko.json). A text
 * that is not there stays English; so does one with more or fewer "%" (places of values) than the English. NULL, 0:
 * English. The words are copied. BAT_SYNTAX, BAT_MEMORY: nothing changed. Never part of document or journal. */
BAT_API bat_status bat_editor_words(bat_editor *editor, const char *text, size_t size);
/* The host has saved the document as it was when it took the frame that asked for it (or, when none did, as it
 * is now): that state is clean from now on. */
BAT_API void bat_editor_saved(bat_editor *editor);
/* What the file that was opened holds and the document does not (bat_svg_report), so that writing over the file would
 * lose it: the host says so after opening, and NULL (nothing) once it has written over the file. Before it does so it
 * asks the user. Kept with the session, and in the journal. */
BAT_API bat_status bat_editor_set_losses(bat_editor *editor, const bat_losses *losses);
BAT_API const bat_losses *bat_editor_losses(const bat_editor *editor); /* never NULL */
/* The document can be looked at and exported, not changed and not saved: a pointer moves the view, and what would
 * change something says why not. Drops what is under way. A host that does not own the document asks for it;
 * opening and replay are the host's own and go on. */
BAT_API void bat_editor_set_read_only(bat_editor *editor, bool read_only);

/* ---- layers and objects by id, for panels ---- */

/* The layers, back to front, as JSON: {"layers":[{"id","name","hidden","locked","depth","members"}], "active":id,
 * "loose": objects in no layer, "pictures": images}. Owned by the editor, valid until the next call of it; NULL: out of memory. */
BAT_API const char *bat_editor_layers(bat_editor *editor);
/* The commands that arrange or mend what is selected, as far as this selection makes them possible: names, with a
 * space between. Only while the select tool is in force, which shows what is selected. Owned by the editor, valid until
 * the next call of it; NULL: out of memory. */
BAT_API const char *bat_editor_actions(bat_editor *editor);
/* Moves a layer to where another one beside it is: in front of it when it comes from behind, else behind it: a step of
 * the history. BAT_ARGUMENT: they are no layers of one group. */
BAT_API bat_status bat_editor_place_layer(bat_editor *editor, bat_id id, bat_id target);
/* The layer that new curves go into; 0: none. */
BAT_API bat_status bat_editor_activate_layer(bat_editor *editor, bat_id id);
/* Steps of the history, of any object. BAT_STATE: a drag is under way. */
BAT_API bat_status bat_editor_rename(bat_editor *editor, bat_id id, const char *name);
BAT_API bat_status bat_editor_set_state(bat_editor *editor, bat_id id, bool hidden, bool locked);
/* The drawing for those who do not see it, in words. Owned by the editor, valid until the next call of either; NULL:
 * out of memory.
 * outline: objects first, first + 1 ... of the document, back to front, at most `count` and 500, as JSON {"total":
 * objects in all, "at": index of the first selected one or -1, "rows":[{"id","level" (1: in no group),"points",
 * "selected","words"}]}.
 * outline_points: {"at": the chosen point or -1, "points":[words]}, at most 1,000: a spline's points, else the control
 * points of all its curves. */
BAT_API const char *bat_editor_outline(bat_editor *editor, int first, int count);
BAT_API const char *bat_editor_outline_points(bat_editor *editor, bat_id id);
/* Selects the object and chooses a point of it, numbered as outline_points has them, with the tool that moves it.
 * BAT_ARGUMENT: no such point. BAT_STATE: a drag is under way, or it is hidden or locked. */
BAT_API bat_status bat_editor_choose(bat_editor *editor, bat_id id, int point);
/* What has happened since the last call, to be spoken: tool, step, selection, the place of what the keys move; ""
 * when nothing has, or a drag is under way. What notices tell is left out. Owned by the editor, valid until the
 * next call of it. */
BAT_API const char *bat_editor_said(bat_editor *editor);
/* Selects an object (0: none), alone or besides what is selected. */
BAT_API bat_status bat_editor_select(bat_editor *editor, bat_id id, bool add);

/* ---- pictures and the clipboard ---- */

/* Places the bytes of a PNG, JPEG or WebP file behind the drawing, in the middle of the view and within it, half
 * transparent and selected: a step of the history. name: may be NULL. When it is refused, a notice says why. */
BAT_API bat_status bat_editor_add_picture(bat_editor *editor, const void *bytes, size_t size,
                                          const char *name);
/* The picture that an item of role IMAGE shows; NULL: there is none of that number. */
BAT_API const bat_picture *bat_editor_picture(const bat_editor *editor, uint32_t picture);

/* The selection as an SVG file with every knot (bat_free), for the clipboard; cut: it is deleted, a step of the
 * history. BAT_STATE: nothing is selected. A notice tells what was done, or why not. */
BAT_API bat_status bat_editor_copy(bat_editor *editor, bool cut, char **text, size_t *size);
/* Puts all that a document holds into the active layer, selected: a step of the history. own: copied by
 * bat_editor_copy (the reader's report says `native`): 10 px off the place it had, 20 when pasted again, or in the
 * middle of the view when it would not be seen; else at the pointer, or in the middle. In place with Shift, or when
 * asked by "paste-in-place". Layers are dropped, what is in them is not. BAT_STATE: there is nothing in it. */
BAT_API bat_status bat_editor_paste(bat_editor *editor, const bat_document *document, bool own);

/* ---- the last stroke, read as something else ---- */

/* What the last stroke could mean, while it is the last thing done and no other has begun, as JSON: {"at":[x,y], its end
 * in view pixels, "chosen": which it was taken for, "words":["New line","Redraw roof", ...]}; no words: it is settled.
 * Owned by the editor, valid until the next call of it; NULL: out of memory. */
BAT_API const char *bat_editor_readings(bat_editor *editor);
/* Takes it as that one: its step of the history becomes another. BAT_STATE: there is none such any more. */
BAT_API bat_status bat_editor_read_as(bat_editor *editor, int reading);

/* ---- levels of the chosen curve, for the level strip ---- */

/* As JSON: {"rows":[{"points","gain","muted","solo","active"}], one a level, the base first; "points": of the
 * curve; "apart": the rows are what taking apart would give; "copying": a tap chooses who gets the detail}. The
 * three words, muted, solo and active are 0 or 1. Owned by the editor, valid until the next call of it; NULL: out
 * of memory. */
BAT_API const char *bat_editor_levels(bat_editor *editor);

typedef enum bat_level_act {
    BAT_LEVEL_CHOOSE, /* makes it the active one */
    BAT_LEVEL_GAIN,   /* to value; shown at once, one step of the history when `done` comes, command "cancel"
                       * takes it back */
    BAT_LEVEL_MUTE,   /* value 0: sounds, else silent */
    BAT_LEVEL_SOLO    /* the levels above are silent and the others not; again: all sound */
} bat_level_act;
/* BAT_STATE: no levels, or something else is under way; BAT_ARGUMENT: no such level. */
BAT_API bat_status bat_editor_level(bat_editor *editor, bat_level_act act, int level, double value,
                                    bool done);

/* ---- output ---- */

/* Path data: floats, relative to the frame's origin. Command, then its coordinates. */
enum { BAT_PATH_MOVE = 0, BAT_PATH_LINE = 1, BAT_PATH_CUBIC = 2, BAT_PATH_CLOSE = 3 };

/* What an item is; all but OBJECT are coloured by the host's theme. */
typedef enum bat_role {
    BAT_ROLE_OBJECT,     /* style in the item */
    BAT_ROLE_HIGHLIGHT,  /* the curve that would be redrawn */
    BAT_ROLE_STRETCH,    /* the part of it that is going to change */
    BAT_ROLE_TRANSITION, /* where it blends */
    BAT_ROLE_INK,        /* what the pen has drawn */
    BAT_ROLE_FIT,        /* the curve as it will be */
    BAT_ROLE_PREDICTED,  /* ahead of the pen */
    BAT_ROLE_KNOT,       /* marks on the fit's knots: small closed shapes to be filled */
    BAT_ROLE_PAGE,       /* the page's border, first in the static list when there is a page */
    BAT_ROLE_PENDING,    /* a fit that waits for the user's yes */
    BAT_ROLE_SELECTION,  /* outlines of what is selected, and the box around it */
    BAT_ROLE_HANDLE,     /* what can be taken hold of: small closed shapes */
    BAT_ROLE_MARQUEE,    /* the box that a drag draws to select */
    BAT_ROLE_GHOST,      /* curves as they might become */
    BAT_ROLE_POINT,      /* points that the user placed: small closed shapes, stroked and filled */
    BAT_ROLE_CHOSEN,     /* the one of them that is chosen */
    BAT_ROLE_PROMPT,     /* the circle that asks for a direction */
    BAT_ROLE_ARROW,      /* the direction */
    BAT_ROLE_WEDGE,      /* a zone filled behind the rest: directions that the formula reaches */
    BAT_ROLE_BEYOND,     /* a fainter zone: those outside, still honoured */
    BAT_ROLE_GUIDE,      /* what the pen has snapped to */
    BAT_ROLE_VALUE,      /* labels */
    BAT_ROLE_POLYGON,    /* a control polygon */
    BAT_ROLE_COMB,       /* the curvature comb; filled: marks on inflections */
    BAT_ROLE_REACH,      /* how far a brush reaches */
    BAT_ROLE_ERASED,     /* what is going to be rubbed out */
    BAT_ROLE_IMAGE,      /* a picture: the path goes round its corners, from its top left on clockwise */
    BAT_ROLE_GRID,       /* the grid, and its stronger lines */
    BAT_ROLE_GRID_STRONG,
    BAT_ROLE_RULER,    /* the rulers: filled, their ticks, their labels */
    BAT_ROLE_GUIDELINE /* the drawing's guides */
} bat_role;

enum {
    BAT_ITEM_STROKED = 1,
    BAT_ITEM_FILLED = 2,
    BAT_ITEM_EVEN_ODD = 4,
    BAT_ITEM_SCREEN_WIDTH = 8,
    BAT_ITEM_DASHED = 16
};

typedef struct bat_item {
    uint32_t id, version; /* the same pair means the same path: cache it. 0, 0: do not cache.
                             * Objects: the low 32 bits of their id; the page: 0xffffffff */
    uint32_t role, flags;
    uint32_t stroke, fill; /* 0xRRGGBBAA, role OBJECT only */
    float width, opacity;  /* width in document units, or in view pixels with SCREEN_WIDTH */
    uint32_t cap, join;    /* bat_cap, bat_join */
    float miter_limit;
    uint32_t path_count; /* floats */
    float bounds[4];     /* x0 y0 x1 y1 with stroke width, relative to the origin */
    const float *path;
    uint32_t picture; /* role IMAGE: the same number, the same picture (bat_editor_picture) */
} bat_item;

/* A short text of live values. `at` is relative to the frame's origin; the text's middle lies `offset` view pixels
 * from there. */
typedef struct bat_label {
    uint32_t role;
    float at[2], offset[2];
    float turn;       /* degrees, clockwise, about its middle */
    const char *text; /* UTF-8 */
} bat_label;

typedef enum bat_cursor {
    BAT_CURSOR_CROSS,
    BAT_CURSOR_PEN,
    BAT_CURSOR_GRAB,
    BAT_CURSOR_GRABBING,
    BAT_CURSOR_WAIT,
    BAT_CURSOR_ARROW,
    BAT_CURSOR_MOVE,
    BAT_CURSOR_RESIZE_EW,
    BAT_CURSOR_RESIZE_NS,
    BAT_CURSOR_RESIZE_NWSE,
    BAT_CURSOR_RESIZE_NESW,
    BAT_CURSOR_ZOOM_IN,
    BAT_CURSOR_ZOOM_OUT
} bat_cursor;

/* Requests to the host, cleared once the frame has been taken. */
enum {
    BAT_ASK_SAVE = 1,
    BAT_ASK_DOWNLOAD_SVG = 2,
    BAT_ASK_DOWNLOAD_NATIVE = 4,
    BAT_ASK_OPEN = 8,
    BAT_ASK_JOURNAL = 16,
    BAT_ASK_CUT = 32, /* the clipboard: bat_editor_copy, bat_editor_paste */
    BAT_ASK_COPY = 64,
    BAT_ASK_PASTE = 128,
    BAT_ASK_SPAN = 256,      /* let the property picture-span be typed */
    BAT_ASK_SHORTCUTS = 512, /* a list of all commands with their shortcuts */
    BAT_ASK_REGION = 1024,   /* the keyboard goes on to the next part of the window, or back */
    BAT_ASK_REGION_BACK = 2048,
    BAT_ASK_KEPT = 4096,  /* the drawings that the host keeps, to choose from */
    BAT_ASK_LOSSES = 8192 /* a list of what writing over the file would lose (bat_editor_losses) */
};

typedef struct bat_frame {
    double view[4];   /* screen = R (document - (view[0], view[1])) * view[2]; R turns by view[3] degrees,
                       * clockwise as it is seen, (-180, 180] */
    double origin[2]; /* added to every path coordinate */
    uint32_t still_version; /* grows with every change of the static list */
    uint32_t still_count;
    const bat_item *still; /* back to front */
    float dirty
        [4]; /* what changed in the static list since the last frame; x0 > x1: nothing; relative to the origin */
    uint32_t live_count;
    const bat_item *live; /* the overlay, whole, every frame */
    uint32_t label_count;
    const bat_label *labels; /* over the overlay */
    uint32_t cursor, requests;
    uint32_t unsaved, can_undo, can_redo;
    uint32_t tool;                      /* index into the tables' tools */
    uint32_t knots_before, knots_after; /* while drawing; 0, 0: not */
    uint32_t busy;                      /* a stroke or a drag is under way */
    uint32_t pending;   /* 1: a fit waits for "accept" or "cancel"; 2: "accept" ends what is being made */
    double error;       /* of the fit shown, document units; 0 when there is none */
    double tolerance;   /* document units */
    const char *hint;   /* one line on what the pen would do; UTF-8 */
    const char *notice; /* something just happened that the user should know; "" when it has passed */
    uint32_t notice_version; /* grows with every notice, so that the same words twice are two notices */
    const char *name;        /* of the document */
    uint32_t revision;       /* grows with every change of the document */
    uint32_t selection;      /* grows with every change of the selection */
    uint32_t selected;       /* objects in it */
    uint32_t layer;          /* the active one; 0: none */
    uint32_t readings;       /* another number whenever the last stroke's readings change; 0: none */
    uint32_t levels;         /* another number whenever the level strip shows something else; 0: no strip */
    uint32_t lost;           /* things of the file that writing over it would lose */
    uint32_t first;          /* bit i: choice i of the property "first-hints" is a hint to be shown */
} bat_frame;

/* Brings the lists up to date. Owned by the editor, valid until the next call that is not const. */
BAT_API const bat_frame *bat_editor_frame(bat_editor *editor);

/* ---- journal ---- */

/* The journal so far: JSON lines (docs/journal.md). A snapshot of the document, then every committed command. */
BAT_API const char *bat_editor_journal(const bat_editor *editor, size_t *size);
/* Makes the journal short, where a long session has made it long: the document as it was 250 steps ago, then these
 * steps as changes. Replayed, it gives the same document with that much to undo. BAT_STATE: a stroke or a drag is
 * under way. On failure the journal stays as it was. Cost: that of writing the document and these steps. */
BAT_API bat_status bat_editor_compact(bat_editor *editor);
/* Runs a journal from its first line (a snapshot, or an empty document). check: compare the digests noted in it
 * and the document's invariants after every entry. */
BAT_API bat_status bat_editor_replay(bat_editor *editor, const char *text, size_t size, bool check,
                                     bat_problem *problem);
/* The editor's own invariants, over the document's: NULL when all hold. */
BAT_API const char *bat_editor_check(const bat_editor *editor);

#ifdef __cplusplus
}
#endif
#endif
