/* A skeleton and its motion. Its curves show it: the bones as lines, as they are in the first frame, or at the time that
 * it stands at. */
#include "base/pose.h"
#include "base/users.h"
#include "base/vec.h"
#include "curve/curve.h"
#include "document/digest.h"
#include "document/digest_camera.h"
#include "form/motion/motion.h"
#include "format/json/fields.h"
#include "format/json/motion.h"
#include "format/json/style.h"
#include "hands/levels/shape.h"
#include "kinds/kinds.h"
#include "text/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PLACE = 12 };
/* y of the page runs down, and y of a motion up. */
static const double UPRIGHT[PLACE] = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0};

/* The object's own part: a reference-counted value, shared by copies of the object. */
typedef struct kept_motion {
    bat_users users;
    bat_motion *motion;
    uint64_t digest;
    double place[PLACE];
} kept_motion;

typedef struct own_part {
    kept_motion *kept;
    bat_id follows; /* the object whose first curve the root's path lies over; 0: the path is its own */
    double time;    /* seconds, at which it stands; of nothing that is kept in files */
} own_part;

static const own_part *part_of(const void *own) { return own; }

static void share(const void *own) { bat_users_add(&part_of(own)->kept->users); }
static void end(void *own) {
    kept_motion *kept = part_of(own)->kept;
    if (!kept || !bat_users_drop(&kept->users)) return;
    bat_motion_free(kept->motion);
    free(kept);
}

/* ---- lines ---- */

static void put_in(const double place[PLACE], const double *from, double *to) {
    for (int k = 0; k < 3; k++)
        to[k] = place[4 * k] * from[0] + place[4 * k + 1] * from[1] + place[4 * k + 2] * from[2] +
                place[4 * k + 3];
}

static bat_status polyline(size_t count, const double *points, bat_curve **out) {
    double *knots = malloc((count + 2) * sizeof *knots);
    if (!knots) return BAT_MEMORY;
    for (size_t i = 0; i < count; i++) knots[i + 1] = (double)i;
    knots[0] = 0, knots[count + 1] = (double)(count - 1);
    const bat_status status = bat_curve_create(3, 1, false, count, points, (int)count + 2, knots, out);
    free(knots);
    return status;
}

/* One line for each joint that does not go on with its parent's: bones end to end, each joint going on to the first of its
 * children. line[i]: which line joint i is the next point of. Returns how many there are. */
static int lines_of(const bat_bone *joints, int count, int *line, bool *gone_on) {
    int lines = 1;
    line[0] = 0;
    for (int i = 0; i < count; i++) gone_on[i] = false;
    for (int i = 1; i < count; i++) {
        const int parent = joints[i].parent;
        line[i] = gone_on[parent] ? lines++ : line[parent];
        gone_on[parent] = true;
    }
    return lines;
}

/* The points of a line, which begins at the parent of its first joint; a lone joint is a line without length. */
static size_t gather(const bat_bone *joints, int count, const int *line, int which, const double *at,
                     double *out) {
    size_t n = 0;
    for (int i = 0; i < count; i++) {
        if (line[i] != which) continue;
        if (n == 0 && i > 0) memcpy(out + 3 * n++, at + (ptrdiff_t)3 * joints[i].parent, 3 * sizeof *out);
        memcpy(out + 3 * n++, at + (ptrdiff_t)3 * i, 3 * sizeof *out);
    }
    if (n == 1) memcpy(out + 3 * n++, out, 3 * sizeof *out);
    return n;
}

/* *count lines, which the caller frees; on failure none are left. */
static bat_status curves_of(const kept_motion *kept, double time, bat_curve ***out, int *count) {
    int joints;
    const bat_bone *bones = bat_take_joints(bat_motion_take(kept->motion), &joints);
    const size_t size = (size_t)(unsigned)joints; /* 1 to BAT_JOINTS_MAX */
    double *at = malloc(3 * size * sizeof *at), *points = malloc(3 * (size + 1) * sizeof *points);
    int *line = malloc(size * sizeof *line);
    bool *gone_on = malloc(size * sizeof *gone_on);
    bat_curve **curves = malloc(size * sizeof *curves);
    bat_status status = at && points && line && gone_on && curves
                            ? bat_motion_positions(kept->motion, time, at)
                            : BAT_MEMORY;
    int made = 0;
    const int lines = status == BAT_OK ? lines_of(bones, joints, line, gone_on) : 0;
    for (int i = 0; i < joints && status == BAT_OK; i++) {
        double placed[3];
        put_in(kept->place, at + (ptrdiff_t)3 * i, placed);
        memcpy(at + (ptrdiff_t)3 * i, placed, sizeof placed);
    }
    while (made < lines && status == BAT_OK) {
        status = polyline(gather(bones, joints, line, made, at, points), points, &curves[made]);
        made += status == BAT_OK;
    }
    free(at), free(points), free(line), free(gone_on);
    if (status == BAT_OK) {
        *out = curves, *count = lines;
        return BAT_OK;
    }
    while (made > 0) bat_curve_free(curves[--made]);
    free(curves);
    return status;
}

/* ---- making ---- */

static uint64_t digest_numbers(uint64_t digest, const double *numbers, size_t count) {
    for (size_t i = 0; i < count; i++) digest = bat_digest_double(digest, numbers[i]);
    return digest;
}

static uint64_t digest_take(uint64_t digest, const bat_take *take) {
    digest = bat_digest_number(digest, (uint64_t)take->joint_count);
    for (int i = 0; i < take->joint_count; i++) {
        const bat_bone *joint = &take->joints[i];
        for (const char *c = joint->name; *c; c++) digest = bat_digest_number(digest, (unsigned char)*c);
        digest = bat_digest_number(digest, (uint64_t)(joint->parent + 1) << 4 | (unsigned)joint->end << 3 |
                                               (unsigned)joint->channel_count);
        for (int k = 0; k < joint->channel_count; k++)
            digest = bat_digest_number(digest, (uint64_t)joint->channels[k]);
        digest = digest_numbers(digest, joint->offset, 3);
    }
    digest = bat_digest_number(bat_digest_double(digest, take->frame_time), take->frames);
    return digest_numbers(digest, take->values, take->frames * take->channels);
}

static uint64_t digest_shape(uint64_t digest, const bat_shape *shape) {
    if (!shape) return bat_digest_number(digest, 0);
    digest = bat_digest_number(digest, (uint64_t)bat_shape_levels(shape) + 1);
    digest = bat_digest_curve(digest, bat_shape_curve(shape, 0));
    digest = bat_digest_curve(digest, bat_shape_curve(shape, bat_shape_levels(shape)));
    for (int l = 1; l <= bat_shape_levels(shape); l++) {
        digest = bat_digest_double(digest, bat_shape_gain(shape, l));
        digest = bat_digest_number(digest, bat_shape_is_muted(shape, l));
    }
    return digest;
}

static uint64_t digest_of(const kept_motion *kept) {
    const bat_motion *m = kept->motion;
    uint64_t digest = digest_take(bat_digest_begin(), m->take);
    digest = bat_digest_number(digest, (uint64_t)m->levels);
    for (int i = 0; i < m->take->joint_count; i++)
        if (m->joints[i]) digest = bat_digest_camera(digest, m->joints[i]);
    digest = digest_shape(digest_shape(digest, m->first), m->bent);
    return digest_numbers(digest, kept->place, PLACE);
}

/* Makes a new object, or a copy of `object` with another motion, which is taken over on success. */
static bat_status make(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                       bat_motion *motion, const double place[PLACE], bat_id follows, bat_object **out) {
    own_part own = {.kept = calloc(1, sizeof *own.kept), .follows = follows};
    bat_curve **curves = NULL;
    int count = 0;
    if (!own.kept) return BAT_MEMORY;
    *own.kept = (kept_motion){.users = BAT_USERS_ONE, .motion = motion};
    memcpy(own.kept->place, place, sizeof own.kept->place);
    own.kept->digest = digest_of(own.kept);
    bat_status status = curves_of(own.kept, 0, &curves, &count);
    if (status == BAT_OK)
        status = object ? bat_object_remake(object, &bat_kind_of_skeleton, &own, count, curves, out)
                        : bat_object_make(&bat_kind_of_skeleton, id, name, style, &own, count, curves, out);
    for (int i = 0; i < count && status != BAT_OK; i++) bat_curve_free(curves[i]);
    free(curves);
    if (status != BAT_OK) free(own.kept);
    return status;
}

static bat_id followed(const bat_object *object) {
    return part_of(bat_object_own(object, &bat_kind_of_skeleton))->follows;
}

static bat_status make_of_copy(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                               const bat_motion *motion, const double place[PLACE], bat_object **out) {
    const bat_id follows = object ? followed(object) : 0;
    bat_motion *copy = NULL;
    bat_status status = bat_motion_copy(motion, &copy);
    if (status == BAT_OK) status = make(object, id, name, style, copy, place, follows, out);
    if (status != BAT_OK) bat_motion_free(copy);
    return status;
}

bat_status bat_object_create_skeleton(bat_id id, const char *name, const bat_style *style,
                                      const bat_motion *motion, const double *place, bat_object **out) {
    if (!style || !motion || !out) return BAT_ARGUMENT;
    for (int i = 0; place && i < PLACE; i++)
        if (!(fabs(place[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    return make_of_copy(NULL, id, name, style, motion, place ? place : UPRIGHT, out);
}

bat_status bat_object_with_motion(const bat_object *object, const bat_motion *motion, bat_object **out) {
    double place[PLACE];
    if (!object || !motion || !out || !bat_object_motion(object, place)) return BAT_ARGUMENT;
    return make_of_copy(object, 0, NULL, NULL, motion, place, out);
}

/* A copy with the same motion, in which only these differ. */
static bat_status vary(const bat_object *object, bat_id follows, double time, bat_object **out) {
    const own_part own = {.kept = part_of(bat_object_own(object, &bat_kind_of_skeleton))->kept,
                          .follows = follows,
                          .time = time};
    bat_curve **curves = NULL;
    int count = 0;
    bat_status status = curves_of(own.kept, time, &curves, &count);
    if (status != BAT_OK) return status;
    share(&own);
    status = bat_object_remake(object, &bat_kind_of_skeleton, &own, count, curves, out);
    for (int i = 0; i < count && status != BAT_OK; i++) bat_curve_free(curves[i]);
    free(curves);
    if (status != BAT_OK) bat_users_drop(&own.kept->users);
    return status;
}

bat_status bat_object_at_time(const bat_object *object, double seconds, bat_object **out) {
    if (!object || !out) return BAT_ARGUMENT;
    if (!isfinite(seconds)) return BAT_NUMBER;
    if (!bat_object_own(object, &bat_kind_of_skeleton)) return BAT_UNSUPPORTED;
    return vary(object, followed(object), seconds, out);
}

const bat_motion *bat_object_motion(const bat_object *object, double *place) {
    const void *own = bat_object_own(object, &bat_kind_of_skeleton);
    if (!own) return NULL;
    if (place) memcpy(place, part_of(own)->kept->place, sizeof UPRIGHT);
    return part_of(own)->kept->motion;
}

/* ---- what it follows ---- */

/* From the drawing to the motion's own axes; false: the place is flat. */
static bool inverse_of(const double place[PLACE], double out[PLACE]) {
    const vec row[3] = {
        {place[0], place[1], place[2]}, {place[4], place[5], place[6]}, {place[8], place[9], place[10]}};
    const double volume = vec_dot(row[0], vec_cross(row[1], row[2]));
    if (!(fabs(volume) > 0)) return false;
    for (int k = 0; k < 3; k++) {
        double column[3];
        vec_store(vec_scale(vec_cross(row[(k + 1) % 3], row[(k + 2) % 3]), 1 / volume), column);
        for (int i = 0; i < 3; i++) out[4 * i + k] = column[i];
    }
    for (int i = 0; i < 3; i++)
        out[4 * i + 3] = -(out[4 * i] * place[3] + out[4 * i + 1] * place[7] + out[4 * i + 2] * place[11]);
    return true;
}

/* A curve of the drawing in the motion's own axes. */
static bat_status bring_in(const double place[PLACE], const bat_curve *path, bat_curve **out) {
    double back[PLACE];
    bat_curve *space = NULL;
    if (!inverse_of(place, back)) return BAT_SINGULAR;
    bat_status status = bat_curve_to_dimension(path, 3, &space);
    if (status == BAT_OK) status = bat_curve_transform(space, back, out);
    bat_curve_free(space);
    return status;
}

/* *out: the motion over that path; NULL: it lies over it already. */
static bat_status bend(const kept_motion *kept, const bat_curve *path, bat_motion **out) {
    const bat_shape *bent = kept->motion->bent;
    bat_curve *own = NULL;
    *out = NULL;
    bat_status status = bring_in(kept->place, path, &own);
    const bool same = status == BAT_OK && bent && bat_curve_is_equal(bat_shape_curve(bent, 0), own);
    if (status == BAT_OK && !same) status = bat_motion_copy(kept->motion, out);
    if (status == BAT_OK && !same) status = bat_motion_bend(*out, own);
    bat_curve_free(own);
    if (status == BAT_OK) return BAT_OK;
    bat_motion_free(*out);
    *out = NULL;
    return status;
}

static bat_status follow(const bat_object *object, bat_id id, const bat_curve *path, bat_object **out) {
    const kept_motion *kept = part_of(bat_object_own(object, &bat_kind_of_skeleton))->kept;
    bat_motion *made = NULL;
    *out = NULL;
    bat_status status = path && id ? bend(kept, path, &made) : BAT_OK;
    if (status != BAT_OK && status != BAT_MEMORY) id = 0, status = BAT_OK; /* it can't: it lets go */
    if (status == BAT_OK && made)
        status = make(object, 0, NULL, NULL, made, kept->place, id, out);
    else if (status == BAT_OK && id != followed(object))
        status = vary(object, id, 0, out);
    if (status != BAT_OK) bat_motion_free(made);
    return status;
}

/* ---- what the document asks ---- */

static uint64_t digest(uint64_t digest, const void *own) {
    const own_part *part = part_of(own);
    if (part->follows) digest = bat_digest_number(digest, part->follows);
    return bat_digest_number(digest, part->kept->digest);
}

static const char *check(const bat_object *object) {
    bat_curve **curves = NULL;
    int count = 0;
    const own_part *own = part_of(bat_object_own(object, &bat_kind_of_skeleton));
    if (curves_of(own->kept, own->time, &curves, &count) != BAT_OK) return NULL;
    bool same = count == bat_object_curve_count(object);
    for (int i = 0; i < count; i++) {
        same = same && bat_curve_is_equal(curves[i], bat_object_curve(object, i));
        bat_curve_free(curves[i]);
    }
    free(curves);
    return same ? NULL : "the lines of a skeleton are not where its bones are";
}

static bat_status transform(const bat_object *object, const double rows[12], bat_object **out) {
    double place[PLACE] = {0};
    const bat_motion *motion = bat_object_motion(object, place);
    bat_pose_multiply(rows, place, place);
    return make_of_copy(object, 0, NULL, NULL, motion, place, out);
}

static bat_status read(const bat_fields *f, uint32_t node, bat_id id, const char *name, bat_object **out) {
    bat_style style = bat_style_defaults();
    bat_motion *motion = NULL;
    double place[PLACE];
    bat_id follows = 0;
    const uint32_t member = bat_json_member(f->json, node, "motion");
    bat_status status = bat_style_from_json(f, node, &style);
    if (status == BAT_OK) status = bat_fields_id(f, node, "follows", BAT_ID_MAX, &follows);
    if (status == BAT_OK && follows && follows == id)
        return bat_fields_complain(f, bat_json_member(f->json, node, "follows"), "follows", "another object");
    if (status == BAT_OK) status = bat_fields_numbers(f, node, "place", PLACE, "12 numbers", place);
    if (status == BAT_OK && !member) return bat_fields_complain(f, node, "motion", "an object");
    if (status == BAT_OK) status = bat_motion_from_json(f->json, member, &motion, f->problem);
    if (status != BAT_OK) return status;
    status = make(NULL, id, name, &style, motion, place, follows, out);
    if (status == BAT_OK) return BAT_OK;
    bat_motion_free(motion);
    return bat_fields_say(f, node, status);
}

static void write(const bat_object *object, bat_text *text) {
    double place[PLACE];
    const bat_motion *motion = bat_object_motion(object, place);
    if (followed(object)) {
        bat_text_string(text, ",\"follows\":");
        bat_text_integer(text, followed(object));
    }
    bat_text_string(text, ",\n  \"style\":");
    bat_style_to_json(bat_object_style(object), text);
    bat_text_string(text, ",\n  \"place\":[");
    for (int i = 0; i < PLACE; i++) {
        if (i) bat_text_string(text, ",");
        bat_text_number(text, place[i]);
    }
    bat_text_string(text, "],\n  \"motion\":");
    bat_motion_to_json(motion, text);
}

const bat_kind_type bat_kind_of_skeleton = {.number = BAT_KIND_SKELETON,
                                            .name = "skeleton",
                                            .traits = BAT_DRAWN | BAT_CURVES | BAT_MADE | BAT_FIXED |
                                                      BAT_SPACE | BAT_MOVES | BAT_NEW | BAT_STAYS,
                                            .size = sizeof(own_part),
                                            .share = share,
                                            .end = end,
                                            .check = check,
                                            .digest = digest,
                                            .transform = transform,
                                            .followed = followed,
                                            .follow = follow,
                                            .write = write,
                                            .read = read};
