/* What an SVG reader left out, in one line. */
#include <batten/format.h>

#include <stdio.h>
#include <string.h>

static void add(char *line, size_t room, int count, const char *one, const char *many, bool *any) {
    size_t used = strlen(line);
    if (count == 0 || used + 1 >= room) return;
    snprintf(line + used, room - used, "%s%d %s", *any ? ", " : "Left out: ", count, count == 1 ? one : many);
    *any = true;
}

void bat_svg_report_line(const bat_svg_report *report, char *line, size_t room) {
    if (!report || !line || room == 0) return;
    bool any = false;
    line[0] = '\0';
    add(line, room, report->skipped_text, "text", "texts", &any);
    add(line, room, report->skipped_images, "image", "images", &any);
    add(line, room, report->skipped_gradients, "gradient", "gradients", &any);
    add(line, room, report->skipped_clips, "clip or mask", "clips and masks", &any);
    add(line, room, report->skipped_other, "other", "others", &any);
    add(line, room, report->skipped_hidden, "hidden", "hidden", &any);
    add(line, room, report->broken_paths, "broken part", "broken parts", &any);
    size_t used = strlen(line);
    if (any) snprintf(line + used, room - used, ".");
    used = strlen(line);
    if (report->edited)
        snprintf(line + used, room - used,
                 "%sChanged by another program since Batten saved it: the drawing counts.", any ? " " : "");
}
