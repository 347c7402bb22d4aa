#include "print.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "text/digits.h"

typedef struct sink {
    char *out;
    size_t room, used;
} sink;

static void put(sink *s, char c) {
    if (s->used + 1 < s->room) s->out[s->used] = c;
    s->used++;
}

static void put_all(sink *s, const char *text, size_t length) {
    for (size_t i = 0; i < length; i++) put(s, text[i]);
}

static size_t natural_text(uint64_t value, unsigned base, char *end) {
    char *at = end;
    do *--at = "0123456789abcdef"[value % base];
    while (value /= base);
    return (size_t)(end - at);
}

/* Writes digits * 10^power with `places` decimals. */
static char *fixed(char *at, const char *digits, int n, int power, int places) {
    for (int i = power > 0 ? power : 0; i >= -places; i--) {
        if (i == -1) *at++ = '.';
        *at++ = power - i >= 0 && power - i < n ? digits[power - i] : '0';
    }
    return at;
}

enum { PRECISION_MOST = 60, NUMBER_ROOM = 400 };

static size_t real_text(double value, char kind, int precision, char *out) {
    char *at = out, digits[20] = "0";
    if (signbit(value)) *at++ = '-';
    if (!isfinite(value)) {
        memcpy(at, isnan(value) ? "nan" : "inf", 3);
        return (size_t)(at + 3 - out);
    }
    int n = 1, power = 0,
        places = precision < 0                ? 6
                 : precision > PRECISION_MOST ? PRECISION_MOST
                                              : precision;
    value = fabs(value);
    if (kind == 'f') {
        if (value > 0) n = bat_digits_places(value, places, digits, &power);
        return (size_t)(fixed(at, digits, n, power, places) - out);
    }
    if (kind == 'g' && places > 0) places--;
    if (value > 0) n = places < 16 ? places + 1 : 17, bat_digits_leading(value, n, digits, &power);
    if (kind == 'g') {
        int wanted = places + 1;
        while (n > 1 && digits[n - 1] == '0') n--;
        places = n - 1;
        if (power < wanted && power >= -4)
            return (size_t)(fixed(at, digits, n, power, n - 1 > power ? n - 1 - power : 0) - out);
    }
    at = fixed(at, digits, n, 0, places);
    *at++ = 'e', *at++ = power < 0 ? '-' : '+';
    unsigned size = (unsigned)(power < 0 ? -power : power);
    char text[8], *end = text + sizeof text;
    size_t length = natural_text(size, 10, end);
    if (length < 2) *at++ = '0';
    memcpy(at, end - length, length);
    return (size_t)(at + length - out);
}

int bat_print(char *out, size_t room, const char *format, va_list values) {
    sink s = {out, room, 0};
    for (; *format; format++) {
        if (*format != '%') {
            put(&s, *format);
            continue;
        }
        const char *start = format++;
        bool zeros = *format == '0', wide = false;
        int width = 0, precision = -1;
        for (; *format >= '0' && *format <= '9'; format++) width = width * 10 + (*format - '0');
        if (*format == '.') {
            precision = 0;
            if (*++format == '*') precision = va_arg(values, int), format++;
            for (; *format >= '0' && *format <= '9'; format++) precision = precision * 10 + (*format - '0');
        }
        for (; *format == 'l' || *format == 'z'; format++) wide = true;
        char number[NUMBER_ROOM], *end = number + sizeof number;
        const char *text = number;
        size_t length = 1;
        switch (*format) {
        case '%': number[0] = '%'; break;
        case 'c': number[0] = (char)va_arg(values, int); break;
        case 's':
            text = va_arg(values, const char *);
            for (length = 0; (precision < 0 || length < (size_t)precision) && text[length];) length++;
            break;
        case 'd': {
            int64_t value = wide ? va_arg(values, long) : va_arg(values, int);
            length = natural_text(value < 0 ? 0 - (uint64_t)value : (uint64_t)value, 10, end);
            text = end - length;
            if (value < 0) *(end - ++length) = '-', text--;
            break;
        }
        case 'u':
        case 'x':
            length = natural_text(wide ? va_arg(values, unsigned long) : va_arg(values, unsigned),
                                  *format == 'x' ? 16 : 10, end);
            text = end - length;
            break;
        case 'e':
        case 'f':
        case 'g': length = real_text(va_arg(values, double), *format, precision, number); break;
        default: /* unknown: its argument's type is not known, so neither are those of the rest */
            put_all(&s, start, strlen(start));
            goto end;
        }
        for (size_t i = length; i < (size_t)width; i++) put(&s, zeros ? '0' : ' ');
        put_all(&s, text, length);
    }
end:
    if (room > 0) out[s.used < room ? s.used : room - 1] = '\0';
    return (int)s.used;
}

#ifdef __wasm__
#include <stdio.h>

int vsnprintf(char *restrict out, size_t room, const char *restrict format, va_list values) {
    return bat_print(out, room, format, values);
}

int snprintf(char *restrict out, size_t room, const char *restrict format, ...) {
    va_list values;
    va_start(values, format);
    int length = bat_print(out, room, format, values);
    va_end(values);
    return length;
}
#endif
