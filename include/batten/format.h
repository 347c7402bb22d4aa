/* Batten: bytes in, bytes out. Readers never trust their input; a failed read leaves nothing behind. */
#ifndef BATTEN_FORMAT_H
#define BATTEN_FORMAT_H

#include <batten/base.h>
#include <batten/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Native document: versioned JSON (docs/format.md, docs/batten.schema.json). Numbers survive bit for bit. */
BAT_API bat_status bat_document_read(const char *text, size_t size, bat_document **out, bat_problem *problem);
BAT_API bat_status bat_document_write(const bat_document *document, char **text, size_t *size); /* bat_free */

/* One CURVE or STROKE (JSON; strokes also as CSV), as described in docs/format.md. */
BAT_API bat_status bat_curve_read(const char *text, size_t size, bat_curve **out, bat_problem *problem);
BAT_API bat_status bat_curve_write(const bat_curve *curve, char **text, size_t *size);
/* One SURFACE. */
BAT_API bat_status bat_surface_read(const char *text, size_t size, bat_surface **out, bat_problem *problem);
BAT_API bat_status bat_surface_write(const bat_surface *surface, char **text, size_t *size);
/* One MESH. BAT_NUMBER, BAT_PARAMETER, BAT_COUNT: problem names the vertex or the face. */
BAT_API bat_status bat_polymesh_read(const char *text, size_t size, bat_polymesh **out, bat_problem *problem);
BAT_API bat_status bat_polymesh_write(const bat_polymesh *mesh, char **text, size_t *size);
/* Shapes in space, as modelling programs exchange them: a mesh (may be NULL), surfaces and curves, with all of which
 * bat_model_clear releases it. */
typedef struct bat_model {
    bat_polymesh *mesh;
    size_t surface_count, curve_count;
    bat_surface **surfaces;
    bat_curve **curves;
    int left_out; /* statements of the file that stand for anything else */
} bat_model;
BAT_API void bat_model_clear(bat_model *model);
/* The diagonal of the box of all vertices and control points. */
BAT_API double bat_model_size(const bat_model *model);
/* One MESH, SURFACE or CURVE of JSON, or a list of them with one mesh at most. An empty list is BAT_COUNT. */
BAT_API bat_status bat_model_read(const char *text, size_t size, bat_model *out, bat_problem *problem);
BAT_API bat_status bat_model_write(const bat_model *model, char **text, size_t *size);
/* Wavefront OBJ: faces, and B-spline curves and surfaces ("cstype bspline"). Vertices that only those use are none of
 * the mesh; without faces, points and free forms the vertices are a cloud. BAT_UNSUPPORTED: a
 * part of a surface. BAT_NUMBER also: weights that are not above 0, or a million times another; with weights that differ a
 * curve or surface is approximated within a millionth of its size. All other numbers survive bit for bit. */
BAT_API bat_status bat_obj_read(const char *text, size_t size, bat_model *out, bat_problem *problem);
BAT_API bat_status bat_obj_write(const bat_model *model, char **text, size_t *size);
/* IGES 5.3: B-spline curves and surfaces (entities 126, 128), placed by their matrices (124); and STEP (ISO 10303-21),
 * of which AP214 is written: B-spline curves and surfaces of any kind. One unit is a millimetre: other units of a file are
 * converted. A mesh is left out of both. Curves that bound faces are not read, so that trimmed faces come whole; each
 * counts as left out, as whatever else has a shape does; parts of a STEP assembly stay where they were drawn. Curves that
 * lie in z = 0 become planar; but for that, all of a written model comes back bit for bit. Weights as in
 * bat_obj_read. Reading: BAT_UNSUPPORTED: several units of length in a STEP file, a binary or compressed IGES file. Writing: BAT_COUNT:
 * neither curve nor surface; BAT_UNSUPPORTED: more than the 9,999,999 lines that IGES can number. */
BAT_API bat_status bat_iges_read(const char *text, size_t size, bat_model *out, bat_problem *problem);
BAT_API bat_status bat_iges_write(const bat_model *model, char **bytes, size_t *size);
BAT_API bat_status bat_step_read(const char *text, size_t size, bat_model *out, bat_problem *problem);
BAT_API bat_status bat_step_write(const bat_model *model, char **bytes, size_t *size);
/* The curves of a drawing as DXF of release 2007, in millimetres from the page's lower left corner (without a page the document's
 * origin), y upwards: lines, polylines and splines, bit for bit
 * but for the knots that clamp ends and open what is closed, on the layers that they are on, with the colours and widths of their strokes. arcs: a tolerance in millimetres, above 0
 * planar curves are written as polylines of arcs and lines (bat_curve_arcs), for cutters; 0: as splines. BAT_COUNT: there
 * is no curve. Whatever has no curves is left out, as are fills. */
BAT_API bat_status bat_dxf_write(const bat_document *document, double arcs, char **text, size_t *size);
/* A glyph of a font (GLIF 2 of UFO 3): visible curves of the plane as contours of lines and cubics, in the drawing's order and
 * each from its own start, so that glyphs stay compatible; with extremes, cubics are cut where they are furthest left, right,
 * up and down. y = 0 is the baseline, the page's width the advance. Such files are read like SVG: bat_svg_reader takes their
 * elements. BAT_DIMENSION: a curve lies in space; BAT_NUMBER: a point lies further out than 1e9, or the page is wider. O(points). */
BAT_API bat_status bat_glif_write(const bat_document *document, bool extremes, char **text, size_t *size);
/* The same, in a file that is a glyph already (glyph, of glyph_size bytes of UTF-8): only its contours give way to those of the
 * drawing; its name, advance, code points, components, anchors and all else stay, to the byte. BAT_SYNTAX: the file is not a
 * glyph; problem (may be NULL) says what it is. */
BAT_API bat_status bat_glif_replace(const char *glyph, size_t glyph_size, const bat_document *document,
                                    bool extremes, char **text, size_t *size, bat_problem *problem);
/* G-code for mills, plotters and laser cutters (ISO 6983): millimetres, the page's lower left corner at (0, 0), or
 * without a page the document's origin, y upwards. Visible curves of the plane become lines and arcs (G1, G2, G3) within the tolerance and four
 * decimals, in the drawing's order. */
typedef struct bat_gcode_options {
    size_t size;      /* of this struct, as base.h says */
    double tolerance; /* millimetres, above 0 */
    double feed;      /* millimetres a minute, above 0 */
    const char *up,
        *down; /* lines that raise and lower the tool, or switch a laser off and on: ASCII, 1,000 bytes at most; borrowed */
} bat_gcode_options;
/* The defaults: tolerance 0.01, feed 1000, "G0 Z5", "G1 Z-1 F300". */
BAT_API void bat_gcode_options_init(bat_gcode_options *options, size_t size);
static inline bat_gcode_options bat_gcode_defaults(void) {
    bat_gcode_options options;
    bat_gcode_options_init(&options, sizeof options);
    return options;
}
/* options may be NULL: the defaults. BAT_COUNT: there is no visible curve; BAT_DIMENSION: one lies in space; BAT_NUMBER: one is
 * further out than 1e7. */
BAT_API bat_status bat_gcode_write(const bat_document *document, const bat_gcode_options *options,
                                   char **text, size_t *size);
/*
 * Triangles within the tolerance of the surfaces (document units; 0: 1e-4 of the model's size), as binary STL, and as
 * binary glTF 2.0 with unit normals, curves as line strips and clouds as points. Both hold floats of 32 bits, without
 * units. Curves and vertices without faces are left out of STL. BAT_TOLERANCE (without a result): it would take over
 * 16 million triangles; BAT_NUMBER: beyond the range of such floats; BAT_COUNT: nothing that the format can hold.
 */
BAT_API bat_status bat_stl_write(const bat_model *model, double tolerance, char **bytes, size_t *size);
BAT_API bat_status bat_gltf_write(const bat_model *model, double tolerance, char **bytes, size_t *size);
/* A camera move as binary glTF 2.0: a camera whose node is animated by cubic spans (bat_camera_keys; place 0: 1e-4 of the
 * path's size, angle 0: 0.1 degrees, in radians), and the path as a line strip. The animation's extras say what players agree to: "within", with
 * "position" and "degrees". A field of view that changes is in the
 * extension KHR_animation_pointer, which players may pass over. BAT_NUMBER: a field of view is not between 0 and 180
 * degrees, or as above. */
BAT_API bat_status bat_gltf_write_move(const bat_camera *camera, double place, double angle, char **bytes,
                                       size_t *size);
/* The same, among the parts of a model, which bat_gltf_write would write with its default tolerance; NULL: alone. */
BAT_API bat_status bat_gltf_write_scene(const bat_camera *camera, const bat_model *scene, double place,
                                        double angle, char **bytes, size_t *size);
/* BVH: a skeleton and its frames, any order of channels; the place of what is wrong is its line. BAT_COUNT: too many joints,
 * frames or numbers. Writing: BAT_UNSUPPORTED: a joint does not follow its parent in the order of the skeleton. */
BAT_API bat_status bat_bvh_read(const char *text, size_t size, bat_take **out, bat_problem *problem);
BAT_API bat_status bat_bvh_write(const bat_take *take, char **bytes, size_t *size);
/* A motion as JSON, with the report of its fit (docs/format.md). */
BAT_API bat_status bat_motion_write(const bat_motion *motion, const bat_motion_report *report, char **text,
                                    size_t *size);
/* One VIEW; and what a stroke is cast on (an ON of docs/format.md), released by bat_canvas_clear. */
BAT_API bat_status bat_viewpoint_read(const char *text, size_t size, bat_viewpoint *out,
                                      bat_problem *problem);
BAT_API bat_status bat_viewpoint_write(const bat_viewpoint *view, char **text, size_t *size);
BAT_API bat_status bat_canvas_read(const char *text, size_t size, bat_canvas *out, bat_problem *problem);
/* One MOVE; of a path with levels, the finest curve is taken. */
BAT_API bat_status bat_camera_read(const char *text, size_t size, bat_camera **out, bat_problem *problem);
BAT_API bat_status bat_camera_write(const bat_camera *camera, char **text, size_t *size);
/*
 * Points in order, of 2 or 3 numbers: a STROKE, a GeoJSON LineString (or a Feature that holds one), or columns of numbers
 * with any header or none; the columns are those called x, y and z, in any case, else the first two or, where there are
 * just three, three. Fields are separated by semicolons, else commas, else tabs, else blanks, as the first line shows;
 * blank lines and lines that begin with # are skipped. *points: *count * *dimension doubles, the caller's (bat_free).
 */
BAT_API bat_status bat_points_read(const char *text, size_t size, int *dimension, size_t *count,
                                   double **points, bat_problem *problem);
/* *stroke's arrays lie in one block that starts at *block: bat_free(*block). */
BAT_API bat_status bat_stroke_read(const char *text, size_t size, bat_stroke *stroke, void **block,
                                   bat_problem *problem);

/* One SPLINE of the tangents hand; its arrays lie in one block: bat_free(*block). */
BAT_API bat_status bat_spline_read(const char *text, size_t size, bat_spline *spline, void **block,
                                   bat_problem *problem);
/* One SHAPE of the levels hand, and EDITS of it, of which either all are made or none. A sketch too short for its
 * level is followed as closely as possible; problem then says, with BAT_OK, by how much it is missed. */
BAT_API bat_status bat_shape_read(const char *text, size_t size, bat_shape **out, bat_problem *problem);
BAT_API bat_status bat_shape_write(const bat_shape *shape, char **text, size_t *size);
BAT_API bat_status bat_shape_edit(bat_shape *shape, const char *text, size_t size, bat_problem *problem);
/* One RELIEF, a surface with levels: {"base":SURFACE, "levels":[...]}. */
BAT_API bat_status bat_relief_read(const char *text, size_t size, bat_relief **out, bat_problem *problem);
BAT_API bat_status bat_relief_write(const bat_relief *relief, char **text, size_t *size);

/* SVG in: fed by any XML parser (expat natively, the browser's own in the page), in document order. */
typedef struct bat_svg_options {
    size_t size;      /* of this struct, as base.h says */
    double tolerance; /* knots of imported paths are removed within it, document units; 0: exact only */
    double corner;    /* radians: joints that turn more are corners */
    double share; /* of a path's larger side, which bounds the tolerance for small ones; 0: nothing does */
} bat_svg_options;

/* What a file can hold that a document cannot, so that overwriting the file would lose it. For each kind the
 * elements that have it are counted, once each, however often `use` draws them, and including hidden ones. Not
 * counted are comments, white space, the order and spelling of attributes, transforms and inherited styles (their
 * effect is in the drawing), and shapes as such (they become paths). */
typedef enum bat_loss {
    BAT_LOSS_TEXT,
    BAT_LOSS_IMAGE,    /* links to files, and other kinds of pictures than PNG, JPEG and WebP */
    BAT_LOSS_GRADIENT, /* painted as the mean of its stops */
    BAT_LOSS_PATTERN,  /* and whatever else paints: by its fallback colour, else grey */
    BAT_LOSS_CLIP,
    BAT_LOSS_MASK,
    BAT_LOSS_FILTER,
    BAT_LOSS_MARKER, /* of which a part is not shown */
    BAT_LOSS_DASH,
    BAT_LOSS_ORDER,     /* no longer: it is kept */
    BAT_LOSS_EFFECT,    /* a stroke that does not scale: its width is kept as it is */
    BAT_LOSS_UNEVEN,    /* a stroke that a transform makes thicker one way than another */
    BAT_LOSS_BLEND,     /* blend modes, isolation */
    BAT_LOSS_OPACITY,   /* of a container as a whole: each thing in it gets it */
    BAT_LOSS_HINT,      /* on rendering */
    BAT_LOSS_COPY,      /* `use`: drawn, but a copy that is tied to nothing */
    BAT_LOSS_NESTED,    /* an svg in the svg: drawn, not clipped */
    BAT_LOSS_SWITCH,    /* one of its versions is drawn */
    BAT_LOSS_INVISIBLE, /* visibility hidden, no paint, or hidden things that no document can hide */
    BAT_LOSS_BROKEN, /* shapes, path data, transforms, references, values that are not understood: read up to there */
    BAT_LOSS_UNKNOWN, /* elements, attributes, properties and words that are not known, and have no effect */
    BAT_LOSS_TITLE,   /* titles, descriptions, and what is said to screen readers */
    BAT_LOSS_LINK,
    BAT_LOSS_ANIMATION,
    BAT_LOSS_SCRIPT,   /* event attributes, too */
    BAT_LOSS_EMBEDDED, /* pages and media */
    BAT_LOSS_UNUSED,   /* definitions that nothing refers to */
    BAT_LOSS_METADATA,
    BAT_LOSS_FOREIGN, /* elements of other programs, elements with attributes of theirs */
    /* of the whole file */
    BAT_LOSS_RULE,   /* of style sheets: what they set is drawn in, where they are known */
    BAT_LOSS_PAGE,   /* its size in units, or another size than that of the view box */
    BAT_LOSS_NATIVE, /* a document of Batten that the drawing no longer agrees with; or objects of one */
    BAT_LOSS_COUNT
} bat_loss;

typedef struct bat_losses {
    int count[BAT_LOSS_COUNT];
} bat_losses;

BAT_API int bat_losses_total(const bat_losses *losses);
/* A short word for files and keys of words, "gradients"; static storage, NULL for no kind. */
BAT_API const char *bat_loss_key(bat_loss kind);
/* In English, "3 gradients"; "" when there is no room for all of it. */
BAT_API void bat_loss_words(bat_loss kind, int count, char *words, size_t room);

typedef struct bat_svg_report {
    int paths, curves; /* what was read */
    int hidden;        /* paths that are not displayed: kept in the document, hidden; not among `paths` */
    bat_losses lost;   /* what was not */
    bool native;       /* the file carried a native document: every knot is as it was */
    bool edited;       /* it did, but was changed since: the drawing was read; with `native`, in part */
} bat_svg_report;
typedef struct bat_svg_reader bat_svg_reader;

/* The defaults: tolerance 0 (exact), corners from 0.05 radians on. */
BAT_API void bat_svg_options_init(bat_svg_options *options, size_t size);
static inline bat_svg_options bat_svg_defaults(void) {
    bat_svg_options options;
    bat_svg_options_init(&options, sizeof options);
    return options;
}
/* For drawings that are going to be edited: nodes are merged where the curve stays the same within 0.001, for
 * small paths within a ten-thousandth of their size. */
BAT_API void bat_svg_options_init_merging(bat_svg_options *options, size_t size);
static inline bat_svg_options bat_svg_merging(void) {
    bat_svg_options options;
    bat_svg_options_init_merging(&options, sizeof options);
    return options;
}
/* options may be NULL: the defaults. */
BAT_API bat_status bat_svg_reader_create(const bat_svg_options *options, bat_svg_reader **out);
/* attributes: name, value, name, value, ..., NULL. Namespaced names as written ("xlink:href"). */
BAT_API bat_status bat_svg_reader_start(bat_svg_reader *reader, const char *name,
                                        const char *const *attributes);
BAT_API bat_status bat_svg_reader_text(bat_svg_reader *reader, const char *text, size_t size);
BAT_API bat_status bat_svg_reader_end(bat_svg_reader *reader);
/* The whole text of the file (copied), in UTF-8; called at any time before the end. The document then keeps it, and
 * bat_svg_write writes it again with nothing changed but what has been edited. A text in another encoding is not kept,
 * nor one of over 256 MB.
 * Where the options ask for a tolerance whatever a path's size (share 0), all paths count as edited. */
BAT_API bat_status bat_svg_reader_source(bat_svg_reader *reader, const char *text, size_t size);
BAT_API bat_status bat_svg_reader_finish(bat_svg_reader *reader, bat_document **out, bat_svg_report *report,
                                         bat_problem *problem); /* frees the reader whatever it returns */
BAT_API void bat_svg_reader_free(bat_svg_reader *reader);       /* for giving up early */
/* Writes "Left out: 3 texts, 1 image.", or "" when nothing was left out; if another program has changed the file,
 * the line goes on to say so. 1,000 bytes are enough room. */
BAT_API void bat_svg_report_line(const bat_svg_report *report, char *line, size_t room);

/* SVG out: cubic Béziers, exact up to degree 3, and the native document in the metadata. Their numbers are rounded where
 * nobody can see it: no point moves by more than .001 document units, 1e-5 of its curve's size or a thousandth of the
 * curve's shortest leg; the native document has every bit. A document that was read from an SVG file whose
 * text it keeps is written as that file: what was not edited stays as it was, character by character, and with no edit at
 * all so does the whole file; the metadata then have only those objects that do not come back from the drawing bit for bit. */
BAT_API bat_status bat_svg_write(const bat_document *document, bool with_native, char **text, size_t *size);
/* The same with numbers rounded so that no point moves by more than `precision`, document units; 0: not rounded;
 * BAT_SVG_UNSEEN: as bat_svg_write does. Elements that are kept as they were in their file are not rounded. BAT_ARGUMENT also
 * for NaN. */
#define BAT_SVG_UNSEEN (-1.0)
BAT_API bat_status bat_svg_write_within(const bat_document *document, bool with_native, double precision,
                                        char **text, size_t *size);
/* The same only where nothing but what was edited has to change in the file that it was read from. BAT_STATE: it keeps none;
 * BAT_UNSUPPORTED: an edit cannot be said in it, so that all of it has to be written anew, as the two above do: what the drawing
 * does not hold of it (its sheets, scripts, comments, metadata) would be gone. */
BAT_API bat_status bat_svg_write_kept(const bat_document *document, bool with_native, double precision,
                                      char **text, size_t *size);
/* Whether it keeps the text of its file, so that writing loses nothing of what its reader counted as lost. */
BAT_API bool bat_svg_is_kept(const bat_document *document);

#ifdef __cplusplus
}
#endif
#endif
