#include "xml.h"

#include <expat.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

typedef struct xml_feed {
    XML_Parser parser;
    bat_svg_reader *reader;
    bat_status status; /* the reader's first refusal; nothing is fed after it */
    XML_Size line, column;
} xml_feed;

static void keep(xml_feed *feed, bat_status status) {
    if (status == BAT_OK || feed->status != BAT_OK) return;
    feed->status = status;
    feed->line = XML_GetCurrentLineNumber(feed->parser);
    feed->column = XML_GetCurrentColumnNumber(feed->parser) + 1;
    XML_StopParser(feed->parser, XML_FALSE);
}

static void XMLCALL on_start(void *user, const XML_Char *name, const XML_Char **attributes) {
    xml_feed *feed = user;
    if (feed->status == BAT_OK) {
        keep(feed, bat_svg_reader_start(feed->reader, name, (const char *const *)attributes));
    }
}

static void XMLCALL on_text(void *user, const XML_Char *text, int size) {
    xml_feed *feed = user;
    if (feed->status == BAT_OK) keep(feed, bat_svg_reader_text(feed->reader, text, (size_t)size));
}

static void XMLCALL on_end(void *user, const XML_Char *name) {
    (void)name;
    xml_feed *feed = user;
    if (feed->status == BAT_OK) keep(feed, bat_svg_reader_end(feed->reader));
}

/* The one-byte encoding that old drawing programs wrote and expat does not know: Windows-1252. */
static int XMLCALL on_encoding(void *user, const XML_Char *name, XML_Encoding *encoding) {
    static const int high[32] = {0x20AC, -1,     0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                 0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, -1,     0x017D, -1,
                                 -1,     0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, -1,     0x017E, 0x0178};
    (void)user;
    char lower[16] = "";
    for (size_t i = 0; i < sizeof lower - 1 && name[i]; i++) {
        lower[i] = (char)(name[i] >= 'A' && name[i] <= 'Z' ? name[i] + 32 : name[i]);
    }
    if (strcmp(lower, "windows-1252") != 0 && strcmp(lower, "cp1252") != 0) return XML_STATUS_ERROR;
    for (int i = 0; i < 256; i++) encoding->map[i] = i;
    for (int i = 0; i < 32; i++) encoding->map[128 + i] = high[i];
    encoding->data = NULL;
    encoding->convert = NULL;
    encoding->release = NULL;
    return XML_STATUS_OK;
}

static void place_at(bat_problem *problem, XML_Size line, XML_Size column) {
    snprintf(problem->place, sizeof problem->place, "line %lu, column %lu", (unsigned long)line,
             (unsigned long)column);
}

static bat_status parse(xml_feed *feed, const char *text, size_t size, bat_problem *problem) {
    while (size) { /* expat counts in int */
        int part = size > INT_MAX ? INT_MAX : (int)size;
        if (XML_Parse(feed->parser, text, part, (size_t)part == size) == XML_STATUS_ERROR) {
            if (feed->status != BAT_OK) return feed->status;
            enum XML_Error error = XML_GetErrorCode(feed->parser);
            if (error == XML_ERROR_NO_MEMORY) return BAT_MEMORY;
            place_at(problem, XML_GetCurrentLineNumber(feed->parser),
                     XML_GetCurrentColumnNumber(feed->parser) + 1);
            snprintf(problem->message, sizeof problem->message, "expected well-formed XML, found: %s",
                     XML_ErrorString(error));
            return BAT_SYNTAX;
        }
        text += part;
        size -= (size_t)part;
    }
    return BAT_OK;
}

bat_status xml_read_svg(const char *text, size_t size, const bat_svg_options *options, bat_document **out,
                        bat_svg_report *report, bat_problem *problem) {
    *problem = (bat_problem){.place = ""};
    if (size == 0) {
        place_at(problem, 1, 1);
        snprintf(problem->message, sizeof problem->message, "expected SVG, found an empty file");
        return BAT_SYNTAX;
    }
    xml_feed feed = {.status = BAT_OK};
    bat_status status = bat_svg_reader_create(options, &feed.reader);
    if (status != BAT_OK) return status;
    feed.parser = XML_ParserCreate(NULL);
    if (!feed.parser) {
        bat_svg_reader_free(feed.reader);
        return BAT_MEMORY;
    }
    XML_SetUserData(feed.parser, &feed);
    XML_SetElementHandler(feed.parser, on_start, on_end);
    XML_SetCharacterDataHandler(feed.parser, on_text);
    XML_SetUnknownEncodingHandler(feed.parser, on_encoding, NULL);
    status = parse(&feed, text, size, problem);
    if (status != BAT_OK && feed.status == BAT_OK) {
        bat_svg_reader_free(feed.reader);
    } else { /* the reader itself says what it did not like */
        status = bat_svg_reader_finish(feed.reader, out, report, problem);
        if (status == BAT_OK && feed.status != BAT_OK) status = feed.status;
        if (status != BAT_OK && feed.line) place_at(problem, feed.line, feed.column);
    }
    XML_ParserFree(feed.parser);
    return status;
}
