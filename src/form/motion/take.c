/* Takes: what was recorded of a skeleton (docs/math/motion.md). */
#include "form/motion/take.h"
#include "text/json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool is_turn(bat_channel channel) { return channel >= BAT_X_ROTATION; }

int bat_bone_turns(const bat_bone *joint) {
    int count = 0;
    for (int k = 0; k < joint->channel_count; k++) count += is_turn(joint->channels[k]);
    return count;
}

int bat_bone_places(const bat_bone *joint) { return joint->channel_count - bat_bone_turns(joint); }

/* ---- making one ---- */

static bat_status check_channels(const bat_bone *j, size_t at, bat_problem *problem) {
    unsigned seen = 0;
    if (bat_problem_outside(problem, "joints[%zu].channel_count", at, 0, j->end ? 0 : BAT_CHANNELS_MAX,
                            j->channel_count))
        return BAT_ARGUMENT;
    for (int k = 0; k < j->channel_count; k++) {
        if ((unsigned)j->channels[k] > BAT_Z_ROTATION || (seen & 1u << j->channels[k]))
            return bat_problem_found(problem, BAT_ARGUMENT, "joints[%zu].channels", at, "each channel once",
                                     (double)j->channels[k]);
        seen |= 1u << j->channels[k];
    }
    return BAT_OK;
}

static bat_status check_joint(const bat_bone *joints, int i, bat_problem *problem) {
    const bat_bone *j = &joints[i];
    const size_t at = (size_t)i;
    if (!j->name)
        return bat_problem_set(problem, BAT_ARGUMENT, "joints", "expected a name of each, found none");
    if (bat_problem_outside(problem, "joints[%zu].parent", at, i == 0 ? -1 : 0, i - 1, j->parent))
        return BAT_ARGUMENT;
    if (i > 0 && joints[j->parent].end)
        return bat_problem_found(problem, BAT_ARGUMENT, "joints[%zu].parent", at, "one that is no end",
                                 j->parent);
    const bat_status status = check_channels(j, at, problem);
    for (int k = 0; k < 3 && status == BAT_OK; k++)
        if (bat_problem_outside(problem, "joints[%zu].offset", at, -BAT_COORDINATE_MAX, BAT_COORDINATE_MAX,
                                j->offset[k]))
            return BAT_NUMBER;
    return status;
}

static bat_status check_frames(size_t channels, size_t frames, double frame_time, const double *values,
                               bat_problem *problem) {
    const size_t room = BAT_TAKE_NUMBERS_MAX / (channels + 1),
                 most = room < BAT_POINTS_MAX ? room : BAT_POINTS_MAX;
    if (bat_problem_outside(problem, "frames", 0, 1, (double)most, (double)frames)) return BAT_COUNT;
    if (!(frame_time > 0))
        return bat_problem_found(problem, BAT_ARGUMENT, "frame_time", 0, "more than 0", frame_time);
    if (channels > 0 && !values)
        return bat_problem_set(problem, BAT_ARGUMENT, "values", "expected numbers, found none");
    if (bat_problem_outside(problem, "frame_time", 0, 0, 1e9, frame_time)) return BAT_NUMBER;
    for (size_t i = 0; i < frames * channels; i++)
        if (!(fabs(values[i]) <= BAT_COORDINATE_MAX))
            return bat_problem_found(problem, BAT_NUMBER, "values[%zu]", i, "-1e75 to 1e75", values[i]);
    return BAT_OK;
}

static bat_status check_take(int joint_count, const bat_bone *joints, size_t frames, double frame_time,
                             const double *values, size_t *channels, bat_problem *problem) {
    if (!joints) return bat_problem_set(problem, BAT_ARGUMENT, "joints", "expected joints, found none");
    if (bat_problem_outside(problem, "joints", 0, 1, BAT_JOINTS_MAX, joint_count)) return BAT_COUNT;
    *channels = 0;
    for (int i = 0; i < joint_count; i++) {
        const bat_status status = check_joint(joints, i, problem);
        if (status != BAT_OK) return status;
        *channels += (size_t)joints[i].channel_count;
    }
    return check_frames(*channels, frames, frame_time, values, problem);
}

bat_status bat_take_check(int joint_count, const bat_bone *joints, size_t frames, double frame_time,
                          const double *values, bat_problem *problem) {
    size_t channels;
    return check_take(joint_count, joints, frames, frame_time, values, &channels, problem);
}

void bat_take_free(bat_take *take) {
    if (!take || !bat_users_drop(&take->users)) return;
    free(take->joints), free(take->first), free(take->names), free(take->values);
    free(take);
}

bat_take *bat_take_share(const bat_take *take) {
    bat_users_add(&((bat_take *)take)->users);
    return (bat_take *)take;
}

static bat_status fill(bat_take *take, const bat_bone *joints, const double *values) {
    size_t room = 0, at = 0, channel = 0;
    const size_t count = (size_t)take->joint_count, numbers = take->frames * take->channels;
    for (size_t i = 0; i < count; i++) room += strlen(joints[i].name) + 1;
    take->joints = malloc(count * sizeof *joints);
    take->first = malloc(count * sizeof *take->first);
    take->names = malloc(room);
    take->values = malloc((numbers + 1) * sizeof *values);
    if (!take->joints || !take->first || !take->names || !take->values) return BAT_MEMORY;
    for (size_t i = 0; i < count; i++) {
        const size_t size = strlen(joints[i].name) + 1;
        take->joints[i] = joints[i];
        take->joints[i].name = memcpy(take->names + at, joints[i].name, size);
        take->first[i] = (int)channel;
        at += size, channel += (size_t)joints[i].channel_count;
    }
    if (numbers > 0) memcpy(take->values, values, numbers * sizeof *values);
    return BAT_OK;
}

bat_status bat_take_create(int joint_count, const bat_bone *joints, size_t frames, double frame_time,
                           const double *values, bat_take **out) {
    size_t channels;
    if (!out) return BAT_ARGUMENT;
    bat_status status = check_take(joint_count, joints, frames, frame_time, values, &channels, NULL);
    if (status != BAT_OK) return status;
    bat_take *take = calloc(1, sizeof *take);
    if (!take) return BAT_MEMORY;
    take->users = BAT_USERS_ONE;
    take->joint_count = joint_count, take->frames = frames, take->channels = channels,
    take->frame_time = frame_time;
    status = fill(take, joints, values);
    if (status == BAT_OK)
        *out = take;
    else
        bat_take_free(take);
    return status;
}

bat_status bat_take_copy(const bat_take *take, bat_take **out) {
    return bat_take_create(take->joint_count, take->joints, take->frames, take->frame_time, take->values,
                           out);
}

const bat_bone *bat_take_joints(const bat_take *take, int *count) {
    if (count) *count = take->joint_count;
    return take->joints;
}

const double *bat_take_values(const bat_take *take, size_t *frames, size_t *channels) {
    if (frames) *frames = take->frames;
    if (channels) *channels = take->channels;
    return take->values;
}

double bat_take_frame_time(const bat_take *take) { return take->frame_time; }

/* ---- where the joints are ---- */

static double *values_of(const bat_take *take, int joint, size_t frame) {
    return take->values + frame * take->channels + take->first[joint];
}

vec bat_take_place(const bat_take *take, int joint, size_t frame) {
    const bat_bone *j = &take->joints[joint];
    const double *values = values_of(take, joint, frame);
    double at[3] = {j->offset[0], j->offset[1], j->offset[2]};
    for (int k = 0; k < j->channel_count; k++)
        if (!is_turn(j->channels[k])) at[j->channels[k]] = values[k];
    return vec_load(at, 3);
}

static quat about(int axis, double degrees) {
    const double half = 0.5 * fmod(degrees, 720) * BAT_PI / 180;
    double v[4] = {0, 0, 0, bat_cos(half)};
    v[axis] = bat_sin(half);
    return quat_load(v);
}

quat bat_take_turn(const bat_take *take, int joint, size_t frame) {
    const bat_bone *j = &take->joints[joint];
    const double *values = values_of(take, joint, frame);
    quat q = quat_one;
    for (int k = 0; k < j->channel_count; k++)
        if (is_turn(j->channels[k])) q = quat_mul(q, about((int)j->channels[k] - BAT_X_ROTATION, values[k]));
    return quat_unit(q);
}

bat_status bat_take_positions(const bat_take *take, size_t frame, double *out) {
    if (!take || !out || frame >= take->frames) return BAT_ARGUMENT;
    quat *turns = malloc((size_t)take->joint_count * sizeof *turns);
    if (!turns) return BAT_MEMORY;
    for (int i = 0; i < take->joint_count; i++) {
        const int parent = take->joints[i].parent;
        const quat own = bat_take_turn(take, i, frame);
        vec at = bat_take_place(take, i, frame);
        if (parent >= 0) at = vec_add(vec_load(out + 3 * parent, 3), quat_turn(turns[parent], at));
        turns[i] = parent < 0 ? own : quat_unit(quat_mul(turns[parent], own));
        vec_store(at, out + 3 * i);
    }
    free(turns);
    return BAT_OK;
}

/* ---- angles ---- */

/* The angle that is the same turn, nearest to another. */
static double near(double degrees, double to) { return degrees + 360 * nearbyint((to - degrees) / 360); }

static void matrix_of(quat q, double m[3][3]) {
    for (int k = 0; k < 3; k++) {
        const vec v = quat_turn(q, (vec){k == 0, k == 1, k == 2});
        m[0][k] = v.x, m[1][k] = v.y, m[2][k] = v.z;
    }
}

/* The angles of turns about axis[0], then about axis[1] and axis[2] as turned, degrees; of both solutions that nearer to
 * `angles`, which they replace. */
static void angles_of(quat q, const int axis[3], double angles[3]) {
    const int a = axis[0], b = axis[1], c = axis[2];
    const double e = (b - a + 3) % 3 == 1 ? 1 : -1, unit = 180 / BAT_PI;
    double m[3][3], found[2][3], off[2];
    matrix_of(q, m);
    const double level = bat_hypot(m[a][a], m[a][b]), second = bat_atan2(e * m[a][c], level);
    if (level < 1e-7) { /* the first and the third turn about one axis: the third stays */
        matrix_of(quat_mul(q, about(c, -angles[2])), m);
        angles[0] = near(bat_atan2(e * m[c][b], m[b][b]) * unit, angles[0]);
        angles[1] = near(second * unit, angles[1]);
        return;
    }
    const double first = bat_atan2(-e * m[b][c], m[c][c]), third = bat_atan2(-e * m[a][b], m[a][a]);
    for (int s = 0; s < 2; s++) {
        const double turned[3] = {first + s * BAT_PI, s ? BAT_PI - second : second, third + s * BAT_PI};
        off[s] = 0;
        for (int k = 0; k < 3; k++) {
            found[s][k] = near(turned[k] * unit, angles[k]);
            off[s] += fabs(found[s][k] - angles[k]);
        }
    }
    memcpy(angles, found[off[1] < off[0]], 3 * sizeof *angles);
}

void bat_bone_angles(const bat_bone *joint, quat turn, double angles[3]) {
    int axis[3] = {0, 1, 2}, count = 0;
    for (int k = 0; k < joint->channel_count; k++)
        if (is_turn(joint->channels[k])) axis[count++] = (int)joint->channels[k] - BAT_X_ROTATION;
    if (count == 1) {
        const double v[3] = {turn.x, turn.y, turn.z};
        angles[0] = near(2 * bat_atan2(v[axis[0]], turn.w) * 180 / BAT_PI, angles[0]);
        return;
    }
    if (count == 2) axis[2] = 3 - axis[0] - axis[1], angles[2] = 0;
    if (count >= 2) angles_of(turn, axis, angles);
}

quat bat_bone_turn(const bat_bone *joint, const double angles[3]) {
    quat q = quat_one;
    int at = 0;
    for (int k = 0; k < joint->channel_count; k++)
        if (is_turn(joint->channels[k]))
            q = quat_mul(q, about((int)joint->channels[k] - BAT_X_ROTATION, angles[at++]));
    return quat_unit(q);
}

void bat_take_angles(const bat_take *take, int joint, size_t frame, double angles[3]) {
    const bat_bone *j = &take->joints[joint];
    const double *values = values_of(take, joint, frame);
    int count = 0;
    for (int k = 0; k < j->channel_count; k++)
        if (is_turn(j->channels[k])) angles[count++] = values[k];
    while (count < 3) angles[count++] = 0;
}

void bat_take_set_turn(bat_take *take, int joint, size_t frame, quat turn) {
    const bat_bone *j = &take->joints[joint];
    double *values = values_of(take, joint, frame), angles[3];
    int count = 0;
    bat_take_angles(take, joint, frame, angles);
    bat_bone_angles(j, turn, angles);
    for (int k = 0; k < j->channel_count; k++)
        if (is_turn(j->channels[k])) values[k] = angles[count++];
}

void bat_take_set_place(bat_take *take, int joint, size_t frame, vec place) {
    const bat_bone *j = &take->joints[joint];
    double *values = values_of(take, joint, frame);
    const double at[3] = {place.x, place.y, place.z};
    for (int k = 0; k < j->channel_count; k++)
        if (!is_turn(j->channels[k])) values[k] = at[j->channels[k]];
}
