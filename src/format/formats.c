#include "format/formats.h"

#include "text/json.h"

#include <stdio.h>
#include <string.h>

#define FORMAT(name) extern const bat_format bat_format_of_##name;
#include "format/formats.def"
#undef FORMAT

static const bat_format *const formats[] = {
#define FORMAT(name) &bat_format_of_##name,
#include "format/formats.def"
#undef FORMAT
};

enum { COUNT = sizeof formats / sizeof *formats, SURE = 100 };

static char lower(char c) { return c >= 'A' && c <= 'Z' ? (char)(c + 32) : c; }

const bat_format *bat_format_named(const char *name) {
    for (int i = 0; i < COUNT; i++) {
        size_t k = 0;
        while (name[k] && lower(name[k]) == formats[i]->name[k]) k++;
        if (!name[k] && !formats[i]->name[k]) return formats[i];
    }
    return NULL;
}

const bat_format *bat_format_called(const char *file) {
    const char *slash = strrchr(file, '/'), *dot = strrchr(slash ? slash : file, '.');
    return dot ? bat_format_named(dot + 1) : NULL;
}

static const bat_format *surest(const char *text, size_t size, int least) {
    const bat_format *best = NULL;
    for (int i = 0; i < COUNT; i++) {
        int sure = formats[i]->sniff(text, size);
        if (sure < least) continue;
        best = formats[i];
        least = sure + 1;
    }
    return best;
}

const bat_format *bat_format_sniffed(const char *text, size_t size) { return surest(text, size, 1); }

bat_status bat_formats_read(const bat_reading *how, const char *text, size_t size, const bat_format **format,
                            bat_document **out, bat_svg_report *report, bat_problem *problem) {
    const bat_format *found = *format ? *format : bat_format_sniffed(text, size);
    *report = (bat_svg_report){0};
    if (*format && !found->keeps && found->sniff(text, size) == 0) {
        const bat_format *sure = surest(text, size, SURE);
        if (sure) found = sure;
    }
    if (!found)
        return bat_problem_set(problem, BAT_SYNTAX, "line 1, column 1",
                               size ? "expected SVG, JSON, OBJ, STL, glTF, 3MF, PLY, STEP, IGES, DXF, BVH or "
                                      "columns of numbers, found none of them"
                                    : "expected SVG, JSON, OBJ, STL, glTF, 3MF, PLY, STEP, IGES, DXF, BVH or "
                                      "columns of numbers, found nothing");
    *format = found;
    return found->read(how, text, size, out, report, problem);
}

void bat_formats_words(const char *before, bool keeps, char words[BAT_FORMATS_WORDS]) {
    const char *names[COUNT];
    int count = 0;
    size_t at = 0;
    for (int i = 0; i < COUNT; i++)
        if (formats[i]->keeps || !keeps) names[count++] = formats[i]->name;
    words[0] = '\0';
    for (int i = 0; i < count && at < BAT_FORMATS_WORDS; i++) {
        const char *between = i == 0 ? "" : i == count - 1 ? " or " : ", ";
        at += (size_t)snprintf(words + at, BAT_FORMATS_WORDS - at, "%s%s%s", between, before, names[i]);
    }
}
