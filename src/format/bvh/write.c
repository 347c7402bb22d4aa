/* BVH, written: numbers with as many digits as it takes to read them back bit for bit. */
#include "text/text.h"

#include <batten/format.h>
#include <batten/motion.h>

#include <stdlib.h>

static void indent(bat_text *text, int depth) {
    for (int i = 0; i < depth; i++) bat_text_string(text, "\t");
}

static void put_head(bat_text *text, const bat_bone *joint, int depth) {
    static const char *const names[] = {"Xposition", "Yposition", "Zposition",
                                        "Xrotation", "Yrotation", "Zrotation"};
    indent(text, depth);
    bat_text_string(text, joint->end ? "End " : joint->parent < 0 ? "ROOT " : "JOINT ");
    bat_text_string(text, joint->end ? "Site" : joint->name);
    bat_text_string(text, "\n");
    indent(text, depth), bat_text_string(text, "{\n");
    indent(text, depth + 1), bat_text_string(text, "OFFSET");
    for (int k = 0; k < 3; k++) bat_text_string(text, " "), bat_text_number(text, joint->offset[k]);
    bat_text_string(text, "\n");
    if (joint->end) return;
    indent(text, depth + 1), bat_text_string(text, "CHANNELS ");
    bat_text_integer(text, (uint64_t)joint->channel_count);
    for (int k = 0; k < joint->channel_count; k++)
        bat_text_string(text, " "), bat_text_string(text, names[joint->channels[k]]);
    bat_text_string(text, "\n");
}

/* Closes joints down to that depth. */
static void close(bat_text *text, int *depth, int to) {
    for (; *depth > to; --*depth) indent(text, *depth - 1), bat_text_string(text, "}\n");
}

static void put_frames(bat_text *text, const bat_take *take) {
    size_t frames, channels;
    const double *values = bat_take_values(take, &frames, &channels);
    bat_text_string(text, "MOTION\nFrames: ");
    bat_text_integer(text, frames);
    bat_text_string(text, "\nFrame Time: ");
    bat_text_number(text, bat_take_frame_time(take));
    for (size_t i = 0; i < frames; i++) {
        for (size_t k = 0; k < channels; k++) {
            bat_text_string(text, k > 0 ? " " : "\n");
            bat_text_number(text, values[i * channels + k]);
        }
    }
    bat_text_string(text, "\n");
}

/* The children of a joint follow it in the order of the list, each with all that hangs on it: BVH has no other order. */
bat_status bat_bvh_write(const bat_take *take, char **bytes, size_t *size) {
    int count, depth = 0;
    if (!take || !bytes || !size) return BAT_ARGUMENT;
    const bat_bone *joints = bat_take_joints(take, &count);
    int *level = malloc((size_t)count * sizeof *level);
    bat_text text = {0};
    bat_status status = level ? BAT_OK : BAT_MEMORY;
    bat_text_string(&text, "HIERARCHY\n");
    for (int i = 0; i < count && status == BAT_OK; i++) {
        int open = i - 1; /* the parent is the joint before, or one that holds it */
        while (open >= 0 && open != joints[i].parent) open = joints[open].parent;
        if (i > 0 && open < 0) status = BAT_UNSUPPORTED;
        if (status != BAT_OK) break;
        level[i] = i > 0 ? level[open] + 1 : 0;
        close(&text, &depth, level[i]);
        put_head(&text, &joints[i], level[i]);
        depth = level[i] + 1;
    }
    close(&text, &depth, 0);
    free(level);
    if (status == BAT_OK) put_frames(&text, take);
    if (status == BAT_OK) return bat_text_finish(&text, bytes, size);
    bat_text_free(&text);
    return status;
}
