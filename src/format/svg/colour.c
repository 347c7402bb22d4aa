/* Colours in the syntax of CSS Color 4: names, hexadecimal, rgb(), hsl(). */
#include "text/number.h"
#include "format/svg/style.h"

#include <math.h>
#include <string.h>

typedef struct named {
    char name[22];
    uint32_t rgb;
} named;

static const named names[] = {{"aliceblue", 0xf0f8ff},
                              {"antiquewhite", 0xfaebd7},
                              {"aqua", 0x00ffff},
                              {"aquamarine", 0x7fffd4},
                              {"azure", 0xf0ffff},
                              {"beige", 0xf5f5dc},
                              {"bisque", 0xffe4c4},
                              {"black", 0x000000},
                              {"blanchedalmond", 0xffebcd},
                              {"blue", 0x0000ff},
                              {"blueviolet", 0x8a2be2},
                              {"brown", 0xa52a2a},
                              {"burlywood", 0xdeb887},
                              {"cadetblue", 0x5f9ea0},
                              {"chartreuse", 0x7fff00},
                              {"chocolate", 0xd2691e},
                              {"coral", 0xff7f50},
                              {"cornflowerblue", 0x6495ed},
                              {"cornsilk", 0xfff8dc},
                              {"crimson", 0xdc143c},
                              {"cyan", 0x00ffff},
                              {"darkblue", 0x00008b},
                              {"darkcyan", 0x008b8b},
                              {"darkgoldenrod", 0xb8860b},
                              {"darkgray", 0xa9a9a9},
                              {"darkgreen", 0x006400},
                              {"darkgrey", 0xa9a9a9},
                              {"darkkhaki", 0xbdb76b},
                              {"darkmagenta", 0x8b008b},
                              {"darkolivegreen", 0x556b2f},
                              {"darkorange", 0xff8c00},
                              {"darkorchid", 0x9932cc},
                              {"darkred", 0x8b0000},
                              {"darksalmon", 0xe9967a},
                              {"darkseagreen", 0x8fbc8f},
                              {"darkslateblue", 0x483d8b},
                              {"darkslategray", 0x2f4f4f},
                              {"darkslategrey", 0x2f4f4f},
                              {"darkturquoise", 0x00ced1},
                              {"darkviolet", 0x9400d3},
                              {"deeppink", 0xff1493},
                              {"deepskyblue", 0x00bfff},
                              {"dimgray", 0x696969},
                              {"dimgrey", 0x696969},
                              {"dodgerblue", 0x1e90ff},
                              {"firebrick", 0xb22222},
                              {"floralwhite", 0xfffaf0},
                              {"forestgreen", 0x228b22},
                              {"fuchsia", 0xff00ff},
                              {"gainsboro", 0xdcdcdc},
                              {"ghostwhite", 0xf8f8ff},
                              {"gold", 0xffd700},
                              {"goldenrod", 0xdaa520},
                              {"gray", 0x808080},
                              {"green", 0x008000},
                              {"greenyellow", 0xadff2f},
                              {"grey", 0x808080},
                              {"honeydew", 0xf0fff0},
                              {"hotpink", 0xff69b4},
                              {"indianred", 0xcd5c5c},
                              {"indigo", 0x4b0082},
                              {"ivory", 0xfffff0},
                              {"khaki", 0xf0e68c},
                              {"lavender", 0xe6e6fa},
                              {"lavenderblush", 0xfff0f5},
                              {"lawngreen", 0x7cfc00},
                              {"lemonchiffon", 0xfffacd},
                              {"lightblue", 0xadd8e6},
                              {"lightcoral", 0xf08080},
                              {"lightcyan", 0xe0ffff},
                              {"lightgoldenrodyellow", 0xfafad2},
                              {"lightgray", 0xd3d3d3},
                              {"lightgreen", 0x90ee90},
                              {"lightgrey", 0xd3d3d3},
                              {"lightpink", 0xffb6c1},
                              {"lightsalmon", 0xffa07a},
                              {"lightseagreen", 0x20b2aa},
                              {"lightskyblue", 0x87cefa},
                              {"lightslategray", 0x778899},
                              {"lightslategrey", 0x778899},
                              {"lightsteelblue", 0xb0c4de},
                              {"lightyellow", 0xffffe0},
                              {"lime", 0x00ff00},
                              {"limegreen", 0x32cd32},
                              {"linen", 0xfaf0e6},
                              {"magenta", 0xff00ff},
                              {"maroon", 0x800000},
                              {"mediumaquamarine", 0x66cdaa},
                              {"mediumblue", 0x0000cd},
                              {"mediumorchid", 0xba55d3},
                              {"mediumpurple", 0x9370db},
                              {"mediumseagreen", 0x3cb371},
                              {"mediumslateblue", 0x7b68ee},
                              {"mediumspringgreen", 0x00fa9a},
                              {"mediumturquoise", 0x48d1cc},
                              {"mediumvioletred", 0xc71585},
                              {"midnightblue", 0x191970},
                              {"mintcream", 0xf5fffa},
                              {"mistyrose", 0xffe4e1},
                              {"moccasin", 0xffe4b5},
                              {"navajowhite", 0xffdead},
                              {"navy", 0x000080},
                              {"oldlace", 0xfdf5e6},
                              {"olive", 0x808000},
                              {"olivedrab", 0x6b8e23},
                              {"orange", 0xffa500},
                              {"orangered", 0xff4500},
                              {"orchid", 0xda70d6},
                              {"palegoldenrod", 0xeee8aa},
                              {"palegreen", 0x98fb98},
                              {"paleturquoise", 0xafeeee},
                              {"palevioletred", 0xdb7093},
                              {"papayawhip", 0xffefd5},
                              {"peachpuff", 0xffdab9},
                              {"peru", 0xcd853f},
                              {"pink", 0xffc0cb},
                              {"plum", 0xdda0dd},
                              {"powderblue", 0xb0e0e6},
                              {"purple", 0x800080},
                              {"rebeccapurple", 0x663399},
                              {"red", 0xff0000},
                              {"rosybrown", 0xbc8f8f},
                              {"royalblue", 0x4169e1},
                              {"saddlebrown", 0x8b4513},
                              {"salmon", 0xfa8072},
                              {"sandybrown", 0xf4a460},
                              {"seagreen", 0x2e8b57},
                              {"seashell", 0xfff5ee},
                              {"sienna", 0xa0522d},
                              {"silver", 0xc0c0c0},
                              {"skyblue", 0x87ceeb},
                              {"slateblue", 0x6a5acd},
                              {"slategray", 0x708090},
                              {"slategrey", 0x708090},
                              {"snow", 0xfffafa},
                              {"springgreen", 0x00ff7f},
                              {"steelblue", 0x4682b4},
                              {"tan", 0xd2b48c},
                              {"teal", 0x008080},
                              {"thistle", 0xd8bfd8},
                              {"tomato", 0xff6347},
                              {"turquoise", 0x40e0d0},
                              {"violet", 0xee82ee},
                              {"wheat", 0xf5deb3},
                              {"white", 0xffffff},
                              {"whitesmoke", 0xf5f5f5},
                              {"yellow", 0xffff00},
                              {"yellowgreen", 0x9acd32}};

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

static uint32_t channel(double value) {
    if (!(value > 0)) return 0;
    return value >= 255 ? 255 : (uint32_t)floor(value + 0.5);
}

static bool hexadecimal(const char *text, uint32_t *colour) {
    uint32_t v = 0;
    size_t n = strlen(text);
    if (n != 3 && n != 4 && n != 6 && n != 8) return false;
    for (size_t i = 0; i < n; i++) {
        char c = text[i];
        int digit = c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
        if (digit < 0) return false;
        v = v << 4 | (uint32_t)digit;
        if (n <= 4) v = v << 4 | (uint32_t)digit;
    }
    *colour = n == 3 || n == 6 ? v << 8 | 0xff : v;
    return true;
}

/* CSS Color 4, 7.1; hue in degrees, the rest 0..1. */
static double hsl_channel(double n, double hue, double saturation, double light) {
    double k = fmod(n + hue / 30, 12);
    return light - saturation * fmin(light, 1 - light) * fmax(-1, fmin(fmin(k - 3, 9 - k), 1));
}

static bool function(const char *text, bool hsl, uint32_t *colour) {
    const char *at = text, *end = text + strlen(text);
    double v[4] = {0, 0, 0, 1};
    int n = 0;
    while (at < end && is_space(*at)) at++;
    while (at < end && *at != ')') {
        if (n == 4) return false;
        at = bat_number_scan(at, end, &v[n]);
        if (!at || !isfinite(v[n])) return false;
        bool percent = at < end && *at == '%';
        if (percent) at++;
        if (hsl && n == 0 && end - at >= 3 && strncmp(at, "deg", 3) == 0) at += 3;
        if (n == 3 ? percent : hsl && n > 0) v[n] /= 100;
        if (!hsl && n < 3 && percent) v[n] = v[n] * 255 / 100;
        n++;
        while (at < end && (is_space(*at) || *at == ',' || *at == '/')) at++;
    }
    if (at == end || n < 3) return false;
    if (hsl) {
        double hue = fmod(v[0], 360), s = fmin(fmax(v[1], 0), 1), l = fmin(fmax(v[2], 0), 1);
        if (hue < 0) hue += 360;
        v[0] = 255 * hsl_channel(0, hue, s, l);
        v[1] = 255 * hsl_channel(8, hue, s, l);
        v[2] = 255 * hsl_channel(4, hue, s, l);
    }
    *colour = channel(v[0]) << 24 | channel(v[1]) << 16 | channel(v[2]) << 8 | channel(255 * v[3]);
    return true;
}

bool bat_svg_colour(const char *text, uint32_t *colour) {
    char lower[96];
    size_t n = 0;
    while (is_space(*text)) text++;
    for (; text[n] && n + 1 < sizeof lower; n++)
        lower[n] = text[n] >= 'A' && text[n] <= 'Z' ? (char)(text[n] - 'A' + 'a') : text[n];
    if (text[n]) return false;
    while (n > 0 && is_space(lower[n - 1])) n--;
    lower[n] = '\0';
    if (lower[0] == '#') {
        char *space = strchr(lower, ' '); /* an icc-color() may follow */
        if (space) *space = '\0';
        return hexadecimal(lower + 1, colour);
    }
    if (strncmp(lower, "rgb(", 4) == 0) return function(lower + 4, false, colour);
    if (strncmp(lower, "rgba(", 5) == 0) return function(lower + 5, false, colour);
    if (strncmp(lower, "hsl(", 4) == 0) return function(lower + 4, true, colour);
    if (strncmp(lower, "hsla(", 5) == 0) return function(lower + 5, true, colour);
    if (strcmp(lower, "transparent") == 0) {
        *colour = 0;
        return true;
    }
    size_t low = 0, high = sizeof names / sizeof *names;
    while (low < high) {
        size_t middle = (low + high) / 2;
        int order = strcmp(lower, names[middle].name);
        if (order == 0) {
            *colour = names[middle].rgb << 8 | 0xff;
            return true;
        }
        if (order < 0)
            high = middle;
        else
            low = middle + 1;
    }
    return false;
}
