/* BVH, read: a skeleton as nested joints, then the numbers of each frame. Words may stand on any lines. */
#include "text/json.h"
#include "text/number.h"
#include "text/utf8.h"

#include <batten/format.h>
#include <batten/motion.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CHANNELS = 6, SHOWN = 24, STEP = 64 };
static const char *const NAMES[CHANNELS] = {"Xposition", "Yposition", "Zposition",
                                            "Xrotation", "Yrotation", "Zrotation"};
static const char EXPECTED_CHANNEL[] =
    "Xposition, Yposition, Zposition, Xrotation, Yrotation or Zrotation, each once";

typedef struct reader {
    const char *at, *end;
    long line; /* of `at`, from 1 */
    const char *word;
    size_t size; /* of the word; 0: the end */
    long word_line;
    bat_problem *problem;
    bat_bone *joints;
    char **names; /* owned */
    int count, room;
} reader;

/* ---- words ---- */

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

static void next(reader *r) {
    while (r->at < r->end && is_blank(*r->at)) r->line += *r->at++ == '\n';
    r->word = r->at, r->word_line = r->line;
    while (r->at < r->end && !is_blank(*r->at)) r->at++;
    r->size = (size_t)(r->at - r->word);
}

/* "line 12", "expected ..., found ...". */
static bat_status complain(const reader *r, bat_status status, const char *expected) {
    char place[48], message[160], shown[SHOWN + 4];
    size_t n = r->size < SHOWN ? r->size : SHOWN;
    for (size_t i = 0; i < n; i++)
        shown[i] = (char)(r->word[i] >= ' ' && r->word[i] <= '~' ? r->word[i] : '?');
    snprintf(shown + n, sizeof shown - n, "%s", r->size > SHOWN ? "..." : "");
    snprintf(place, sizeof place, "line %ld", r->word_line);
    if (r->size)
        snprintf(message, sizeof message, "expected %s, found '%s'", expected, shown);
    else
        snprintf(message, sizeof message, "expected %s, found the end", expected);
    return bat_problem_set(r->problem, status, place, message);
}

static bool is(const reader *r, const char *word) {
    if (strlen(word) != r->size) return false;
    for (size_t i = 0; i < r->size; i++) {
        const char a = r->word[i], b = word[i];
        if (a != b && !(a >= 'A' && a <= 'Z' && a + ('a' - 'A') == b) &&
            !(a >= 'a' && a <= 'z' && a - ('a' - 'A') == b))
            return false;
    }
    return true;
}

static bat_status expect(reader *r, const char *word) {
    if (!is(r, word)) return complain(r, BAT_SYNTAX, word);
    next(r);
    return BAT_OK;
}

static bat_status number(reader *r, const char *expected, double *out) {
    if (r->size == 0 || bat_number_scan(r->word, r->word + r->size, out) != r->word + r->size)
        return complain(r, BAT_SYNTAX, expected);
    if (!(fabs(*out) <= BAT_COORDINATE_MAX)) return complain(r, BAT_NUMBER, "a number up to 1e75");
    next(r);
    return BAT_OK;
}

static bat_status whole(reader *r, const char *expected, double most, double *out) {
    const reader before = *r;
    const bat_status status = number(r, expected, out);
    if (status == BAT_OK && (!(*out >= 0 && *out <= most) || *out != floor(*out)))
        return complain(&before, BAT_SYNTAX, expected);
    return status;
}

/* ---- the skeleton ---- */

/* The rest of the line is the name, which may hold blanks. */
static bat_status name_of(reader *r, char **out) {
    while (r->at < r->end && (*r->at == ' ' || *r->at == '\t')) r->at++;
    const char *from = r->at;
    while (r->at < r->end && *r->at != '\n' && *r->at != '\r' && *r->at != '{') r->at++;
    const char *to = r->at;
    while (to > from && is_blank(to[-1])) to--;
    if (memchr(from, '\0', (size_t)(to - from))) return complain(r, BAT_SYNTAX, "a name without NUL");
    *out = malloc((size_t)(to - from) + 1);
    if (!*out) return bat_problem_set(r->problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
    memcpy(*out, from, (size_t)(to - from));
    (*out)[to - from] = '\0';
    if (!bat_utf8_valid(*out, (size_t)(to - from))) return complain(r, BAT_SYNTAX, "a name in UTF-8");
    next(r);
    return BAT_OK;
}

static bat_status grow(reader *r) {
    if (r->count < r->room) return BAT_OK;
    if (r->room >= BAT_JOINTS_MAX) return complain(r, BAT_COUNT, "10000 joints at most");
    const int room = r->room + STEP > BAT_JOINTS_MAX ? BAT_JOINTS_MAX : r->room * 2 + STEP;
    bat_bone *joints = realloc(r->joints, (size_t)room * sizeof *joints);
    if (joints) r->joints = joints;
    char **names = joints ? realloc(r->names, (size_t)room * sizeof *names) : NULL;
    if (!names) return bat_problem_set(r->problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
    r->names = names, r->room = room;
    return BAT_OK;
}

static bat_status read_channels(reader *r, bat_bone *joint) {
    double count = 0;
    unsigned seen = 0;
    bat_status status = expect(r, "CHANNELS");
    if (status == BAT_OK) status = whole(r, "a number of channels from 0 to 6", CHANNELS, &count);
    for (int k = 0; status == BAT_OK && k < (int)count; k++) {
        int c = 0;
        while (c < CHANNELS && !is(r, NAMES[c])) c++;
        if (c == CHANNELS || (seen & 1u << c)) return complain(r, BAT_SYNTAX, EXPECTED_CHANNEL);
        seen |= 1u << c;
        joint->channels[k] = (bat_channel)c;
        next(r);
    }
    if (status == BAT_OK) joint->channel_count = (int)count;
    return status;
}

/* From its word (ROOT, JOINT or End) to what follows the channels. */
static bat_status read_joint(reader *r, int parent, bool end) {
    bat_status status = grow(r);
    if (status != BAT_OK) return status;
    if (!r->joints || !r->names) return BAT_STATE; /* never: there is room for one more */
    const int own = r->count;
    bat_bone *joint = &r->joints[own];
    *joint = (bat_bone){.parent = parent, .end = end};
    r->names[own] = NULL;
    r->count++;
    status = name_of(r, &r->names[own]);
    if (status == BAT_OK) status = expect(r, "{");
    if (status == BAT_OK) status = expect(r, "OFFSET");
    for (int k = 0; k < 3 && status == BAT_OK; k++)
        status = number(r, "an offset of 3 numbers", &joint->offset[k]);
    if (status == BAT_OK && !end) status = read_channels(r, joint);
    return status;
}

static bat_status read_skeleton(reader *r) {
    bat_status status = expect(r, "HIERARCHY");
    if (status == BAT_OK && !is(r, "ROOT")) return complain(r, BAT_SYNTAX, "ROOT");
    if (status == BAT_OK) status = read_joint(r, -1, false);
    for (int open = 0; open >= 0 && status == BAT_OK;) {
        if (is(r, "}")) {
            open = r->joints[open].parent;
            next(r);
        } else if (!r->joints[open].end && (is(r, "JOINT") || is(r, "End"))) {
            status = read_joint(r, open, is(r, "End"));
            open = r->count - 1;
        } else {
            status = complain(r, BAT_SYNTAX, r->joints[open].end ? "}" : "JOINT, End Site or }");
        }
    }
    return status;
}

/* ---- the frames ---- */

/* "Frames:" and the like, with or without a blank before the colon. */
static bat_status expect_label(reader *r, const char *word) {
    const size_t size = strlen(word);
    const char *const from = r->word;
    const size_t whole_size = r->size;
    if (r->size > size) r->size = size;
    if (!is(r, word)) {
        r->size = whole_size;
        return complain(r, BAT_SYNTAX, word);
    }
    r->at = from + size;
    return BAT_OK;
}

static bat_status expect_colon(reader *r) {
    next(r);
    if (r->size == 0 || *r->word != ':') return complain(r, BAT_SYNTAX, "a colon");
    r->at = r->word + 1;
    next(r);
    return BAT_OK;
}

static bat_status read_frames(reader *r, bat_take **out) {
    double frames = 0, time = 0;
    size_t channels = 0;
    bat_status status = expect(r, "MOTION");
    if (status == BAT_OK) status = expect_label(r, "Frames");
    if (status == BAT_OK) status = expect_colon(r);
    for (int i = 0; i < r->count; i++) channels += (size_t)r->joints[i].channel_count;
    if (status == BAT_OK) {
        const reader before = *r;
        status = whole(r, "a number of frames above 0", 1e9, &frames);
        if (status == BAT_OK && (frames < 1 || frames > (double)BAT_POINTS_MAX ||
                                 frames * (double)(channels + 1) > (double)BAT_TAKE_NUMBERS_MAX))
            return complain(&before, BAT_COUNT, "a number of frames above 0, and fewer than 5e7 numbers");
    }
    if (status == BAT_OK) status = expect(r, "Frame");
    if (status == BAT_OK) status = expect_label(r, "Time");
    if (status == BAT_OK) status = expect_colon(r);
    const reader timed = *r;
    if (status == BAT_OK) status = number(r, "the time of a frame in seconds", &time);
    if (status == BAT_OK && !(time > 0 && time <= 1e9))
        return complain(&timed, BAT_SYNTAX, "the time of a frame in seconds, above 0");
    if (status != BAT_OK) return status;
    const size_t all = (size_t)frames * channels;
    if (all > (size_t)(r->end - r->at) +
                  1) { /* each number takes a letter: so no file asks for more memory than its size */
        const reader last = {.word_line = r->word_line, .problem = r->problem};
        return complain(&last, BAT_COUNT, "as many numbers as frames and channels");
    }
    double *values = malloc((all + 1) * sizeof *values);
    if (!values) return bat_problem_set(r->problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
    for (size_t i = 0; i < all && status == BAT_OK; i++)
        status = number(r, "a number for each channel", &values[i]);
    if (status == BAT_OK && r->size > 0) status = complain(r, BAT_SYNTAX, "the end after the last frame");
    if (status == BAT_OK) {
        status = bat_take_create(r->count, r->joints, (size_t)frames, time, values, out);
        if (status != BAT_OK) bat_problem_set(r->problem, status, "", bat_status_message(status));
    }
    free(values);
    return status;
}

bat_status bat_bvh_read(const char *text, size_t size, bat_take **out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    reader r = {.at = text, .end = text + size, .line = 1, .problem = problem};
    if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) r.at += 3;
    next(&r);
    bat_status status = read_skeleton(&r);
    for (int i = 0; i < r.count; i++)
        if (r.names[i]) r.joints[i].name = r.names[i];
    if (status == BAT_OK) status = read_frames(&r, out);
    for (int i = 0; i < r.count; i++) free(r.names[i]);
    free(r.names), free(r.joints);
    return status;
}
