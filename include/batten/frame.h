/* Batten: what comes out of the engine: one frame, which holds display lists, what is to be said, and what is
 * asked of the host. */
#ifndef BATTEN_FRAME_H
#define BATTEN_FRAME_H

#include <batten/document.h>
#include <batten/input.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Path data: floats, relative to the frame's origin. Each command is followed by its coordinates. */
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
    BAT_ROLE_RULER,     /* the rulers: filled, their ticks, their labels */
    BAT_ROLE_GUIDELINE, /* the drawing's guides */
    BAT_ROLE_PAGE_BACK, /* instead of PAGE: seen from behind */
    BAT_ROLE_PIVOT,     /* what the view turns about */
    BAT_ROLE_GROUP, /* in the static list: the items that follow are painted as one picture, which then has the opacity */
    BAT_ROLE_CLIP, /* in the static list: of the items that follow, what lies within the path is painted; or a mask: `fill` is
                   * the number of a picture, the path goes round its corners, and they are painted as far as it covers */
    BAT_ROLE_AXIS_X, /* what moves along an axis of the drawing, or turns about it: lines, and filled handles */
    BAT_ROLE_AXIS_Y,
    BAT_ROLE_AXIS_Z
} bat_role;

enum {
    BAT_ITEM_STROKED = 1,
    BAT_ITEM_FILLED = 2,
    BAT_ITEM_EVEN_ODD = 4,
    BAT_ITEM_SCREEN_WIDTH = 8,
    BAT_ITEM_DASHED = 16,
    BAT_ITEM_STROKE_FIRST = 32 /* before the fill; only with a paint */
};

typedef struct bat_item {
    uint32_t id, version; /* the same pair means the same path: cache it. 0, 0: do not cache.
                             * Objects: the low 32 bits of their id; the page: 0xffffffff */
    uint32_t role, flags;
    uint32_t stroke, fill; /* 0xRRGGBBAA: OBJECT, what is drawn; `fill` of a CLIP: its mask, 0: none */
    float width, opacity;  /* width in document units, or in view pixels with SCREEN_WIDTH */
    uint32_t cap, join;    /* bat_cap, bat_join */
    float miter_limit;
    uint32_t path_count; /* floats */
    float bounds[4];     /* x0 y0 x1 y1 with stroke width, relative to the origin */
    const float *path;
    uint32_t
        picture; /* role IMAGE: the same number, the same picture (bat_editor_picture); GROUP, CLIP: how many items */
    uint32_t paint_count; /* floats */
    const float *paint;   /* role OBJECT: what paints it besides its colours; NULL: nothing */
} bat_item;

/* The floats of an item's paint. First the pen {a, b, c, d} (of a round one 1, 0, 0, 1), the offset of the dashes, how many
 * there are, and they themselves, in document units; then any number of gradients: 0 for the fill, 1 for the stroke; 1 if
 * it is radial, 2: it is a pattern; bat_spread; two circles x, y, radius; the matrix {a, b, c, d, e, f} from its units to those of
 * paths; how many stops, and for each its place, the upper 24 bits of its colour and the lower 8. The first circle of a pattern
 * is the upper and the lower 16 bits of the number of its picture (bat_editor_picture), and 0. */

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
    BAT_ASK_KEPT = 4096,   /* the drawings that the host keeps, to choose from */
    BAT_ASK_LOSSES = 8192, /* a list of what writing over the file would lose (bat_editor_losses) */
    BAT_ASK_EXPORT =
        16384, /* a choice of format, part and size for a file, or for the clipboard: bat_editor_excerpt */
    BAT_ASK_HISTORY = 32768,  /* a list of what was done (bat_editor_history), to go back to a step of it */
    BAT_ASK_WIDTH = 65536,    /* let the number width-here be typed */
    BAT_ASK_SIZE = 131072,    /* let the number width be typed, of what is selected */
    BAT_ASK_SAVE_AS = 262144, /* the file that the drawing is from now on, chosen and written */
    BAT_ASK_EXPORT_AGAIN = 524288,  /* the export that was chosen last, once more */
    BAT_ASK_COPY_PICTURE = 1048576, /* the selection, or else the page, as a picture on the clipboard */
    BAT_ASK_TEXT = 2097152          /* let a text be typed in place: bat_editor_writing */
};

typedef struct bat_frame {
    double view[4];    /* screen = R (drawing - (view[0], view[1])) * view[2]; R turns by view[3] degrees,
                       * clockwise as it is seen, (-180, 180]; paths and labels are in these drawing coordinates,
                       * which are the page's as long as tilt is 0 */
    uint32_t jumps;    /* of the view so far: home, a named view, a step back (bat_editor_glide) */
    uint32_t surfaces; /* some are shown; tilted, they are painted with a depth (bat_editor_space) */
    double tilt;       /* how far the page lies back, degrees: 0 face-on, 90 edge-on, 180 its back */
    double origin[2];  /* added to every path coordinate */
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
    const char *offer;       /* the command that the notice offers; "": none */
    const char *name;        /* of the document */
    uint32_t revision;       /* grows with every change of the document */
    uint32_t selection;      /* grows with every change of the selection */
    uint32_t selected;       /* objects in it */
    uint32_t layer;          /* the active one; 0: none */
    uint32_t readings;       /* another number whenever the last stroke's readings change; 0: none */
    uint32_t levels;         /* another number whenever the level strip shows something else; 0: no strip */
    uint32_t moves;          /* another number whenever the time strip shows something else; 0: no strip */
    uint32_t
        lost; /* things of the file that writing over it would lose; where the document keeps it, objects that look otherwise than in it */
    uint32_t first; /* bit i: choice i of the property "first-hints" is a hint to be shown */
} bat_frame;

/* ---- a tilted view, painted with a depth ---- */

enum { BAT_SPACE_TRIANGLES = 0, BAT_SPACE_LINES = 1 };

/* Buffers of an object. The same id, kind and version mean the same data, except for what `moved` says. */
/* In the id of the lines that are the outline (the silhouettes) of that surface in this view. */
#define BAT_SPACE_OUTLINE 0x80000000u

typedef struct bat_space_item {
    uint32_t id, version;
    uint32_t kind;
    uint32_t colour; /* 0xRRGGBBAA; of triangles 0: that of the look */
    float width;     /* of lines, view pixels */
    float opacity;
    uint32_t cap;           /* of lines: bat_cap */
    uint32_t rows, columns; /* of vertices, row after row; a line of points has one column */
    uint32_t index_count;
    const int
        *indices; /* of triangles: three vertices each, anticlockwise seen from the side of the normals */
    /* Triangles: point, normal and curvature (of the looks that show it), 7 numbers a vertex. Lines: point and length so
     * far, 4 numbers; length 0 begins another line; the first point and the last are there twice. */
    const float *vertices;
    uint32_t moved[4]; /* rows and columns that changed since the last call: first, end, first, end */
} bat_space_item;

/* Matrices are by columns, four numbers each. */
typedef struct bat_space {
    float clip[16];  /* from vertices to clip coordinates of a canvas with whole device pixels */
    float eye[16];   /* to directions and places as the eye has them: right, up, towards it */
    float before[2]; /* added to z and w of clip coordinates, times w: lines on a surface are before it */
    float scale;     /* view pixels per document unit, where the view turns */
    uint32_t perspective; /* 0: parallel */
    uint32_t look;        /* matte, zebra, Gauss curvature, mean curvature, lines */
    uint32_t count;
    const bat_space_item *items; /* back to front; what has an opacity below 1 goes last */
    double range;                /* curvature: colours run from -range to range */
    uint32_t legend[3];          /* 0xRRGGBBAA: the colours of -range, 0 and range */
    uint32_t waits; /* outlines of surfaces are left out while the view moves: another call shows them */
} bat_space;

/* The drawing as the last frame showed it, or as the camera sees it that it is seen through (bat_editor_move), without its overlay, page, fills and pictures: for a host that has a depth buffer.
 * NULL: the view is face-on and through no camera, or memory ran out; then the frame's static list is to be painted as it is. Owned by the
 * editor, valid until the next call that is not const. */
BAT_API const bat_space *bat_editor_space(bat_editor *editor);
/* What the camera of the move sees at the playhead (bat_editor_move), in a picture of that size in pixels; when the drawing is seen
 * through it, the drawing as the view shows it. Called after bat_editor_space, it has the same buffers and no outlines; the
 * items of the one are valid until the other is called. NULL: there is no camera, or memory ran out. */
BAT_API const bat_space *bat_editor_lens(bat_editor *editor, const double size[2]);
/* The constants of the looks in the language of OpenGL ES 3 shaders: a constant for each number and colour, and the
 * function `float matte(vec3 normal)`. */
BAT_API const char *bat_space_constants(void);

/* Brings the lists up to date. Owned by the editor, valid until the next call that is not const. */
BAT_API const bat_frame *bat_editor_frame(bat_editor *editor);

#ifdef __cplusplus
}
#endif
#endif
