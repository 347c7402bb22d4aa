/* A byte stream as elements: 0x01 name 0x02 attribute 0x03 value ... 0x04 opens one, 0x05 closes it, the rest
 * is text. What can be read is a valid document, is written, and reads back the same; nothing that was written
 * is lost. */
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/document.h>

#include "support/xml.h"
#include "text/utf8.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { OPEN = 1, ATTRIBUTE = 2, VALUE = 3, START = 4, END = 5, PAIRS = 24 };

static void feed(bat_svg_reader *reader, char *text, size_t size) {
    for (size_t i = 0; i < size;) {
        if (text[i] == OPEN) {
            const char *list[2 * PAIRS + 1], *name = text + ++i;
            int n = 0;
            for (; i < size && text[i] != START; i++) {
                char mark = text[i];
                if (mark == ATTRIBUTE || mark == VALUE) text[i] = '\0';
                if ((mark == ATTRIBUTE && n % 2 == 0 && n < 2 * PAIRS) || (mark == VALUE && n % 2 == 1))
                    list[n++] = text + i + 1;
            }
            text[i] = '\0'; /* there is room for one byte after the end */
            list[n - n % 2] = NULL;
            bat_svg_reader_start(reader, name, list);
            i++;
        } else if (text[i] == END) {
            bat_svg_reader_end(reader);
            i++;
        } else {
            size_t start = i;
            while (i < size && text[i] != OPEN && text[i] != END) i++;
            bat_svg_reader_text(reader, text + start, i - start);
        }
    }
}

/* Writes the document in the native format and reads it back. */
static bat_document *read_native(const bat_document *document) {
    char *text;
    size_t size;
    bat_document *back = NULL;
    bat_status status = bat_document_write(document, &text, &size);
    if (status == BAT_MEMORY) return NULL;
    if (status != BAT_OK) abort();
    if (bat_document_read(text, size, &back, NULL) != BAT_OK) abort();
    bat_free(text);
    return back;
}

/* Every counted kind has a description, and the buffer's size is respected. */
static void say_losses(const bat_losses *lost) {
    for (int kind = 0; kind < BAT_LOSS_COUNT; kind++) {
        char words[60];
        bat_loss_words((bat_loss)kind, lost->count[kind], words, sizeof words);
        if (!bat_loss_key((bat_loss)kind) || strlen(words) >= sizeof words) abort();
    }
}

/* From a ten-millionth to millions of units, and none. */
static double precision_of(uint8_t byte) {
    static const double list[] = {0, BAT_SVG_UNSEEN, 1e-7, 1e-3, 0.5, 40, 1e6, 1e300};
    return list[byte % (sizeof list / sizeof *list)];
}

static void read_again(const char *svg) {
    bat_document *document = NULL;
    bat_svg_report report;
    bat_status status = xml_read(svg, NULL, &document, &report, NULL);
    if (status == BAT_OK ? !report.native || bat_losses_total(&report.lost) > 0
                         : status != BAT_MEMORY && status != BAT_COUNT)
        abort();
    bat_document_free(document);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bat_svg_reader *reader;
    bat_document *document = NULL;
    bat_svg_report report;
    bat_problem problem;
    bat_svg_options options;
    if (size % 2)
        bat_svg_options_init(&options, sizeof options);
    else
        bat_svg_options_init_merging(&options, sizeof options);
    char *text = malloc(size + 1);
    if (!text || bat_svg_reader_create(&options, &reader) != BAT_OK) {
        free(text);
        return 0;
    }
    memcpy(text, data, size);
    text[size] = '\0';
    feed(reader, text, size);
    free(text);
    if (size > 0 && data[0] == END) { /* abandoned early */
        bat_svg_reader_free(reader);
        return 0;
    }
    if (bat_svg_reader_finish(reader, &document, &report, &problem) != BAT_OK) return 0;
    if (bat_document_check(document)) abort();
    char line[200], *svg;
    size_t length;
    bat_svg_report_line(&report, line, sizeof line);
    say_losses(&report.lost);
    bat_document *back = read_native(document);
    if (back && bat_document_digest(back) != bat_document_digest(document)) abort();
    bat_status status = bat_svg_write(document, true, &svg, &length);
    if (status == BAT_OK) {
        if (!bat_utf8_valid(svg, length)) abort();
        read_again(svg);
        bat_free(svg);
    } else if (status != BAT_MEMORY && status != BAT_COUNT)
        abort();
    if (bat_svg_write_within(document, false, size > 0 ? precision_of(data[size - 1]) : 0, &svg, &length) ==
        BAT_OK)
        bat_free(svg);
    if (bat_svg_write_kept(document, true, BAT_SVG_UNSEEN, &svg, &length) == BAT_OK) bat_free(svg);
    bat_document_free(back);
    bat_document_free(document);
    return 0;
}
