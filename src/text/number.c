#include "text/number.h"

#include "text/digits.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Digits beyond these affect the rounding only by whether all are zero (a double needs 767 at most). */
enum { DIGITS = 800, EXPONENT_LIMIT = 100000 };

/* A decimal: digits (no leading zero) * 10^exponent. */
typedef struct decimal {
    char digits[DIGITS + 1];
    int kept;
    long exponent;
    uint64_t mantissa; /* of the first 19 digits */
    bool any, dropped;
} decimal;

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

static void add_digit(decimal *d, char c, bool fraction) {
    d->any = true;
    if (d->exponent < -EXPONENT_LIMIT || d->exponent > EXPONENT_LIMIT) return;
    if (fraction) d->exponent--;
    if (d->kept == 0 && c == '0') return;
    if (d->kept < DIGITS) {
        if (d->kept < 19) d->mantissa = d->mantissa * 10 + (uint64_t)(c - '0');
        d->digits[d->kept++] = c;
    } else {
        d->exponent++;
        if (c != '0') d->dropped = true;
    }
}

static double decimal_value(decimal *d) {
    static const double tens[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                  1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    if (d->kept == 0) return 0;
    /* Both numbers are exact, so there is only one rounding (Clinger 1990). */
    if (d->kept <= 19 && d->mantissa <= (uint64_t)1 << 53 && labs(d->exponent) <= 22)
        return d->exponent < 0 ? (double)d->mantissa / tens[-d->exponent]
                               : (double)d->mantissa * tens[d->exponent];
    if (d->dropped) d->digits[d->kept++] = '1', d->exponent--;
    return bat_digits_value(d->digits, d->kept, d->exponent);
}

const char *bat_number_scan(const char *text, const char *end, double *value) {
    const char *at = text;
    bool negative = false;
    if (at < end && (*at == '-' || *at == '+')) negative = *at++ == '-';
    decimal d;
    d.kept = 0, d.exponent = 0, d.mantissa = 0, d.any = d.dropped = false;
    for (; at < end && is_digit(*at); at++) add_digit(&d, *at, false);
    if (at < end && *at == '.' && (d.any || (at + 1 < end && is_digit(at[1]))))
        for (at++; at < end && is_digit(*at); at++) add_digit(&d, *at, true);
    if (!d.any) return NULL;
    if (at < end && (*at == 'e' || *at == 'E')) {
        const char *e = at + 1;
        bool down = false;
        if (e < end && (*e == '-' || *e == '+')) down = *e++ == '-';
        if (e < end && is_digit(*e)) {
            long power = 0;
            for (; e < end && is_digit(*e); e++)
                if (power < EXPONENT_LIMIT) power = power * 10 + (*e - '0');
            d.exponent += down ? -power : power;
            at = e;
        }
    }
    double size = decimal_value(&d);
    *value = negative ? -size : size;
    return at;
}

/* Prints digits[0..n), which mean d.ddd * 10^power. */
static int lay_out(bool negative, const char *digits, int n, int power, char *out) {
    char *at = out;
    if (negative) *at++ = '-';
    if (power >= 0 && power <= 20) {
        for (int i = 0; i < n || i <= power; i++) {
            if (i == power + 1) *at++ = '.';
            *at++ = i < n ? digits[i] : '0';
        }
    } else if (power < 0 && power >= -6) {
        *at++ = '0', *at++ = '.';
        for (int i = -1; i > power; i--) *at++ = '0';
        for (int i = 0; i < n; i++) *at++ = digits[i];
    } else {
        *at++ = digits[0];
        if (n > 1) *at++ = '.';
        for (int i = 1; i < n; i++) *at++ = digits[i];
        at += snprintf(at, 8, "e%d", power);
    }
    *at = '\0';
    return (int)(at - out);
}

int bat_number_print(double value, char out[BAT_NUMBER_ROOM]) {
    if (!isfinite(value)) {
        memcpy(out, "null", 5);
        return 4;
    }
    bool negative = signbit(value) != 0;
    double size = fabs(value);
    if (size == 0) return lay_out(negative, "0", 1, 0, out);
    char soon[17];
    int place, count = bat_digits_shortest(size, soon, &place);
    if (count) return lay_out(negative, soon, count, place, out);
    /* 15 digits always survive conversion to a double and back, so no text is shorter (trailing zeros aside)
     * than a 15-digit one that reads back. This does not hold for subnormal numbers. */
    for (int precision = size < DBL_MIN ? 1 : 15;; precision++) {
        char digits[17];
        int n = precision, power;
        bat_digits_leading(size, n, digits, &power);
        while (n > 1 && digits[n - 1] == '0') n--;
        int length = lay_out(negative, digits, n, power, out);
        double back;
        if (precision >= 17) return length;
        if (bat_number_scan(out, out + length, &back) && back == value) return length;
    }
}
