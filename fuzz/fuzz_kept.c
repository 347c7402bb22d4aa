/* Any bytes as the text of an SVG file that is kept: opened, edited and written, it is a file that can be read again, and
 * unedited it is the same. The first byte says how much of the rest are edits. */
#include "bytes.h"
#include "demand.h"
#include "format/svg/write/feed.h"

#include <batten/bezier.h>
#include <batten/format.h>

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static bat_document *open_kept(const char *text, size_t size) {
    const bat_svg_options options = bat_svg_merging();
    bat_svg_reader *reader;
    bat_document *document = NULL;
    if (bat_svg_reader_create(&options, &reader) != BAT_OK) return NULL;
    bat_svg_reader_source(reader, text, size);
    if (bat_svg_feed(text, size, reader) == BAT_OK)
        bat_svg_reader_finish(reader, &document, NULL, NULL);
    else
        bat_svg_reader_free(reader);
    return document;
}

/* Takes over the object; NULL: nothing was made. */
static void replace(bat_document *document, int index, bat_object *made) {
    if (made) bat_document_replace(document, index, made);
    bat_object_release(made);
}

static void edit(bat_document *document, bytes *in) {
    const int count = bat_document_count(document);
    if (count == 0) return;
    const int index = small(in, count - 1);
    const bat_object *object = bat_document_at(document, index);
    bat_style style = *bat_object_style(object);
    bat_object *made = NULL;
    bat_curve *curve = NULL;
    const double rows[6] = {1, 0, (double)small(in, 200), 0, 1, -7.5};
    switch (small(in, 5)) {
    case 0:
        if (bat_document_end(document, index) == index + 1) bat_document_remove(document, index);
        break;
    case 1:
        style.width = 1 + small(in, 9);
        style.fill = (uint32_t)small(in, 255) << 8 | 0xff;
        bat_object_with_style(object, &style, &made);
        replace(document, index, made);
        break;
    case 2: {
        const bool hidden = small(in, 1);
        const bool locked = small(in, 1);
        bat_object_with_state(object, hidden, locked, &made);
        replace(document, index, made);
        break;
    }
    case 3:
        bat_object_with_name(object, "named <\"&", &made);
        replace(document, index, made);
        break;
    case 4:
        if (!bat_object_is_made_of_curves(object)) break;
        if (bat_curve_transform(bat_object_curve(object, 0), rows, &curve) != BAT_OK) break;
        if (bat_object_with_curve(object, 0, curve, &made) == BAT_OK)
            replace(document, index, made);
        else
            bat_curve_free(curve);
        break;
    default:
        if (bat_object_is_group(object) ||
            bat_object_with_id(object, bat_document_new_id(document), &made) != BAT_OK)
            break;
        bat_document_insert(document, index + 1, made);
        bat_object_release(made);
    }
}

static void write_and_read(const bat_document *document, bool native) {
    char *text;
    size_t size;
    if (bat_svg_write(document, native, &text, &size) != BAT_OK) return;
    bat_document *again = open_kept(text, size);
    if (again) demand(!bat_document_check(again), "a document that is not valid");
    if (native && strstr(text, "<batten:document xmlns:batten=\"urn:batten:1\" drawing=\""))
        demand(again && bat_document_digest(again) == bat_document_digest(document),
               "an edited file does not come back bit for bit");
    bat_document_free(again);
    bat_free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size < 1) return 0;
    const size_t most = data[0] < size - 1 ? data[0] : size - 1;
    bytes in = {data + 1, most};
    const size_t length = size - 1 - most;
    char *text = malloc(length + 1);
    if (!text) return 0;
    memcpy(text, data + 1 + most, length);
    text[length] = '\0';
    bat_document *document = open_kept(text, length);
    if (document && bat_svg_is_kept(document)) {
        char *same;
        size_t same_size;
        if (bat_svg_write(document, true, &same, &same_size) == BAT_OK) {
            demand(same_size == length && memcmp(same, text, length) == 0,
                   "a file that nobody edited has changed");
            bat_free(same);
        }
        while (in.left > 0 && bat_document_count(document) > 0) edit(document, &in);
        if (!bat_document_check(document)) {
            write_and_read(document, true);
            write_and_read(document, false);
        }
    }
    bat_document_free(document);
    free(text);
    return 0;
}
