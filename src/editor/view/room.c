#include "editor/view/room.h"
#include "base/real.h"
#include "base/vec.h"
#include "format/model/drawn.h"
#include "format/seen/seen.h"
#include <math.h>
#include <string.h>

static const double DETENT = 5;  /* degrees beyond a pole that hold a drag there */
static const double POLE = 1e-6; /* sine of the angle below which what is upright is seen from its end */
/* Degrees that rounding the angles of the page to hundredths may turn a view. */
static const double ROUNDED = 0.03;
static const double DEGREE = 180 / BAT_PI;

/* x, y and z of the room of a wall, on its page. */
static const double WALL[3][3] = {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};

bool bat_room_is_wall(const bat_document *document) {
    return bat_seen_in_space(document) && bat_stand_of(document) == BAT_STAND_WALL;
}

void bat_room_axes(bool wall, double axes[9]) {
    static const double floor[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    memcpy(axes, wall ? WALL[0] : floor, sizeof floor);
}

static vec into_room(const double at[3]) {
    const vec v = vec_load(at, 3);
    return (vec){vec_dot(v, vec_load(WALL[0], 3)), vec_dot(v, vec_load(WALL[1], 3)),
                 vec_dot(v, vec_load(WALL[2], 3))};
}

static vec out_of_room(vec v) {
    vec out = {0, 0, 0};
    const double at[3] = {v.x, v.y, v.z};
    for (int i = 0; i < 3; i++) out = vec_add(out, vec_scale(vec_load(WALL[i], 3), at[i]));
    return out;
}

/* Of a gaze and what is right of it. Straight down or up, the room turns and the head does not. */
static bat_attitude pose_of(vec right, vec ahead) {
    const double level = bat_hypot(ahead.x, ahead.y);
    bat_attitude pose = {.tilt = bat_atan2(level, ahead.z) * DEGREE};
    if (!(level > POLE)) {
        pose.turn = bat_atan2(-right.y, right.x) * DEGREE;
        return pose;
    }
    const vec across = {-ahead.y / level, ahead.x / level, 0}; /* level, to the right or to the left */
    const vec down = vec_cross(ahead, across);
    pose.turn = bat_atan2(-ahead.x, -ahead.y) * DEGREE;
    pose.roll = bat_atan2(-vec_dot(right, down), vec_dot(right, across)) * DEGREE;
    const double half = remainder(pose.roll, 180);
    if (fabs(half) * level < ROUNDED) pose.roll = fabs(pose.roll) > 90 ? 180 : 0;
    return pose;
}

bat_attitude bat_room_attitude(const bat_view *view, bool wall) {
    if (!wall) return (bat_attitude){view->angle - view->roll, view->tilt, view->roll};
    double right[3], down[3], ahead[3];
    bat_view_axes(view, right, down, ahead);
    return pose_of(into_room(right), into_room(ahead));
}

static void take(bat_view *view, const bat_attitude *pose) {
    bat_view_pose(view, pose->turn + pose->roll, pose->tilt, pose->roll);
}

void bat_room_take(bat_view *view, bool wall, const bat_attitude *pose) {
    double right[3], down[3], ahead[3];
    if (!wall) {
        take(view, pose);
        return;
    }
    bat_view there = bat_view_defaults();
    take(&there, pose);
    bat_view_axes(&there, right, down, ahead);
    const bat_attitude page = pose_of(out_of_room(vec_load(right, 3)), out_of_room(vec_load(ahead, 3)));
    take(view, &page);
}

void bat_room_orbit(bat_view *view, bool wall, double turn, double down, double *held) {
    bat_attitude pose = bat_room_attitude(view, wall);
    const double side = fabs(pose.roll) > 90 ? -1 : 1, past = held ? *held : 0;
    double tilt = pose.tilt + side * (down + past);
    const double beyond = tilt < 0 ? tilt : tilt > 180 ? tilt - 180 : 0;
    if (held) *held = 0;
    if (held && fabs(beyond) > 0 && fabs(beyond) < DETENT) {
        *held = side * beyond;
        tilt -= beyond;
    } else if (beyond != 0) {
        const double on = held ? fabs(down) : fabs(beyond);
        tilt = beyond < 0 ? on : 180 - on;
        pose.turn += 180;
        pose.roll += 180;
    }
    pose.tilt = tilt;
    pose.turn += turn;
    bat_room_take(view, wall, &pose);
}

void bat_room_look_along(bat_view *view, bool wall, const double ahead[3]) {
    const vec n = wall ? into_room(ahead) : vec_load(ahead, 3);
    const double level = bat_hypot(n.x, n.y);
    const bat_attitude was = bat_room_attitude(view, wall);
    const bat_attitude pose = {.turn = level > POLE ? bat_atan2(-n.x, -n.y) * DEGREE : was.turn + was.roll,
                               .tilt = bat_atan2(level, n.z) * DEGREE};
    bat_room_take(view, wall, &pose);
}

void bat_view_look_along(bat_view *view, const double ahead[3], const double up[3]) {
    const vec gaze = vec_unit(vec_load(ahead, 3));
    const vec right = vec_unit(vec_cross(gaze, vec_load(up, 3)));
    const bat_attitude pose = pose_of(right, gaze);
    take(view, &pose);
}
