/* The tangents tool's knowledge of its spline, and how the spline is shown. */
#include "base/vec.h"
#include "hands/tangents/spline.h"
#include "curve/frames_walk.h"
#include "editor/scene/path.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"
#include "editor/tools/tangents/draft.h"
#include "editor/tools/tangents/state.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "base/real.h"
#include <batten/bezier.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bat_splining *bat_splining_of(const bat_context *c) { return bat_toolbox_that(c, BAT_EDITS_SPLINES)->state; }

static const double POINT_RADIUS = 4.5, CHOSEN_RADIUS = 5.5, HANDLE_RADIUS = 4, ARROW_HEAD = 12; /* px */
static const double LINE = 18, HALF_WIDTH = 66; /* px: between lines of values; half the usual width of one */
static const double GHOSTS[] = {-20, -10, 10, 20}; /* degrees */
enum { GHOST_POINTS_MAX = 2000, MARKS_MAX = 3000 };

void bat_splining_free(bat_splining *s) {
    bat_draft_free(&s->draft);
    free(s->joints);
    *s = (bat_splining){.point = -1, .near = -1};
}

const bat_spline *bat_splining_spline(bat_context *c) {
    bat_splining *s = bat_splining_of(c);
    int at = s->object ? bat_document_find(c->session->document, s->object) : -1;
    const bat_object *object = at < 0 || bat_seen_out_of_reach(c, at)
                                   ? NULL
                                   : bat_document_at(c->session->document, at);
    const bat_spline *spline = object ? bat_object_spline(object) : NULL;
    if (!spline || spline->dimension != 2) {
        if (s->object)
            s->point = s->placing ? 0 : -1; /* after undo: the first point awaits its second again */
        s->object = 0;
        return NULL;
    }
    if (spline->closed) s->placing = false;
    if (s->point >= bat_spline_count(spline) || (s->placing && s->state == BAT_SPLINING_IDLE))
        s->point = bat_spline_count(spline) - 1;
    return spline;
}

const bat_joint *bat_splining_joints(bat_context *c) {
    bat_splining *s = bat_splining_of(c);
    const bat_spline *spline = bat_splining_spline(c);
    if (!spline) return NULL;
    if (s->joints && s->joints_object == s->object && s->joints_revision == c->session->revision)
        return s->joints;
    const bat_object *object = bat_document_at(c->session->document,
                                               bat_document_find(c->session->document, s->object));
    free(s->joints);
    s->joints = malloc(spline->count * sizeof *s->joints);
    bat_status status = BAT_MEMORY;
    if (s->joints)
        status = bat_tangents(spline, bat_object_spline_options(object), s->joints, NULL, NULL, NULL);
    if (status != BAT_OK) {
        free(s->joints);
        s->joints = NULL;
        return NULL;
    }
    s->joints_object = s->object;
    s->joints_revision = c->session->revision;
    return s->joints;
}

static bool to_unit(double v[2]) {
    double length = bat_hypot(v[0], v[1]);
    if (!(length > 0)) return false;
    v[0] /= length, v[1] /= length;
    return true;
}

bool bat_splining_chord(const bat_spline *spline, const bat_joint *joints, int point, int step,
                        double out[2]) {
    int other = point;
    for (int n = 0; n < bat_spline_count(spline); n++) {
        other += step;
        if (spline->closed) other = (other + bat_spline_count(spline)) % bat_spline_count(spline);
        if (other < 0 || other >= bat_spline_count(spline)) return false;
        if (joints[other].dropped) continue;
        for (int k = 0; k < 2; k++) out[k] = spline->points[2 * other + k] - spline->points[2 * point + k];
        return to_unit(out);
    }
    return false;
}

void bat_splining_direction(const bat_spline *spline, const bat_joint *joints, int point, double out[2]) {
    const bat_joint *joint = &joints[point];
    const double *sources[] = {joint->right, joint->left, spline->tangents + 2 * point};
    for (int i = 0; i < 3; i++) {
        out[0] = sources[i][0], out[1] = sources[i][1];
        if (to_unit(out)) return;
    }
    if (bat_splining_chord(spline, joints, point, 1, out)) return;
    if (bat_splining_chord(spline, joints, point, -1, out)) {
        out[0] = -out[0], out[1] = -out[1];
        return;
    }
    out[0] = 1, out[1] = 0;
}

/* ---- display ---- */

static void dot(bat_overlay *list, bat_role role, const double at[2], double radius) {
    bat_overlay_item(list, role, BAT_ITEM_FILLED | BAT_ITEM_STROKED, 1.5F);
    bat_overlay_circle(list, at, radius);
}

/* automatic: no direction is given, this is the default. */
static void arrow(bat_overlay *list, const double at[2], const double d[2], double radius, double head,
                  bool automatic) {
    double tip[2] = {at[0] + radius * d[0], at[1] + radius * d[1]};
    double back[2] = {tip[0] - head * d[0], tip[1] - head * d[1]};
    double side[2] = {-0.45 * head * d[1], 0.45 * head * d[0]};
    bat_overlay_item(list, BAT_ROLE_ARROW, BAT_ITEM_STROKED | (automatic ? (uint32_t)BAT_ITEM_DASHED : 0), 2);
    bat_path_move(&list->path, at[0], at[1]);
    bat_path_line(&list->path, back[0], back[1]);
    bat_overlay_item(list, BAT_ROLE_ARROW, BAT_ITEM_FILLED | BAT_ITEM_STROKED, 1);
    bat_path_move(&list->path, tip[0], tip[1]);
    bat_path_line(&list->path, back[0] + side[0], back[1] + side[1]);
    bat_path_line(&list->path, back[0] - side[0], back[1] - side[1]);
    bat_path_close(&list->path);
}

static void circle(bat_overlay *list, const double at[2], double radius) {
    bat_overlay_item(list, BAT_ROLE_PROMPT, BAT_ITEM_STROKED, 1.5F);
    bat_overlay_circle(list, at, radius);
}

/* The directions between the chords, which the formula can yield, and fainter all the others. */
static void zones(bat_overlay *list, const bat_spline *spline, const bat_joint *joints, int point,
                  double radius) {
    double before[2], after[2];
    const double *at = spline->points + 2 * point;
    if (!bat_splining_chord(spline, joints, point, -1, before) ||
        !bat_splining_chord(spline, joints, point, 1, after))
        return;
    double cross = -before[0] * after[1] + before[1] * after[0];
    double turn = bat_atan2(cross, -before[0] * after[0] - before[1] * after[1]);
    double from = bat_atan2(-before[1], -before[0]);
    bat_overlay_item(list, BAT_ROLE_BEYOND, BAT_ITEM_FILLED, 0);
    bat_overlay_circle(list, at, radius);
    if (fabs(cross) <= 1e-9) return;
    bat_overlay_item(list, BAT_ROLE_WEDGE, BAT_ITEM_FILLED | BAT_ITEM_STROKED, 1);
    bat_path_move(&list->path, at[0], at[1]);
    bat_overlay_arc(list, at, radius, from, from + turn, true);
    bat_path_close(&list->path);
}

static void handles(bat_overlay *list, const double at[2], const bat_joint *joint, double pixel) {
    const double *d[] = {joint->left, joint->right};
    double ends[2][2];
    for (int side = 0; side < 2; side++)
        for (int k = 0; k < 2; k++) ends[side][k] = at[k] + (side ? 1 : -1) * d[side][k] / 3;
    bat_overlay_item(list, BAT_ROLE_HANDLE, BAT_ITEM_STROKED, 1);
    bat_path_move(&list->path, ends[0][0], ends[0][1]);
    bat_path_line(&list->path, ends[1][0], ends[1][1]);
    bat_overlay_item(list, BAT_ROLE_HANDLE, BAT_ITEM_FILLED | BAT_ITEM_STROKED, 1.5F);
    for (int side = 0; side < 2; side++)
        if (bat_hypot(d[side][0], d[side][1]) > 0) bat_overlay_mark(list, ends[side], HANDLE_RADIUS * pixel);
}

/* The segments on both sides of a point of the draft, as one path. */
static void beside(bat_overlay *list, const bat_draft *draft, int point,
                   const bat_tangents_options *options) {
    bat_spline spline = bat_draft_spline(draft);
    bat_joint *joints = malloc((size_t)draft->count * sizeof *joints);
    double *bezier = NULL;
    int segments = 0;
    if (joints && bat_tangents(&spline, options, joints, &segments, &bezier, NULL) == BAT_OK &&
        !joints[point].dropped) {
        int after = -1;
        for (int i = 0; i <= point; i++) after += !joints[i].dropped;
        for (int which = after - 1; which <= after; which++) {
            int segment = spline.closed ? (which + segments) % segments : which;
            if (segment < 0 || segment >= segments) continue;
            const double *b = bezier + 8 * segment;
            bat_path_move(&list->path, b[0], b[1]);
            bat_path_cubic(&list->path, b + 2);
        }
    }
    bat_free(bezier);
    free(joints);
}

/* Where the curve would go with the direction turned further, either way. */
static void ghosts(bat_overlay *list, bat_draft *draft, int point, const bat_tangents_options *options) {
    double *tangent = draft->tangents + 2 * point, kept[2] = {tangent[0], tangent[1]};
    if ((kept[0] == 0 && kept[1] == 0) || draft->count > GHOST_POINTS_MAX) return;
    bat_overlay_item(list, BAT_ROLE_GHOST, BAT_ITEM_STROKED, 1);
    for (size_t i = 0; i < sizeof GHOSTS / sizeof *GHOSTS; i++) {
        double c = bat_cos(GHOSTS[i] * BAT_PI / 180), s = bat_sin(GHOSTS[i] * BAT_PI / 180);
        tangent[0] = c * kept[0] - s * kept[1], tangent[1] = s * kept[0] + c * kept[1];
        beside(list, draft, point, options);
    }
    tangent[0] = kept[0], tangent[1] = kept[1];
}

/* ---- values ---- */

typedef struct corner {
    const double *at;
    double dx, dy;
} corner;

/* Beside the circle, on the one of its four sides that chords and handles keep most clear of. */
static corner value_corner(const bat_spline *spline, const bat_joint *joints, int point) {
    static const double sides[4][2] = {{0, 1}, {0, -1}, {1, 0}, {-1, 0}};
    double lines[4][2], best = INFINITY;
    int count = 2, chosen = 0;
    bat_splining_direction(spline, joints, point, lines[0]);
    for (int k = 0; k < 2; k++) lines[1][k] = -lines[0][k];
    for (int step = -1; step <= 1; step += 2)
        if (bat_splining_chord(spline, joints, point, step, lines[count])) count++;
    for (int i = 0; i < 4; i++) {
        double worst = -1;
        for (int j = 0; j < count; j++)
            worst = fmax(worst, sides[i][0] * lines[j][0] + sides[i][1] * lines[j][1]);
        if (worst < best - 1e-9) best = worst, chosen = i;
    }
    double clear = BAT_PROMPT_RADIUS + 16;
    corner where = {spline->points + 2 * point, sides[chosen][0] * (clear + HALF_WIDTH), -LINE};
    if (chosen == 0) where.dy = clear;
    if (chosen == 1) where.dy = -clear - 2 * LINE;
    return where;
}

static void say(bat_overlay *list, corner *where, const char *text) {
    bat_overlay_label(list, BAT_ROLE_VALUE, where->at, where->dx, where->dy, text);
    where->dy += LINE;
}

static void values(bat_context *c, bat_overlay *list, const bat_spline *spline, const bat_joint *joints,
                   int point) {
    const bat_joint *joint = &joints[point];
    corner where = value_corner(spline, joints, point);
    const char *in = bat_word(c, BAT_STRING_VALUE_IN);
    const char *out = bat_word(c, BAT_STRING_VALUE_OUT);
    char text[BAT_LABEL_ROOM];
    double chord[2], direction[2];
    bat_splining_direction(spline, joints, point, direction);
    if (!isnan(joint->angle_in)) {
        snprintf(text, sizeof text, "%s %.1f°   %s %.1f°", in, joint->angle_in * 180 / BAT_PI, out,
                 joint->angle_out * 180 / BAT_PI);
    } else { /* an end point has one chord */
        bool first = bat_splining_chord(spline, joints, point, 1, chord);
        if (!first && bat_splining_chord(spline, joints, point, -1, chord)) chord[0] *= -1, chord[1] *= -1;
        double cross = chord[0] * direction[1] - chord[1] * direction[0];
        double off = fabs(bat_atan2(cross, chord[0] * direction[0] + chord[1] * direction[1]));
        snprintf(text, sizeof text, "%s %.1f°", first ? out : in, off * 180 / BAT_PI);
    }
    say(list, &where, text);
    if (!isnan(joint->k)) {
        snprintf(text, sizeof text, "k %.3f | %.3f", joint->k, 1 - joint->k);
        say(list, &where, text);
    } else if (!isnan(joint->angle_in)) {
        say(list, &where, bat_word(c, BAT_STRING_VALUE_BEYOND));
    }
    const double *tension = spline->tension + 2 * point;
    if (tension[0] != 1 || tension[1] != 1) {
        snprintf(text, sizeof text, "%s %.2f | %.2f", bat_word(c, BAT_STRING_VALUE_TENSION), tension[0],
                 tension[1]);
        say(list, &where, text);
    }
}

/* ---- all of it ---- */

/* A spline of one point: none of it is in the document yet. */
static void first_point(bat_context *c, bat_overlay *list) {
    const bat_splining *s = bat_splining_of(c);
    double pixel = bat_stage_pixel(c->stage), hover[2];
    bool given = s->first_direction[0] != 0 || s->first_direction[1] != 0;
    if (s->hovering) {
        double points[4] = {s->first[0], s->first[1], 0, 0}, tangents[4] = {0}, tension[4] = {1, 1, 1, 1};
        bat_stage_seen(c->stage, s->hover, hover);
        memcpy(points + 2, hover, sizeof hover);
        memcpy(tangents, s->first_direction, sizeof s->first_direction);
        bat_draft two = {2, 2, false, points, tangents, tension};
        bat_overlay_item(list, BAT_ROLE_GHOST, BAT_ITEM_STROKED, 1.5F);
        beside(list, &two, 1, NULL);
    }
    circle(list, s->first, BAT_PROMPT_RADIUS * pixel);
    if (given)
        arrow(list, s->first, s->first_direction, BAT_PROMPT_RADIUS * pixel, ARROW_HEAD * pixel, false);
    dot(list, BAT_ROLE_CHOSEN, s->first, CHOSEN_RADIUS * pixel);
}

/* The curve with the next point under the pen, or closed. */
static void next_point(bat_context *c, bat_overlay *list, const bat_spline *spline,
                       const bat_tangents_options *options) {
    bat_splining *s = bat_splining_of(c);
    double hover[2];
    if (!s->hovering || (s->over.part != BAT_PART_NOTHING && s->over.part != BAT_PART_FIRST)) return;
    if (spline->count > GHOST_POINTS_MAX || bat_draft_load(&s->draft, spline) != BAT_OK) return;
    bat_stage_seen(c->stage, s->hover, hover);
    bool closes = s->over.part == BAT_PART_FIRST;
    s->draft.closed = closes;
    if (!closes && bat_draft_insert(&s->draft, s->draft.count, hover) != BAT_OK) return;
    bat_overlay_item(list, BAT_ROLE_GHOST, BAT_ITEM_STROKED, 1.5F);
    beside(list, &s->draft, closes ? 0 : s->draft.count - 1, options);
}

static void marks(bat_context *c, bat_overlay *list, const bat_spline *spline) {
    const bat_splining *s = bat_splining_of(c);
    double pixel = bat_stage_pixel(c->stage);
    bat_overlay_item(list, BAT_ROLE_POINT, BAT_ITEM_FILLED | BAT_ITEM_STROKED, 1.5F);
    for (int i = 0; i < bat_spline_count(spline) && i < MARKS_MAX; i++)
        if (i != s->point) bat_overlay_circle(list, spline->points + 2 * i, POINT_RADIUS * pixel);
    if (s->over.part == BAT_PART_FIRST && s->state == BAT_SPLINING_IDLE)
        dot(list, BAT_ROLE_CHOSEN, spline->points, 1.5 * CHOSEN_RADIUS * pixel);
    if (s->point >= 0) dot(list, BAT_ROLE_CHOSEN, spline->points + 2 * s->point, CHOSEN_RADIUS * pixel);
}

static void prompt(bat_context *c, bat_overlay *list, const bat_spline *spline, const bat_joint *joints,
                   int point) {
    const bat_splining *s = bat_splining_of(c);
    double pixel = bat_stage_pixel(c->stage), direction[2], radius = BAT_PROMPT_RADIUS * pixel;
    const double *at = spline->points + 2 * point, *given = spline->tangents + 2 * point;
    bool turning = s->state == BAT_SPLINING_DRAGGING && s->press.part == BAT_PART_DIRECTION;
    circle(list, at, radius);
    if (turning) {
        double pen[2], away;
        bat_stage_seen(c->stage, s->at, pen);
        away = bat_hypot(pen[0] - at[0], pen[1] - at[1]);
        if (s->travelled > 0 && away > BAT_TENSION_RADIUS * pixel) {
            bat_overlay_item(list, BAT_ROLE_GUIDE, BAT_ITEM_STROKED | BAT_ITEM_DASHED, 1);
            bat_overlay_circle(list, at, away);
        }
    }
    bat_splining_direction(spline, joints, point, direction);
    arrow(list, at, direction, radius, ARROW_HEAD * pixel, given[0] == 0 && given[1] == 0);
}

static void guide(bat_context *c, bat_overlay *list, const double at[2]) {
    const bat_splining *s = bat_splining_of(c);
    double reach = 3 * BAT_PROMPT_RADIUS * bat_stage_pixel(c->stage);
    bat_overlay_item(list, BAT_ROLE_GUIDE, BAT_ITEM_STROKED | BAT_ITEM_DASHED, 1);
    bat_path_move(&list->path, at[0] - reach * s->guide[0], at[1] - reach * s->guide[1]);
    bat_path_line(&list->path, at[0] + reach * s->guide[0], at[1] + reach * s->guide[1]);
}

void bat_splining_overlay(bat_context *c, bat_overlay *list) {
    bat_splining *s = bat_splining_of(c);
    const bat_spline *spline = bat_splining_spline(c);
    const bat_joint *joints = bat_splining_joints(c);
    bool dragging = s->state == BAT_SPLINING_DRAGGING;
    if (s->over.part == BAT_PART_OTHER && !dragging) {
        int at = bat_document_find(c->session->document, s->over.object);
        if (at >= 0) {
            bat_overlay_item(list, BAT_ROLE_HIGHLIGHT, BAT_ITEM_STROKED, 3);
            bat_path_curve(&list->path, bat_object_curve(bat_document_at(c->session->document, at), 0));
        }
    }
    if (!spline || !joints) {
        if (s->placing) first_point(c, list);
        return;
    }
    const bat_object *object = bat_document_at(c->session->document,
                                               bat_document_find(c->session->document, s->object));
    const bat_tangents_options *options = bat_object_spline_options(object);
    double pixel = bat_stage_pixel(c->stage);
    int point = dragging ? s->press.point : s->point;
    bool turning = point >= 0 &&
                   (dragging ? s->press.part != BAT_PART_POINT : s->on_direction && !s->placing);
    if (turning) zones(list, spline, joints, point, BAT_PROMPT_RADIUS * pixel);
    if (!dragging) {
        bat_overlay_item(list, BAT_ROLE_HIGHLIGHT, BAT_ITEM_STROKED, 1);
        bat_path_curve(&list->path, bat_object_curve(object, 0));
    }
    if (dragging && turning && s->travelled > 0) ghosts(list, &s->draft, point, options);
    if (s->placing && !dragging) next_point(c, list, spline, options);
    if (dragging && s->snapped) guide(c, list, spline->points + 2 * point);
    if (point >= 0 && !s->placing) handles(list, spline->points + 2 * point, &joints[point], pixel);
    if (point >= 0) prompt(c, list, spline, joints, point);
    if (!dragging && !s->placing && s->hovering && s->near >= 0 && s->near < bat_spline_count(spline) &&
        s->near != point)
        prompt(c, list, spline, joints, s->near);
    marks(c, list, spline);
    if (turning && !joints[point].dropped) values(c, list, spline, joints, point);
}

bool bat_splining_stop(bat_context *c) {
    bat_splining *s = bat_splining_of(c);
    bat_splining_spline(c);
    if (!s->placing) return false;
    s->placing = false;
    if (!s->object) s->point = -1;
    s->hover_changed = true;
    return true;
}
