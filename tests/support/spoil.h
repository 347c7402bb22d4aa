/* Valid texts with one word replaced, which every reader must refuse with a reason or read into something sound. */
#ifndef BATTEN_TESTS_SPOIL_H
#define BATTEN_TESTS_SPOIL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* The words of a text. JSON: names and values, including whole lists and objects; XML: quoted strings; lines: parts
 * between blanks. Finds the next word at or after *at; false: there are no more. */
typedef bool spoil_words(const char *text, size_t *at, size_t *end);

static inline size_t spoil_string_end(const char *text, size_t at) {
    for (at++; text[at] && text[at] != '"'; at++)
        if (text[at] == '\\') at++;
    return text[at] ? at + 1 : at;
}

static inline bool spoil_json(const char *text, size_t *at, size_t *end) {
    *at += strcspn(text + *at, "\"{[-0123456789tfn");
    if (!text[*at]) return false;
    if (text[*at] == '"') {
        *end = spoil_string_end(text, *at);
    } else if (text[*at] == '{' || text[*at] == '[') {
        int depth = 0;
        size_t i = *at;
        do {
            depth += (text[i] == '{' || text[i] == '[') - (text[i] == '}' || text[i] == ']');
            i = text[i] == '"' ? spoil_string_end(text, i) : i + 1;
        } while (depth > 0 && text[i]);
        *end = i;
    } else {
        *end = *at + strcspn(text + *at, ",:]} \n");
    }
    return true;
}

static inline bool spoil_quoted(const char *text, size_t *at, size_t *end) {
    *at += strcspn(text + *at, "'");
    if (!text[*at]) return false;
    ++*at;
    *end = *at + strcspn(text + *at, "'");
    return text[*end] != 0;
}

static inline bool spoil_blanks(const char *text, size_t *at, size_t *end) {
    *at += strspn(text + *at, " \n");
    *end = *at + strcspn(text + *at, " \n");
    return text[*at] != 0;
}

/* Where to continue after a word. */
static inline size_t spoil_next(spoil_words *words, const char *text, size_t at, size_t end) {
    if (words == spoil_quoted) return end + 1;
    return text[at] == '{' || text[at] == '[' ? at + 1 : end; /* descend into it */
}

static inline int spoil_count(spoil_words *words, const char *text) {
    int count = 0;
    for (size_t at = 0, end; words(text, &at, &end); at = spoil_next(words, text, at, end)) count++;
    return count;
}

/* The text with its nth word replaced; the caller frees it with free(). */
static inline char *spoil(spoil_words *words, const char *text, int n, const char *by) {
    size_t at = 0, end = 0, size = strlen(text), more = strlen(by);
    for (int i = 0; words(text, &at, &end) && i < n; i++) at = spoil_next(words, text, at, end);
    char *made = malloc(size + more + 1);
    if (!made) abort();
    memcpy(made, text, at);
    memcpy(made + at, by, more);
    memcpy(made + at + more, text + end, size - end + 1);
    return made;
}

#endif
