#include "format/model/inflate.h"

#include <string.h>

enum { MOST_BITS = 15, LITERALS = 288, DISTANCES = 32, QUICK_BITS = 10, END = 256 };

typedef struct stream {
    const unsigned char *at, *end;
    uint64_t bits; /* not yet used, the next one lowest */
    int held;
    bool short_of; /* it was read beyond the end */
} stream;

/* A canonical Huffman code: how many words there are of each length, their symbols in order, and for the first bits of a word
 * the symbol and the length, where that is not longer. */
typedef struct code {
    uint16_t count[MOST_BITS + 1], symbol[LITERALS];
    uint16_t quick[1 << QUICK_BITS]; /* 16 times the symbol, and the length; 0: longer, or no word */
} code;

static void fill(stream *s) {
    while (s->held <= 56 && s->at < s->end) {
        s->bits |= (uint64_t)*s->at++ << s->held;
        s->held += 8;
    }
}

static unsigned take(stream *s, int count) {
    if (s->held < count) fill(s);
    if (s->held < count) {
        s->short_of = true;
        return 0;
    }
    const unsigned value = (unsigned)(s->bits & (((uint64_t)1 << count) - 1));
    s->bits >>= count;
    s->held -= count;
    return value;
}

/* False: more words than there are of those lengths. lengths: of the word of each symbol, 0: it has none. */
static bool make_code(code *c, const unsigned char *lengths, int count) {
    uint16_t first[MOST_BITS + 2] = {0};
    int left = 1, word = 0;
    memset(c->count, 0, sizeof c->count);
    memset(c->quick, 0, sizeof c->quick);
    for (int i = 0; i < count; i++) c->count[lengths[i]]++;
    c->count[0] = 0;
    for (int length = 1; length <= MOST_BITS; length++) {
        left = 2 * left - c->count[length];
        if (left < 0) return false;
        first[length + 1] = (uint16_t)(first[length] + c->count[length]);
    }
    for (int i = 0; i < count; i++)
        if (lengths[i]) c->symbol[first[lengths[i]]++] = (uint16_t)i;
    for (int length = 1, k = 0; length <= QUICK_BITS; length++, word <<= 1)
        for (int i = 0; i < c->count[length]; i++, word++, k++) {
            int turned = 0; /* words begin with their highest bit */
            for (int b = 0; b < length; b++) turned |= (word >> b & 1) << (length - 1 - b);
            for (int at = turned; at < 1 << QUICK_BITS; at += 1 << length)
                c->quick[at] = (uint16_t)(c->symbol[k] << 4 | length);
        }
    return true;
}

/* The next symbol; -1: there is no such word. */
static int decode(stream *s, const code *c) {
    if (s->held < MOST_BITS) fill(s);
    const uint16_t quick = c->quick[s->bits & ((1 << QUICK_BITS) - 1)];
    if (quick && (quick & 15) <= s->held) {
        s->bits >>= quick & 15;
        s->held -= quick & 15;
        return quick >> 4;
    }
    int word = 0, first = 0, index = 0;
    for (int length = 1; length <= MOST_BITS && !s->short_of; length++) {
        word |= (int)take(s, 1);
        const int count = c->count[length];
        if (word - count < first) return c->symbol[index + word - first];
        index += count, first = (first + count) << 1, word <<= 1;
    }
    return -1;
}

typedef struct result {
    char *out;
    size_t size, made;
} result;

static bool copy_stored(stream *s, result *r) {
    take(s, s->held % 8); /* up to a whole byte */
    const unsigned size = take(s, 16), check = take(s, 16);
    if (s->short_of || size != (~check & 0xFFFF) || size > r->size - r->made) return false;
    for (unsigned i = 0; i < size; i++) r->out[r->made++] = (char)take(s, 8);
    return !s->short_of;
}

static bool copy_words(stream *s, result *r, const code *literals, const code *distances) {
    static const uint16_t sizes[] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                     31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258},
                          ways[] = {1,    2,    3,    4,    5,    7,    9,    13,    17,    25,
                                    33,   49,   65,   97,   129,  193,  257,  385,   513,   769,
                                    1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
    for (;;) {
        int symbol = decode(s, literals);
        if (symbol < 0 || s->short_of) return false;
        if (symbol < END) {
            if (r->made == r->size) return false;
            r->out[r->made++] = (char)symbol;
            continue;
        }
        if (symbol == END) return true;
        symbol -= END + 1;
        if (symbol >= (int)(sizeof sizes / sizeof *sizes)) return false;
        const size_t size = sizes[symbol] + take(s, symbol < 8 || symbol == 28 ? 0 : symbol / 4 - 1);
        const int way = decode(s, distances);
        if (way < 0 || way >= (int)(sizeof ways / sizeof *ways)) return false;
        const size_t back = ways[way] + take(s, way < 4 ? 0 : way / 2 - 1);
        if (s->short_of || back > r->made || size > r->size - r->made) return false;
        for (size_t i = 0; i < size; i++, r->made++) r->out[r->made] = r->out[r->made - back];
    }
}

static bool copy_fixed(stream *s, result *r) {
    unsigned char lengths[LITERALS];
    code literals, distances;
    for (int i = 0; i < LITERALS; i++) lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
    make_code(&literals, lengths, LITERALS);
    memset(lengths, 5, DISTANCES);
    make_code(&distances, lengths, DISTANCES);
    return copy_words(s, r, &literals, &distances);
}

/* Lengths of words, which are written in words themselves. */
static bool read_lengths(stream *s, const code *c, unsigned char *lengths, int count) {
    for (int i = 0; i < count;) {
        const int symbol = decode(s, c);
        if (symbol < 0 || s->short_of) return false;
        if (symbol < 16) {
            lengths[i++] = (unsigned char)symbol;
            continue;
        }
        if (symbol == 16 && i == 0) return false;
        const unsigned char repeated = symbol == 16 ? lengths[i - 1] : 0;
        const int times = symbol == 16   ? 3 + (int)take(s, 2)
                          : symbol == 17 ? 3 + (int)take(s, 3)
                                         : 11 + (int)take(s, 7);
        if (times > count - i) return false;
        for (int k = 0; k < times; k++) lengths[i++] = repeated;
    }
    return true;
}

static bool copy_dynamic(stream *s, result *r) {
    enum { KINDS = 19 };
    static const unsigned char order[KINDS] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                               11, 4,  12, 3, 13, 2, 14, 1, 15};
    unsigned char lengths[LITERALS + DISTANCES] = {0};
    code literals, distances;
    const int all = 257 + (int)take(s, 5), ways = 1 + (int)take(s, 5), kinds = 4 + (int)take(s, 4);
    if (all > 286 || ways > 30) return false;
    for (int i = 0; i < kinds; i++) lengths[order[i]] = (unsigned char)take(s, 3);
    if (s->short_of || !make_code(&literals, lengths, KINDS)) return false;
    memset(lengths, 0, KINDS);
    if (!read_lengths(s, &literals, lengths, all + ways) || lengths[END] == 0) return false;
    return make_code(&literals, lengths, all) && make_code(&distances, lengths + all, ways) &&
           copy_words(s, r, &literals, &distances);
}

bat_status bat_inflate(const char *packed, size_t packed_size, char *out, size_t size) {
    const unsigned char *from = (const unsigned char *)packed;
    stream s = {.at = from, .end = from + packed_size};
    result r = {out, size, 0};
    bool last = false, good = true;
    while (good && !last) {
        last = take(&s, 1);
        const unsigned kind = take(&s, 2);
        if (s.short_of) return BAT_SYNTAX;
        good = kind == 0   ? copy_stored(&s, &r)
               : kind == 1 ? copy_fixed(&s, &r)
               : kind == 2 ? copy_dynamic(&s, &r)
                           : false;
    }
    return good && r.made == size ? BAT_OK : BAT_SYNTAX;
}
