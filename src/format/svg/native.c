/* The native document embedded in an SVG file. */
#include "document/kind.h"
#include "document/digest.h"
#include "document/document.h"
#include "document/scale.h"
#include "format/native/native.h"
#include "format/svg/digest.h"
#include "format/svg/reader.h"
#include "format/seen/seen.h"

#include <string.h>

void bat_svg_report_native(const bat_document *native, bat_svg_report *report) {
    report->native = true;
    report->paths = report->curves = 0;
    int *invisible = &report->lost.count[BAT_LOSS_INVISIBLE];
    for (int i = 0; i < bat_document_count(native); i++) {
        const bat_object *object = bat_document_at(native, i);
        const bat_style *style = bat_object_style(object);
        report->paths += bat_object_is_painted(object);
        if (bat_object_is_painted(object)) report->curves += bat_object_curve_count(object);
        /* Objects that paint nothing are not read from the drawing, but the native document has them. */
        if (bat_object_is_painted(object) && !style->stroked && !style->filled && *invisible > 0)
            --*invisible;
    }
}

void bat_svg_use_native(const bat_svg_reader *reader, uint64_t digest, bat_pictures *pictures,
                        bat_document **document, bat_svg_report *report) {
    if (!reader->native_element) return;
    const char *noted = bat_svg_tree_attribute(&reader->tree, reader->native_element, "digest");
    char own[17];
    bat_digest_print(digest, own);
    bat_document *native = NULL;
    report->edited = true;
    report->lost.count[BAT_LOSS_NATIVE] = 1;
    if (!noted || strcmp(noted, own) != 0) return;
    bat_status status = bat_document_read_with(reader->native.data ? reader->native.data : "",
                                               reader->native.size, pictures, &native, NULL, NULL);
    if (status != BAT_OK) return;
    /* The page alone, or its size, may have been changed; what a saved view shows is not the page. */
    double page[4], written[4];
    bat_document_page(*document, page);
    bat_svg_page(native, written);
    const bool seen = bat_seen_view(native) && bat_seen_shown(native); /* the second comes later */
    if (memcmp(page, written, sizeof page) != 0 && !seen) bat_document_set_page(native, page);
    /* Of numbers without a size the SVG says none, too. */
    const bool bare = bat_document_unit(native) == BAT_UNIT_NONE && !bat_unit_is_said(*document);
    if (!seen && !bare && !bat_unit_same(*document, native))
        (void)bat_document_set_scale(native, bat_document_scale(*document), bat_document_unit(*document));
    report->edited = false;
    report->lost.count[BAT_LOSS_NATIVE] = 0;
    bat_svg_report_native(native, report);
    bat_document_free(*document);
    *document = native;
}
