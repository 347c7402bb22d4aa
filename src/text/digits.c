#include "text/digits.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* A natural number, least significant word first. The largest ones compared are 816 digits at 10^0 against a
 * double's 2^-1075 moved to the other side, or 2^54 against 10^1141 for as many digits after the point: under
 * 3850 bits. */
enum { WORDS = 128 };
typedef struct natural {
    uint32_t words[WORDS];
    int used;
} natural;

static void scale(natural *n, uint32_t factor, uint32_t add) {
    uint64_t carry = add;
    for (int i = 0; i < n->used; i++) {
        carry += (uint64_t)n->words[i] * factor;
        n->words[i] = (uint32_t)carry;
        carry >>= 32;
    }
    if (carry && n->used < WORDS) n->words[n->used++] = (uint32_t)carry;
}

static void scale_by_power(natural *n, uint32_t base, uint32_t chunk, int chunk_power, long power) {
    for (; power >= chunk_power; power -= chunk_power) scale(n, chunk, 0);
    for (; power > 0; power--) scale(n, base, 0);
}

static void times_ten_to(natural *n, long power) { scale_by_power(n, 10, 1000000000, 9, power); }
static void times_two_to(natural *n, long power) { scale_by_power(n, 2, 1u << 31, 31, power); }

static int compare(const natural *a, const natural *b) {
    if (a->used != b->used) return a->used < b->used ? -1 : 1;
    for (int i = a->used - 1; i >= 0; i--)
        if (a->words[i] != b->words[i]) return a->words[i] < b->words[i] ? -1 : 1;
    return 0;
}

static natural natural_of(uint64_t value) {
    natural n;
    n.words[0] = (uint32_t)value, n.words[1] = (uint32_t)(value >> 32);
    n.used = n.words[1] ? 2 : n.words[0] ? 1 : 0;
    return n;
}

/* value = mantissa * 2^exponent. */
static uint64_t take_apart(double value, int *exponent) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    int biased = (int)(bits >> 52 & 0x7ff);
    uint64_t fraction = bits & (((uint64_t)1 << 52) - 1);
    *exponent = (biased ? biased : 1) - 1075;
    return biased ? fraction | (uint64_t)1 << 52 : fraction;
}

/* ---- numbers of every day: exact in 128 bits ---- */

typedef struct wide {
    uint64_t high, low;
} wide;

/* 5^k below 2^63. */
enum { FIVES = 27 };
static uint64_t five_to(int k) {
    uint64_t five = 1;
    for (uint64_t factor = 5; k; k >>= 1, factor *= factor)
        if (k & 1) five *= factor;
    return five;
}

static wide times(uint64_t a, uint64_t b) {
    const uint64_t a0 = (uint32_t)a, a1 = a >> 32, b0 = (uint32_t)b, b1 = b >> 32;
    const uint64_t low = a0 * b0, cross = a1 * b0 + (low >> 32), other = a0 * b1 + (uint32_t)cross;
    return (wide){a1 * b1 + (cross >> 32) + (other >> 32), other << 32 | (uint32_t)low};
}

/* As `above` below, of digits of 64 bits; -1: this takes more than 128. */
static int above_soon(uint64_t digits, long exponent, uint64_t mantissa, int e) {
    const int by = (int)(1 - e + exponent);
    if (exponent > 0 || exponent < -FIVES || by < 0 || by > 63) return -1;
    const wide right = times(2 * mantissa + 1, five_to((int)-exponent));
    const wide left = {by ? digits >> (64 - by) : 0, digits << by};
    if (left.high != right.high) return left.high > right.high;
    return left.low > right.low || (left.low == right.low && (mantissa & 1));
}

/* Whether digits * 10^exponent rounds to a double greater than x. */
static bool above(const natural *decimal, long exponent, double x) {
    int e;
    uint64_t mantissa = take_apart(x, &e);
    if (decimal->used <= 2) {
        const uint64_t digits = decimal->words[0] |
                                (decimal->used > 1 ? (uint64_t)decimal->words[1] << 32 : 0);
        const int soon = above_soon(digits, exponent, mantissa, e);
        if (soon >= 0) return soon;
    }
    natural left = *decimal, right = natural_of(2 * mantissa + 1);
    e--;
    if (exponent > 0) times_ten_to(&left, exponent);
    if (exponent < 0) times_ten_to(&right, -exponent);
    if (e > 0) times_two_to(&right, e);
    if (e < 0) times_two_to(&left, -e);
    int order = compare(&left, &right);
    return order > 0 || (order == 0 && (mantissa & 1));
}

/* The next double above (step 1) or below (step -1) x >= 0; for 0 only the one above. */
static double neighbour(double x, int step) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits = step > 0 ? bits + 1 : bits - 1;
    memcpy(&x, &bits, sizeof x);
    return x;
}

double bat_digits_value(const char *digits, int n, long exponent) {
    if (n + exponent > 310) return INFINITY;
    if (n + exponent < -325) return 0;
    natural decimal = natural_of(0);
    for (int i = 0; i < n; i++) {
        if (decimal.used == 0) decimal.words[0] = 0, decimal.used = 1;
        scale(&decimal, 10, (uint32_t)(digits[i] - '0'));
    }
    /* A first guess, off by a few units in the last place; the exact comparison then decides. */
    uint64_t start = 0;
    int kept = n < 19 ? n : 19;
    for (int i = 0; i < kept; i++) start = start * 10 + (uint64_t)(digits[i] - '0');
    double x = (double)start;
    long power = exponent + n - kept;
    for (; power >= 22; power -= 22) x *= 1e22;
    for (; power > 0; power--) x *= 10;
    for (; power <= -22; power += 22) x /= 1e22;
    for (; power < 0; power++) x /= 10;
    if (x > DBL_MAX) x = DBL_MAX;
    while (x > 0 && !above(&decimal, exponent, neighbour(x, -1))) x = neighbour(x, -1);
    while (x <= DBL_MAX && above(&decimal, exponent, x)) x = neighbour(x, 1);
    return x;
}

/* The exact decimal expansion of a double, in cells of nine digits, most significant first. */
enum { BILLION = 1000000000, CELLS = 168, POINT = 40 };
typedef struct expansion {
    uint32_t cells[CELLS]; /* value = sum of cells[i] * 10^(9 * (POINT - i)) */
    int first, last;
} expansion;

static void expand(double value, expansion *x) {
    int exponent;
    uint64_t mantissa = take_apart(value, &exponent);
    x->first = x->last = POINT;
    for (x->first = POINT + 1; mantissa; mantissa /= BILLION)
        x->cells[--x->first] = (uint32_t)(mantissa % BILLION);
    for (int left = exponent; left > 0; left -= 29) {
        int shift = left < 29 ? left : 29;
        uint64_t carry = 0;
        for (int i = x->last; i >= x->first; i--) {
            carry += (uint64_t)x->cells[i] << shift;
            x->cells[i] = (uint32_t)(carry % BILLION);
            carry /= BILLION;
        }
        if (carry) x->cells[--x->first] = (uint32_t)carry;
    }
    for (int right = -exponent; right > 0; right -= 9) { /* 10^9 is divisible by 2^9: each pass is exact */
        int shift = right < 9 ? right : 9;
        uint32_t carry = 0;
        for (int i = x->first; i <= x->last; i++) {
            uint32_t low = x->cells[i] & ((1u << shift) - 1);
            x->cells[i] = (x->cells[i] >> shift) + carry;
            carry = ((uint32_t)BILLION >> shift) * low;
        }
        if (carry && x->last + 1 < CELLS) x->cells[++x->last] = carry;
        while (x->first < x->last && x->cells[x->first] == 0) x->first++;
    }
}

static const uint32_t tens[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};

/* Digit i, counted from the first nonzero one; zero past the end. */
static int digit_at(const expansion *x, int lead, int i) {
    int place = i + 9 - lead, cell = x->first + place / 9;
    return cell > x->last ? 0 : (int)(x->cells[cell] / tens[8 - place % 9] % 10);
}

/* Rounds to `count` digits; with 0, a carry may still produce one digit. Returns how many there are. */
static int round_to(const expansion *x, int lead, int count, char *digits, int *power) {
    for (int i = 0; i < count; i++) digits[i] = (char)('0' + digit_at(x, lead, i));
    int next = digit_at(x, lead, count);
    bool more = false;
    for (int i = count + 1; !more && i < lead + 9 * (x->last - x->first); i++)
        more = digit_at(x, lead, i) != 0;
    if (next < 5 || (next == 5 && !more && (count == 0 || (digits[count - 1] & 1) == 0))) return count;
    int at = count - 1;
    for (; at >= 0 && digits[at] == '9'; at--) digits[at] = '0';
    if (at >= 0) {
        digits[at]++;
        return count;
    }
    digits[0] = '1', ++*power;
    if (count > 0) digits[count] = '0';
    return count + 1;
}

static int leading(const expansion *x, int *power) {
    int lead = 1;
    while (lead < 9 && x->cells[x->first] >= tens[lead]) lead++;
    *power = 9 * (POINT - x->first) + lead - 1;
    return lead;
}

/* Sets *out to value * 10^k, rounded half to even; 1: it is read back as the value, 0: it is not, -1: unknown, since it takes more
 * than 128 bits or the doubles below the value are closer than those above. */
static int scaled(double value, int k, uint64_t *out) {
    int e;
    const uint64_t mantissa = take_apart(value, &e);
    const int by = -e - k;
    if (k < 0 || k > FIVES || by < 1 || by > 63 || mantissa == (uint64_t)1 << 52) return -1;
    const uint64_t five = five_to(k), half = (uint64_t)1 << (by - 1);
    const wide product = times(mantissa, five);
    if (product.high >> by) return -1;
    const uint64_t whole = product.high << (64 - by) | product.low >> by, rest = product.low & (2 * half - 1);
    const bool up = rest > half || (rest == half && (whole & 1));
    const uint64_t off = up ? 2 * half - rest : rest;
    *out = whole + up;
    return off <= five / 2; /* five is a unit of the mantissa, and odd: nothing is half way */
}

int bat_digits_shortest(double value, char *digits, int *power) {
    int e;
    (void)take_apart(value, &e);
    const int lowest = (int)floor(
        (e + 52) * 0.30103); /* the value is 2^(e + 52) at least, or too small to be found here */
    int place = lowest, known = 0;
    uint64_t whole = 0;
    for (int count = 15; count <= 17 && known <= 0; count++) {
        const uint64_t most = five_to(count) << count;
        place = lowest;
        known = scaled(value, count - 1 - place, &whole);
        while (known >= 0 && whole >= most) known = scaled(value, count - 1 - ++place, &whole);
        if (known < 0) return 0;
    }
    while (whole % 10 == 0) whole /= 10;
    int n = 0;
    for (uint64_t left = whole; left; left /= 10) n++;
    for (int i = n - 1; i >= 0; i--, whole /= 10) digits[i] = (char)('0' + whole % 10);
    *power = place;
    return n;
}

void bat_digits_leading(double value, int count, char *digits, int *power) {
    expansion x;
    expand(value, &x);
    char all[20];
    count = count < 1 ? 1 : count > 17 ? 17 : count;
    int lead = leading(&x, power);
    round_to(&x, lead, count, all, power);
    memcpy(digits, all, (size_t)count);
}

int bat_digits_places(double value, int places, char *digits, int *power) {
    expansion x;
    expand(value, &x);
    int lead = leading(&x, power), count = *power + 1 + places;
    if (count < 0) return 0;
    if (count > 17) {
        bat_digits_leading(value, 17, digits, power);
        return 17;
    }
    char all[20];
    count = round_to(&x, lead, count, all, power);
    if (count > 17) count = 17;
    memcpy(digits, all, (size_t)count);
    return count;
}
