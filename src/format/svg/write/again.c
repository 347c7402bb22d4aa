/* What is written is read again before it is handed over. */
#include "format/svg/walk.h"
#include "format/svg/write/feed.h"
#include "format/svg/write/patch.h"

#include <stdlib.h>

bat_status bat_svg_again_read(const bat_text *text, const bat_svg_options *options, bat_svg_again *out) {
    bat_svg_reader *reader;
    bat_status status = bat_svg_reader_create(options, &reader);
    if (status != BAT_OK) return status;
    reader->again = out;
    if (text->size > 0) text->data[text->size] = '\0'; /* there is room for it (text.h) */
    bat_svg_reader_lend(reader, text->data, text->size);
    status = bat_svg_feed(text->data, text->size, reader);
    if (status == BAT_OK)
        status = bat_svg_reader_finish(reader, &out->document, NULL, NULL);
    else
        bat_svg_reader_free(reader);
    return status == BAT_OK || status == BAT_MEMORY ? status : BAT_UNSUPPORTED;
}

void bat_svg_again_free(bat_svg_again *again) {
    bat_document_free(again->document);
    free(again->places);
    free(again->shown);
    *again = (bat_svg_again){0};
}

uint32_t bat_svg_element_at(const bat_svg_tags *tags, size_t at) {
    uint32_t low = 1, high = tags->count;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (tags->list[middle].open < at)
            low = middle + 1;
        else
            high = middle;
    }
    return low < tags->count && tags->list[low].open == at ? low : 0;
}
