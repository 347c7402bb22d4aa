/* What an SVG reader left out, in English. */
#include <batten/format.h>

#include <stdio.h>
#include <string.h>

static const struct {
    const char *one, *many;
} names[BAT_LOSS_COUNT] = {
    [BAT_LOSS_TEXT] = {"text", "texts"},
    [BAT_LOSS_IMAGE] = {"image", "images"},
    [BAT_LOSS_GRADIENT] = {"gradient", "gradients"},
    [BAT_LOSS_PATTERN] = {"pattern", "patterns"},
    [BAT_LOSS_CLIP] = {"clip", "clips"},
    [BAT_LOSS_MASK] = {"mask", "masks"},
    [BAT_LOSS_FILTER] = {"filter", "filters"},
    [BAT_LOSS_MARKER] = {"line with markers", "lines with markers"},
    [BAT_LOSS_DASH] = {"dashed stroke", "dashed strokes"},
    [BAT_LOSS_ORDER] = {"paint order", "paint orders"},
    [BAT_LOSS_EFFECT] = {"stroke that does not scale", "strokes that do not scale"},
    [BAT_LOSS_UNEVEN] = {"unevenly scaled stroke", "unevenly scaled strokes"},
    [BAT_LOSS_BLEND] = {"blend mode", "blend modes"},
    [BAT_LOSS_OPACITY] = {"transparent group", "transparent groups"},
    [BAT_LOSS_HINT] = {"rendering hint", "rendering hints"},
    [BAT_LOSS_COPY] = {"linked copy", "linked copies"},
    [BAT_LOSS_NESTED] = {"nested drawing", "nested drawings"},
    [BAT_LOSS_SWITCH] = {"conditional part", "conditional parts"},
    [BAT_LOSS_INVISIBLE] = {"invisible thing", "invisible things"},
    [BAT_LOSS_BROKEN] = {"broken part", "broken parts"},
    [BAT_LOSS_UNKNOWN] = {"unknown element or attribute", "unknown elements or attributes"},
    [BAT_LOSS_TITLE] = {"title or description", "titles or descriptions"},
    [BAT_LOSS_LINK] = {"link", "links"},
    [BAT_LOSS_ANIMATION] = {"animation", "animations"},
    [BAT_LOSS_SCRIPT] = {"script", "scripts"},
    [BAT_LOSS_EMBEDDED] = {"embedded page or medium", "embedded pages or media"},
    [BAT_LOSS_UNUSED] = {"unused definition", "unused definitions"},
    [BAT_LOSS_METADATA] = {"block of metadata", "blocks of metadata"},
    [BAT_LOSS_FOREIGN] = {"setting of another program", "settings of other programs"},
    [BAT_LOSS_RULE] = {"style rule", "style rules"},
    [BAT_LOSS_PAGE] = {"page size", "page sizes"},
    [BAT_LOSS_NATIVE] = {"older Batten document", "older Batten documents"},
};

void bat_loss_words(bat_loss kind, int count, char *words, size_t room) {
    if (!words || room == 0) return;
    const char *name = (unsigned)kind >= BAT_LOSS_COUNT ? ""
                       : count == 1                     ? names[kind].one
                                                        : names[kind].many;
    int size = snprintf(words, room, "%d %s", count, name);
    if (!*name || (size_t)size >= room) *words = '\0';
}

void bat_svg_report_line(const bat_svg_report *report, char *line, size_t room) {
    if (!report || !line || room == 0) return;
    const char *before = "Left out: ";
    size_t used = 0;
    line[0] = '\0';
    for (int i = 0; i < BAT_LOSS_COUNT; i++) {
        char words[64];
        int count = report->lost.count[i];
        if (count == 0 || i == BAT_LOSS_NATIVE) continue; /* it has its own sentence */
        bat_loss_words((bat_loss)i, count, words, sizeof words);
        if (used < room) snprintf(line + used, room - used, "%s%s", before, words);
        used = strlen(line);
        before = ", ";
    }
    if (used > 0) snprintf(line + used, room - used, ".");
    used = strlen(line);
    const int changed = report->lost.count[BAT_LOSS_NATIVE];
    if (report->edited && report->native)
        snprintf(
            line + used, room - used,
            "%s%d object%s changed by another program since Batten saved the file: read from the drawing.",
            used ? " " : "", changed, changed == 1 ? " was" : "s were");
    else if (report->edited)
        snprintf(line + used, room - used,
                 "%sChanged by another program since Batten saved it: the drawing counts.", used ? " " : "");
}
