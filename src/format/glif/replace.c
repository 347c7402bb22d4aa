/* The contours of a glyph's file change; nothing else does. */
#include "format/glif/contours.h"
#include "format/svg/tags.h"
#include "text/json.h"

#include <batten/format.h>
#include <string.h>

typedef struct file {
    const char *text;
    bat_svg_tags tags;
} file;

static bool is_called(const file *f, uint32_t element, uint32_t parent, const char *name) {
    const bat_svg_tag *tag = &f->tags.list[element];
    const size_t length = bat_svg_tag_name(f->text + tag->open, tag->body - tag->open);
    return tag->parent == parent && length == strlen(name) &&
           memcmp(f->text + tag->open + 1, name, length) == 0;
}

/* The first element within the root that is an outline; 0: there is none. */
static uint32_t find_outline(const file *f) {
    for (uint32_t i = 2; i < f->tags.count; i++)
        if (is_called(f, i, 1, "outline")) return i;
    return 0;
}

/* Where the white space before `at` begins; not before `least`. */
static size_t before_space(const char *text, size_t at, size_t least) {
    while (at > least && strchr(" \t\r\n", text[at - 1])) at--;
    return at;
}

/* All that stands in the outline but contours; the new ones go where the first of the old ones was, or to its end. */
static void put_inside(const file *f, uint32_t outline, const bat_text *contours, bat_text *out) {
    const bat_svg_tag *tag = &f->tags.list[outline];
    size_t from = tag->body;
    bool put = false;
    for (uint32_t i = outline + 1; i <= tag->last; i++) {
        if (!is_called(f, i, outline, "contour")) continue;
        bat_text_add(out, f->text + from, before_space(f->text, f->tags.list[i].open, from) - from);
        if (!put) bat_text_add(out, contours->data, contours->size);
        put = true, from = f->tags.list[i].end;
    }
    const size_t end = put ? tag->close : before_space(f->text, tag->close, from);
    bat_text_add(out, f->text + from, end - from);
    if (put) return;
    bat_text_add(out, contours->data, contours->size);
    bat_text_string(out, "\n  ");
}

/* The outline with the contours in it, made where there is none. */
static void put_outline(const file *f, size_t size, const bat_text *contours, bat_text *out) {
    const uint32_t outline = find_outline(f);
    const bat_svg_tag *tag = &f->tags.list[outline ? outline : 1];
    size_t at = before_space(f->text, tag->close, 0), rest = at;
    if (outline && tag->close > tag->body) {
        bat_text_add(out, f->text, tag->body);
        put_inside(f, outline, contours, out);
        bat_text_add(out, f->text + tag->close, size - tag->close);
        return;
    }
    if (outline) at = before_space(f->text, tag->open, 0), rest = tag->end; /* <outline/> */
    bat_text_add(out, f->text, at);
    bat_text_string(out, "\n  <outline>");
    bat_text_add(out, contours->data, contours->size);
    bat_text_string(out, "\n  </outline>");
    bat_text_add(out, f->text + rest, size - rest);
}

bat_status bat_glif_replace(const char *glyph, size_t glyph_size, const bat_document *document, bool extremes,
                            char **text, size_t *size, bat_problem *problem) {
    file f = {.text = glyph};
    bat_text contours = {0}, out = {0};
    if (!glyph || !document || !text || !size) return BAT_ARGUMENT;
    bat_status status = bat_svg_tags_scan(glyph, glyph_size, &f.tags);
    if (status == BAT_SYNTAX)
        bat_problem_set(problem, status, "glyph", "expected tags that match, found others");
    if (status != BAT_OK) return status;
    if (f.tags.count < 2 || !is_called(&f, 1, 0, "glyph") || f.tags.list[1].last + 1 != f.tags.count)
        status = bat_problem_set(problem, BAT_SYNTAX, "glyph",
                                 "expected one element called glyph, found others");
    if (status == BAT_OK) status = bat_glif_contours(document, extremes, &contours);
    if (status == BAT_OK) {
        put_outline(&f, glyph_size, &contours, &out);
        status = contours.failed ? BAT_MEMORY : bat_text_finish(&out, text, size);
    }
    bat_svg_tags_free(&f.tags);
    bat_text_free(&contours);
    bat_text_free(&out);
    return status;
}
