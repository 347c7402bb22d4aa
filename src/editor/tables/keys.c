/* Shortcuts as the tables write them: "Ctrl+Shift+Z Ctrl+Y [ Space". */
#include <batten/editor.h>
#include "editor/tables/keys.h"
#include <string.h>

/* One shortcut: its modifiers, and where its key is in the text. */
typedef struct shortcut {
    uint32_t modifiers;
    const char *key;
    size_t size;
} shortcut;

/* Reads the next shortcut of the list at *at, and moves *at past it; false at the end. */
static bool next(const char **at, shortcut *out) {
    static const struct {
        const char *prefix;
        uint32_t modifier;
    } prefixes[] = {{"Ctrl+", BAT_CTRL}, {"Shift+", BAT_SHIFT}, {"Alt+", BAT_ALT}};
    while (**at == ' ') ++*at;
    if (!**at) return false;
    size_t size = strcspn(*at, " ");
    *out = (shortcut){0, *at, size};
    *at += size;
    for (bool again = true; again;) {
        again = false;
        for (size_t i = 0; i < sizeof prefixes / sizeof *prefixes; i++) {
            size_t length = strlen(prefixes[i].prefix);
            if (out->size > length && !memcmp(out->key, prefixes[i].prefix, length)) {
                out->modifiers |= prefixes[i].modifier;
                out->key += length;
                out->size -= length;
                again = true;
            }
        }
    }
    return true;
}

bool bat_keys_valid(const char *keys) {
    if (strlen(keys) >= BAT_KEYS_ROOM) return false;
    for (const char *at = keys; *at; at++)
        if ((unsigned char)*at < ' ' || *at == '"' || *at == '\\') return false;
    return true;
}

static char lower(char c) { return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c; }
static bool is_letter(char c) { return lower(c) >= 'a' && lower(c) <= 'z'; }

bool bat_keys_match(const char *keys, const char *key, uint32_t modifiers) {
    if (modifiers & BAT_META) modifiers |= BAT_CTRL;
    if (!strcmp(key, " ")) key = "Space";
    size_t size = strlen(key);
    shortcut one;
    while (next(&keys, &one)) {
        if (one.size != size) continue;
        bool letter = size == 1 && is_letter(key[0]);
        if (letter ? lower(one.key[0]) != lower(key[0]) : memcmp(one.key, key, size) != 0) continue;
        /* Whether a character needs Shift depends on the keyboard layout: only letters and named keys ask for Shift. */
        uint32_t asked = BAT_CTRL | BAT_ALT | (letter || size > 1 ? (uint32_t)BAT_SHIFT : 0);
        if ((modifiers & asked) == (one.modifiers & asked)) return true;
    }
    return false;
}
