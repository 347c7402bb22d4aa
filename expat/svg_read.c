/* SVG files: expat takes the XML apart, the library's reader makes a document of it. */
#include <batten/svg_read.h>

#include <expat.h>
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

/* A file that is named is never fetched, and what should stand there cannot be left out. */
static int XMLCALL on_external(XML_Parser parser, const XML_Char *context, const XML_Char *base,
                               const XML_Char *system, const XML_Char *public_name) {
    (void)parser, (void)context, (void)base, (void)system, (void)public_name;
    return XML_STATUS_ERROR;
}

static bat_status refuse(xml_feed *feed, bat_problem *problem) {
    if (feed->status != BAT_OK) return feed->status;
    enum XML_Error error = XML_GetErrorCode(feed->parser);
    if (error == XML_ERROR_NO_MEMORY) return BAT_MEMORY;
    place_at(problem, XML_GetCurrentLineNumber(feed->parser), XML_GetCurrentColumnNumber(feed->parser) + 1);
    if (error == XML_ERROR_EXTERNAL_ENTITY_HANDLING)
        snprintf(problem->message, sizeof problem->message,
                 "expected all in one file, found an external entity");
    else
        snprintf(problem->message, sizeof problem->message, "expected well-formed XML, found: %s",
                 XML_ErrorString(error));
    return BAT_SYNTAX;
}

/* The reader itself says what it did not like, but for where. */
static bat_status finish(xml_feed *feed, bat_status status, bat_document **out, bat_svg_report *report,
                         bat_problem *problem) {
    if (status != BAT_OK && feed->status == BAT_OK) {
        bat_svg_reader_free(feed->reader);
        return status;
    }
    status = bat_svg_reader_finish(feed->reader, out, report, problem);
    if (status != BAT_OK && feed->line) place_at(problem, feed->line, feed->column);
    return status;
}

static bat_status read(const char *text, size_t size, const bat_svg_options *options, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
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
    XML_SetExternalEntityRefHandler(feed.parser, on_external);
    keep(&feed, bat_svg_reader_source(feed.reader, text, size));
    if (XML_Parse(feed.parser, text, (int)size, XML_TRUE) == XML_STATUS_ERROR)
        status = refuse(&feed, problem);
    status = finish(&feed, status, out, report, problem);
    XML_ParserFree(feed.parser);
    return status;
}

bat_status bat_svg_read(const char *text, size_t size, const bat_svg_options *options, bat_document **out,
                        bat_svg_report *report, bat_problem *problem) {
    bat_problem own;
    if (!problem) problem = &own;
    *problem = (bat_problem){.place = ""};
    bat_status status = BAT_OK;
    if (!out || (size > 0 && !text)) {
        status = BAT_ARGUMENT;
    } else if (size == 0) {
        status = BAT_SYNTAX;
        place_at(problem, 1, 1);
        snprintf(problem->message, sizeof problem->message, "expected XML, found an empty file");
    } else if (size > BAT_SVG_SIZE) {
        status = BAT_COUNT;
        snprintf(problem->message, sizeof problem->message,
                 "expected an SVG file of at most %zu bytes, found %zu", BAT_SVG_SIZE, size);
    } else {
        status = read(text, size, options, out, report, problem);
    }
    if (status != BAT_OK && !problem->message[0])
        snprintf(problem->message, sizeof problem->message, "%s", bat_status_message(status));
    return status;
}
