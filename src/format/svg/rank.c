#include "format/svg/style.h"

#include <string.h>

enum { BEFORE = 1, AFTER = 2, FAR = 1 << 28 };

/* Where: among siblings of any type or of the same, counted from which end; those without a series are the first there. */
static const struct {
    const char *name;
    bool series, alike;
    uint8_t ends; /* 0: the root */
} ranks[] = {{"root", false, false, 0},
             {"first-child", false, false, BEFORE},
             {"last-child", false, false, AFTER},
             {"only-child", false, false, BEFORE | AFTER},
             {"first-of-type", false, true, BEFORE},
             {"last-of-type", false, true, AFTER},
             {"only-of-type", false, true, BEFORE | AFTER},
             {"nth-child", true, false, BEFORE},
             {"nth-last-child", true, false, AFTER},
             {"nth-of-type", true, true, BEFORE},
             {"nth-last-of-type", true, true, AFTER}};
enum { RANKS = sizeof ranks / sizeof *ranks };

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/* A sign, if there is one, and digits; *digits: how many. */
static const char *read_integer(const char *s, const char *end, int32_t *value, int *digits) {
    const bool minus = s < end && *s == '-';
    if (s < end && (*s == '-' || *s == '+')) s++;
    *value = *digits = 0;
    for (; s < end && *s >= '0' && *s <= '9'; s++, ++*digits)
        *value = *value < FAR / 10 ? 10 * *value + (*s - '0') : FAR;
    if (minus) *value = -*value;
    return s;
}

/* An+B (CSS Syntax 3, 6), without spaces around it. */
static bool read_series(const char *s, const char *end, bat_svg_rank *out) {
    int digits;
    const size_t size = (size_t)(end - s);
    const bool even = size == 4 && memcmp(s, "even", 4) == 0, odd = size == 3 && memcmp(s, "odd", 3) == 0;
    out->step = 2, out->offset = odd;
    if (even || odd) return true;
    const char *at = read_integer(s, end, &out->step, &digits);
    if (at == end || (*at != 'n' && *at != 'N')) {
        out->offset = out->step, out->step = 0;
        return at == end && digits > 0;
    }
    if (digits == 0) out->step = *s == '-' ? -1 : 1;
    for (at++; at < end && is_space(*at);) at++;
    if (at == end) return true;
    const bool minus = *at == '-';
    if (!minus && *at != '+') return false;
    for (at++; at < end && is_space(*at);) at++;
    if (at == end || *at < '0' || *at > '9') return false;
    at = read_integer(at, end, &out->offset, &digits);
    if (minus) out->offset = -out->offset;
    return at == end;
}

bool bat_svg_rank_read(const char *name, size_t size, const char *argument, size_t argument_size,
                       bat_svg_rank *out) {
    *out = (bat_svg_rank){0};
    for (int i = 0; i < RANKS; i++) {
        if (strlen(ranks[i].name) != size || memcmp(ranks[i].name, name, size) != 0) continue;
        out->number = (uint8_t)i;
        if (ranks[i].series != (argument != NULL)) return false;
        return !argument || read_series(argument, argument + argument_size, out);
    }
    return false;
}

bool bat_svg_rank_holds(const bat_svg_rank *rank, const bat_svg_tree *tree, uint32_t element) {
    const int ends = ranks[rank->number].ends, alike = ranks[rank->number].alike;
    if (ends == 0) return tree->elements[element].parent == 0;
    const bat_svg_standing *standing = &tree->standings[element]; /* the root stands alone */
    const uint32_t before = standing->before[alike], after = standing->after[alike];
    if (!ranks[rank->number].series)
        return (!(ends & BEFORE) || before == 0) && (!(ends & AFTER) || after == 0);
    const int64_t from = 1 + (int64_t)(ends & BEFORE ? before : after) - rank->offset;
    return rank->step == 0 ? from == 0 : from % rank->step == 0 && from / rank->step >= 0;
}
