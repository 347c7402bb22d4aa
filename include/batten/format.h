/* Batten: bytes in, bytes out. Readers never trust their input; a failed read leaves nothing behind. */
#ifndef BATTEN_FORMAT_H
#define BATTEN_FORMAT_H

#include <batten/document.h>
#include <batten/levels.h>
#include <batten/sketch.h>
#include <batten/tangents.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What was wrong: "line 3, column 14" or "curves[2].knots[7]", what was expected, what was found. */
typedef struct bat_problem {
    char place[96];
    char message[160];
} bat_problem;

/* Native document: versioned JSON (docs/format.md, docs/batten.schema.json). Numbers survive bit for bit. */
BAT_API bat_status bat_document_read(const char *text, size_t size, bat_document **out, bat_problem *problem);
BAT_API bat_status bat_document_write(const bat_document *document, char **text, size_t *size); /* bat_free */

/* One CURVE or STROKE (JSON, strokes also CSV) as docs/format.md says. */
BAT_API bat_status bat_curve_read(const char *text, size_t size, bat_curve **out, bat_problem *problem);
BAT_API bat_status bat_curve_write(const bat_curve *curve, char **text, size_t *size);
/* *stroke's arrays lie in one block that starts at *block: bat_free(*block). */
BAT_API bat_status bat_stroke_read(const char *text, size_t size, bat_stroke *stroke, void **block,
                                   bat_problem *problem);

/* One SPLINE of the tangents hand; its arrays lie in one block: bat_free(*block). */
BAT_API bat_status bat_spline_read(const char *text, size_t size, bat_spline *spline, void **block,
                                   bat_problem *problem);
/* One SHAPE of the levels hand, and EDITS of it, all made or none. */
BAT_API bat_status bat_shape_read(const char *text, size_t size, bat_shape **out, bat_problem *problem);
BAT_API bat_status bat_shape_write(const bat_shape *shape, char **text, size_t *size);
BAT_API bat_status bat_shape_edit(bat_shape *shape, const char *text, size_t size, bat_problem *problem);

/* SVG in: fed by any XML parser (expat natively, the browser's own in the page), in document order. */
typedef struct bat_svg_options {
    double tolerance; /* knots of imported paths are removed within it, document units; 0: exact only */
    double corner;    /* radians: joints that turn more are corners */
} bat_svg_options;
typedef struct bat_svg_report {
    int paths, curves; /* what was read; the rest tells about the visible drawing */
    int skipped_text, skipped_images, skipped_gradients, skipped_clips, skipped_other; /* what was left out */
    int hidden;         /* paths that are not displayed: kept in the document, hidden; not among `paths` */
    int skipped_hidden; /* not displayed otherwise, visibility hidden, neither stroke nor fill */
    int broken_paths;   /* path data, shapes or transforms with errors: read up to the error */
    int foreign; /* elements of other programs (editor settings, licences, ...): not kept when saving */
    bool native; /* the file carried a native document: every knot is as it was */
    bool edited; /* it did, but the drawing has been changed since: the drawing was read */
} bat_svg_report;
typedef struct bat_svg_reader bat_svg_reader;

BAT_API bat_svg_options bat_svg_defaults(void);
BAT_API bat_status bat_svg_reader_create(const bat_svg_options *options, bat_svg_reader **out);
/* attributes: name, value, name, value, ..., NULL. Namespaced names as written ("xlink:href"). */
BAT_API bat_status bat_svg_reader_start(bat_svg_reader *reader, const char *name,
                                        const char *const *attributes);
BAT_API bat_status bat_svg_reader_text(bat_svg_reader *reader, const char *text, size_t size);
BAT_API bat_status bat_svg_reader_end(bat_svg_reader *reader);
BAT_API bat_status bat_svg_reader_finish(bat_svg_reader *reader, bat_document **out, bat_svg_report *report,
                                         bat_problem *problem); /* frees the reader whatever it returns */
BAT_API void bat_svg_reader_free(bat_svg_reader *reader);       /* for giving up early */
/* "Left out: 3 texts, 1 image." or "" when nothing was; then, if so, that another program changed the file. */
BAT_API void bat_svg_report_line(const bat_svg_report *report, char *line, size_t room);

/* SVG out: exact cubic Béziers, and the native document in the metadata. */
BAT_API bat_status bat_svg_write(const bat_document *document, bool with_native, char **text, size_t *size);

#ifdef __cplusplus
}
#endif
#endif
