/* A small XML parser for tests: well-formed input, feeds a bat_svg_reader. Elements, attributes, text, CDATA,
 * the five entities and character references; comments, declarations and a DOCTYPE are skipped. */
#ifndef BATTEN_TESTS_XML_H
#define BATTEN_TESTS_XML_H

#include <batten/format.h>

#include "text/utf8.h"

#include <stdlib.h>
#include <string.h>

/* Decodes entities in place; returns the new length. */
static inline size_t xml_decode(char *text, size_t size) {
    size_t n = 0;
    for (size_t i = 0; i < size;) {
        const char *semicolon = text[i] == '&' ? memchr(text + i, ';', size - i) : NULL;
        if (!semicolon) {
            text[n++] = text[i++];
            continue;
        }
        static const char *const names[] = {"lt", "gt", "amp", "quot", "apos"};
        static const char values[] = "<>&\"'";
        size_t length = (size_t)(semicolon - text) - i - 1;
        if (text[i + 1] == '#') {
            bool hex = text[i + 2] == 'x';
            n += (size_t)bat_utf8_encode((uint32_t)strtoul(text + i + 2 + hex, NULL, hex ? 16 : 10),
                                         text + n);
        } else
            for (int k = 0; k < 5; k++)
                if (strlen(names[k]) == length && memcmp(names[k], text + i + 1, length) == 0)
                    text[n++] = values[k];
        i += length + 2;
    }
    return n;
}

/* False when the text is not even roughly XML, or out of memory. */
static inline bool xml_feed(bat_svg_reader *reader, const char *source) {
    size_t size = strlen(source);
    char *text = malloc(size + 1);
    if (!text) return false;
    char *at = text, *end = text + size;
    memcpy(text, source, size + 1);
    bool good = true;
    while (at < end && good) {
        if (*at != '<') {
            char *stop = memchr(at, '<', (size_t)(end - at));
            if (!stop) stop = end;
            bat_svg_reader_text(reader, at, xml_decode(at, (size_t)(stop - at)));
            at = stop;
        } else if (strncmp(at, "<![CDATA[", 9) == 0) {
            char *stop = strstr(at, "]]>");
            good = stop != NULL;
            if (stop) bat_svg_reader_text(reader, at + 9, (size_t)(stop - at - 9)), at = stop + 3;
        } else if (strncmp(at, "<!--", 4) == 0) {
            at = strstr(at, "-->");
            good = at != NULL;
            if (at) at += 3;
        } else if (at[1] == '?' || at[1] == '!') {
            int depth = 0;
            for (; at < end; at++) {
                if (*at == '[' || *at == '<') depth++;
                if (*at == ']' || *at == '>') depth--;
                if (depth == 0) break;
            }
            at++;
        } else if (at[1] == '/') {
            at = memchr(at, '>', (size_t)(end - at));
            good = at != NULL;
            if (at) at++, bat_svg_reader_end(reader);
        } else {
            const char *list[256];
            int n = 0;
            char *name = ++at;
            at += strcspn(at, " \t\r\n/>");
            char mark = *at;
            *at = '\0';
            bool empty = false;
            while (mark != '>') {
                if (mark == '\0') break;
                if (mark == '/') empty = true;
                at++;
                at += strspn(at, " \t\r\n");
                if (*at == '>' || *at == '/') {
                    mark = *at;
                    continue;
                }
                char *equals = strchr(at, '=');
                if (!equals) break;
                list[n++] = at;
                char *quote = equals + 1 + strspn(equals + 1, " \t\r\n"), *close = strchr(quote + 1, *quote);
                if (!close || n > 250) break;
                *equals = '\0';
                equals = at + strcspn(at, " \t\r\n"); /* blanks before the equals sign */
                *equals = '\0';
                list[n++] = quote + 1;
                quote[1 + xml_decode(quote + 1, (size_t)(close - quote - 1))] = '\0';

                at = close;
                mark = ' ';
            }
            good = mark == '>';
            at++;
            list[n] = NULL;
            bat_svg_reader_start(reader, name, list);
            if (empty) bat_svg_reader_end(reader);
        }
    }
    free(text);
    return good;
}

static inline bat_status xml_read(const char *source, const bat_svg_options *options, bat_document **out,
                                  bat_svg_report *report, bat_problem *problem) {
    bat_svg_reader *reader;
    bat_status status = bat_svg_reader_create(options, &reader);
    if (status != BAT_OK) return status;
    if (xml_feed(reader, source)) return bat_svg_reader_finish(reader, out, report, problem);
    bat_svg_reader_free(reader);
    return BAT_MEMORY;
}

#endif
