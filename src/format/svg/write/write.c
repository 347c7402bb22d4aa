/* Writing SVG: every curve as cubic Béziers, exact up to degree 3, and the native document as text in the
 * metadata. */
#include "base/matrix.h"
#include "document/digest.h"
#include "document/document.h"
#include "document/lettering.h"
#include "document/nesting.h"
#include "format/svg/write/covered.h"
#include "format/native/native.h"
#include "format/svg/svg.h"
#include "format/svg/digest.h"
#include "format/svg/write/basic.h"
#include "format/svg/markup.h"
#include "format/svg/write/markers.h"
#include "format/svg/write/patch.h"
#include "format/svg/write/see.h"
#include "format/seen/seen.h"
#include "format/svg/tree.h"
#include "text/text.h"
#include "document/kind.h"

#include <batten/format.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Whether a name can be used as an XML id unchanged (ASCII only, to be safe everywhere). */
static bool is_id(const char *name) {
    if (strncmp(name, BAT_SVG_PAINT_ID, sizeof BAT_SVG_PAINT_ID - 1) == 0) return false;
    for (size_t i = 0; name[i]; i++) {
        char c = name[i];
        bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
        if (!letter && (i == 0 || !((c >= '0' && c <= '9') || c == '-' || c == '.'))) return false;
    }
    return name[0] != '\0';
}

typedef struct named {
    const char *name;
    int index;
} named;

static int compare_names(const void *a, const void *b) {
    const named *x = a, *y = b;
    int order = strcmp(x->name, y->name);
    return order ? order : x->index - y->index;
}

/* unique[i]: object i is the first with its name, and the name can be an id. */
static bat_status find_ids(const bat_document *document, bool *unique) {
    int count = bat_document_count(document);
    named *names = malloc(((size_t)count + 1) * sizeof *names);
    if (!names) return BAT_MEMORY;
    for (int i = 0; i < count; i++) names[i] = (named){bat_object_name(bat_document_at(document, i)), i};
    if (count > 1) qsort(names, (size_t)count, sizeof *names, compare_names); /* no ties */
    for (int i = 0; i < count; i++)
        unique[names[i].index] = is_id(names[i].name) &&
                                 (i == 0 || strcmp(names[i].name, names[i - 1].name) != 0);
    free(names);
    return BAT_OK;
}

static bat_status open_group(bat_text *text, const bat_object *object, bool as_id, bool hidden,
                             bat_outline *outline, uint64_t *digest) {
    static const double same[6] = {1, 0, 0, 1, 0, 0};
    bat_svg_ids ids = {0};
    bat_status status = bat_svg_write_clip(text, object, same, 1, &ids);
    const double opacity = bat_object_style(object)->opacity;
    bool layer = bat_object_is(object, BAT_LAYER);
    bat_text_string(text, layer ? "<g inkscape:groupmode=\"layer\"" : "<g");
    bat_svg_write_name(text,
                       layer   ? " inkscape:label=\""
                       : as_id ? " id=\""
                               : " data-name=\"",
                       bat_object_name(object));
    bat_svg_write_state(text, object);
    if (opacity != 1) {
        bat_svg_write_number(text, " opacity=\"", opacity);
        if (!hidden) *digest = bat_svg_digest_group(*digest, opacity);
    }
    bat_svg_refer_clip(text, &ids);
    bat_text_string(text, ">\n");
    if (status == BAT_OK && !hidden) status = bat_svg_see_clip(object, same, same, outline, digest);
    return status;
}

/* Writes the path element, and adds what a reader will see of it to the digest. number: makes ids within the object unique. */
static bat_status write_path(bat_text *text, const bat_object *object, bool as_id, bool hidden, int number,
                             double precision, bat_outline *outline, uint64_t *digest) {
    const bat_style *style = bat_object_style(object);
    double pen[6], back[6];
    bat_svg_basic basic;
    const bool uneven = bat_svg_pen(object, pen, back);
    const bool shaped = !uneven && bat_svg_has_basic(object, precision, text, &basic);
    const bool turned = uneven || (shaped && basic.turned && bat_svg_inverse(basic.turn, back));
    if (shaped) memcpy(pen, basic.turn, sizeof pen);
    bat_svg_ids ids = bat_svg_write_gradients(text, object, back, number);
    uint64_t marked = 0;
    bat_status status = bat_svg_write_clip(text, object, back, number, &ids);
    if (status == BAT_OK)
        status = bat_svg_write_markers(text, object, pen, number, precision, outline, &ids, &marked);
    bat_text_string(text, "<");
    bat_text_string(text, shaped ? basic.name : "path");
    bat_svg_write_name(text, as_id ? " id=\"" : " data-name=\"", bat_object_name(object));
    bat_svg_write_state(text, object);
    if (turned) {
        bat_text_string(text, " transform=\"");
        bat_svg_write_matrix(pen, text);
        bat_text_string(text, "\"");
    }
    bat_svg_write_style(text, object, &ids);
    bat_text_string(text, shaped ? "" : " d=\"");
    const size_t start = text->size;
    if (shaped)
        bat_svg_write_basic(text, &basic);
    else if (status == BAT_OK)
        status = bat_svg_write_curves(text, object, uneven ? back : NULL, precision);
    if (status == BAT_OK && text->failed) status = BAT_MEMORY;
    const bool seen = !hidden && (style->stroked || style->filled || bat_object_markers(object));
    if (status == BAT_OK && seen) status = bat_svg_see_clip(object, pen, back, outline, digest);
    if (status == BAT_OK && seen && shaped) {
        bat_outline_clear(outline);
        bat_svg_basic_outline(&basic, outline);
        status = bat_svg_see_outline(object, pen, back, outline, digest);
    } else if (status == BAT_OK && seen)
        status = bat_svg_see_path(text, start, object, outline, digest);
    if (marked && seen) *digest = bat_digest_number(*digest, marked);
    bat_text_string(text, shaped ? "/>\n" : "\"/>\n");
    return status;
}

/* A stroke whose width changes, as the path that it covers: behind or before the fill; both in a group if they are translucent as a
 * whole. */
static bat_status write_widened(bat_text *text, const bat_object *object, bool as_id, bool hidden,
                                double precision, bat_outline *outline, uint64_t *digest) {
    const double opacity = bat_object_style(object)->opacity;
    bat_object *parts[2];
    bool group;
    bat_status status = bat_object_parts(object, parts, &group);
    if (status != BAT_OK) return status;
    if (group) {
        bat_svg_write_number(text, "<g opacity=\"", opacity);
        bat_text_string(text, ">\n");
        if (!hidden) *digest = bat_svg_digest_group(*digest, opacity);
    }
    for (int k = 0, written = 0; k < 2 && status == BAT_OK; k++) {
        if (!parts[k]) continue;
        status = write_path(text, parts[k], as_id && !written, hidden, 1 + written, precision, outline,
                            digest);
        written++;
    }
    if (group) bat_text_string(text, "</g>\n");
    for (int k = 0; k < 2; k++) bat_object_release(parts[k]);
    return status;
}

/* An image, foreign content, or a text. */
static bat_status write_image(bat_text *text, const bat_object *object, bool as_id, bool hidden,
                              bat_outline *outline, uint64_t *digest) {
    const double *m = bat_object_matrix(object), opacity = bat_object_style(object)->opacity;
    double back[6];
    bat_svg_ids ids = {0};
    bat_status status = BAT_OK;
    if (bat_svg_inverse(m, back)) {
        status = bat_svg_write_clip(text, object, back, 1, &ids);
        if (status == BAT_OK && !hidden) status = bat_svg_see_clip(object, m, back, outline, digest);
    }
    const bat_lettering *lettering = bat_object_lettering(object);
    bat_text_string(text, lettering ? "<text" : "<image");
    bat_svg_write_name(text, as_id ? " id=\"" : " data-name=\"", bat_object_name(object));
    bat_svg_write_state(text, object);
    if (lettering)
        bat_svg_write_lettering(text, object, bat_object_place(object), opacity, &ids);
    else
        bat_svg_write_picture(text, bat_object_picture(object), m, opacity, &ids);
    bat_text_string(text, "\n");
    if (!hidden) *digest = bat_svg_digest_image(*digest, bat_object_picture(object), m, opacity);
    return status;
}

static bat_status write_objects(const bat_document *document, double precision, bat_text *text,
                                uint64_t *digest) {
    int count = bat_document_count(document);
    bool *unique = malloc((size_t)count + 1);
    bat_status status = unique ? find_ids(document, unique) : BAT_MEMORY;
    bat_outline outline = {0};
    *digest = bat_digest_begin();
    bat_nesting nesting = {0};
    for (int i = 0; i < count && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        int before = nesting.depth;
        bool group = bat_object_is_group(object);
        bat_nesting_next(&nesting, object, &level);
        for (int k = nesting.depth - group; k < before; k++) bat_text_string(text, "</g>\n");
        if (group)
            status = open_group(text, object, unique[i], level.hidden, &outline, digest);
        else if (bat_object_picture(object))
            status = write_image(text, object, unique[i], level.hidden, &outline, digest);
        else if (bat_object_widths(object).count)
            status = write_widened(text, object, unique[i], level.hidden, precision, &outline, digest);
        else if (bat_object_is_painted(object))
            status = write_path(text, object, unique[i], level.hidden, 1, precision, &outline, digest);
    }
    for (int k = 0; k < nesting.depth; k++) bat_text_string(text, "</g>\n");
    bat_outline_free(&outline);
    free(unique);
    return status;
}

/* pictures: the drawing does not hold them. */
static void write_native(const bat_document *document, uint64_t digest, bool pictures, bat_text *text) {
    char noted[17];
    bat_text json = {0};
    bat_document_to_json(document, pictures, &json);
    bat_digest_print(digest, noted);
    bat_text_string(text,
                    "<metadata><batten:document xmlns:batten=\"" BAT_SVG_NATIVE_NAMESPACE "\" digest=\"");
    bat_text_string(text, noted);
    bat_text_string(text, "\">");
    if (json.data) bat_text_xml(text, json.data, json.size, false);
    text->failed = text->failed || json.failed;
    bat_text_string(text, "</batten:document></metadata>\n");
    bat_text_free(&json);
}

static bool has_layers(const bat_document *document) {
    for (int i = 0; i < bat_document_count(document); i++)
        if (bat_object_is(bat_document_at(document, i), BAT_LAYER)) return true;
    return false;
}

/* The root's start tag; box: of the view, x, y, width, height. sized: whose physical size it has; NULL: one px a unit. */
static void open_root(bat_text *text, const double box[4], const bat_document *sized, bool layers) {
    bat_text_string(text, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"" BAT_SVG_NAMESPACE "\"");
    if (layers) bat_text_string(text, " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"");
    bat_svg_write_size(text, " width=\"", box[2], sized);
    bat_svg_write_size(text, " height=\"", box[3], sized);
    bat_text_string(text, " viewBox=\"");
    bat_svg_write_pair(text, box);
    bat_text_string(text, " ");
    bat_svg_write_pair(text, box + 2);
    bat_text_string(text, "\">\n");
}

/* The picture of the saved view. */
static bat_status write_seen(const bat_document *document, const bat_viewpoint *view, bat_text *text,
                             uint64_t *digest) {
    bat_seen_content content;
    *digest = bat_digest_begin();
    bat_status status = bat_seen_draw(document, view, &content);
    if (status == BAT_OK) status = bat_svg_write_seen(text, &content, true, digest);
    bat_seen_clear(&content);
    return status;
}

/* The whole file, made anew. view: what it shows; NULL: the page. */
static bat_status write_anew(const bat_document *document, const bat_viewpoint *view, bool with_native,
                             double precision, bat_text *text) {
    bat_text objects = {0};
    uint64_t digest;
    double box[4] = {0, 0};
    const bat_status status = view ? write_seen(document, view, &objects, &digest)
                                   : write_objects(document, precision, &objects, &digest);
    if (status == BAT_OK) {
        if (view)
            box[2] = view->size[0], box[3] = view->size[1];
        else
            bat_svg_page(document, box);
        open_root(text, box, view ? NULL : document, !view && has_layers(document));
        if (with_native) write_native(document, digest, view != NULL, text);
        if (objects.data) bat_text_add(text, objects.data, objects.size);
        text->failed = text->failed || objects.failed;
        bat_text_string(text, "</svg>\n");
    }
    bat_text_free(&objects);
    return status;
}

bat_status bat_svg_write(const bat_document *document, bool with_native, char **out, size_t *size) {
    return bat_svg_write_within(document, with_native, BAT_SVG_UNSEEN, out, size);
}

bat_status bat_svg_write_kept(const bat_document *document, bool with_native, double precision, char **out,
                              size_t *size) {
    if (!document || !out || !size || isnan(precision)) return BAT_ARGUMENT;
    if (!bat_svg_is_kept(document)) return BAT_STATE;
    bat_text text = {0};
    const bat_status status = bat_svg_patch_write(document, with_native, precision, &text);
    if (status == BAT_OK) return bat_text_finish(&text, out, size);
    bat_text_free(&text);
    return status == BAT_MEMORY ? status : BAT_UNSUPPORTED;
}

bat_status bat_svg_write_within(const bat_document *document, bool with_native, double precision, char **out,
                                size_t *size) {
    bat_status status = bat_svg_write_kept(document, with_native, precision, out, size);
    if (status != BAT_STATE && status != BAT_UNSUPPORTED) return status;
    bat_text text = {0};
    const bat_viewpoint *view = bat_seen_shown(document);
    status = write_anew(document, view, with_native, precision, &text);
    if (view && status != BAT_OK && status != BAT_MEMORY) /* more than can be drawn: the page */
        status = write_anew(document, NULL, with_native, precision, &text);
    if (status == BAT_OK) return bat_text_finish(&text, out, size);
    bat_text_free(&text);
    return status;
}

bool bat_svg_is_kept(const bat_document *document) { return document && bat_document_origin(document); }
