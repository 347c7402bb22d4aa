/* The tangents tool: how its spline is shown. Circles, arrows and marks are of a size in the window, wherever they are
 * seen; directions, handles and chords are seen as they lie in space. */
#include "editor/tools/tangents/state.h"
#include "base/real.h"
#include "editor/pick/spot.h"
#include "editor/scene/path.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/disc.h"
#include "editor/show/overlay.h"
#include "editor/tools/tangents/draft.h"
#include "editor/view/stage.h"
#include "hands/tangents/spline.h"
#include <batten/bezier.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double POINT_RADIUS = 4.5, CHOSEN_RADIUS = 5.5, HANDLE_RADIUS = 4, ARROW_HEAD = 12; /* px */
static const double LINE = 18, HALF_WIDTH = 66; /* px: between lines of values; half the usual width of one */
static const double GHOSTS[] = {-20, -10, 10, 20}; /* degrees */
enum { GHOST_POINTS_MAX = 2000, MARKS_MAX = 3000 };

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

/* A chord as it is seen. */
static bool seen_chord(const bat_context *c, const bat_spline *spline, const bat_joint *joints, int point,
                       int step, double out[2]) {
    vec chord;
    if (!bat_splining_chord(spline, joints, point, step, &chord)) return false;
    bat_splining_seen_way(c, bat_splining_point(spline, point), chord, out);
    return true;
}

/* The directions between the chords, which the formula can yield, and fainter all the others. */
static void zones(const bat_context *c, bat_overlay *list, const bat_spline *spline, const bat_joint *joints,
                  int point, double radius) {
    double before[2], after[2], at[2];
    if (!seen_chord(c, spline, joints, point, -1, before) || !seen_chord(c, spline, joints, point, 1, after))
        return;
    bat_splining_seen(c, bat_splining_point(spline, point), at);
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

static void handles(const bat_context *c, bat_overlay *list, vec at, const bat_joint *joint, double pixel) {
    const vec d[] = {vec_load(joint->left, 3), vec_load(joint->right, 3)};
    double ends[2][2];
    for (int side = 0; side < 2; side++)
        bat_splining_seen(c, vec_add(at, vec_scale(d[side], (side ? 1 : -1) / 3.0)), ends[side]);
    bat_overlay_item(list, BAT_ROLE_HANDLE, BAT_ITEM_STROKED, 1);
    bat_path_move(&list->path, ends[0][0], ends[0][1]);
    bat_path_line(&list->path, ends[1][0], ends[1][1]);
    bat_overlay_item(list, BAT_ROLE_HANDLE, BAT_ITEM_FILLED | BAT_ITEM_STROKED, 1.5F);
    for (int side = 0; side < 2; side++)
        if (vec_norm(d[side]) > 0) bat_overlay_mark(list, ends[side], HANDLE_RADIUS * pixel);
}

/* What of the draft feels one of its points, as one path. */
static void beside(bat_overlay *list, const bat_draft *draft, int point,
                   const bat_tangents_options *options) {
    bat_spline spline = bat_draft_spline(draft);
    bat_joint *joints = malloc((size_t)draft->count * sizeof *joints);
    double *bezier = NULL;
    int segments = 0;
    if (joints && bat_tangents(&spline, options, joints, &segments, &bezier, NULL) == BAT_OK &&
        !joints[point].dropped) {
        /* Every piece feels every point; in a round spline, up to the next direction that is given. */
        const bool all = options->mode == BAT_TANGENTS_EVEN || options->mode == BAT_TANGENTS_ROUND;
        int after = -1;
        for (int i = 0; i <= point; i++) after += !joints[i].dropped;
        for (int which = all ? 0 : after - 1; which <= (all ? segments - 1 : after); which++) {
            int segment = spline.closed ? (which + segments) % segments : which;
            if (segment < 0 || segment >= segments) continue;
            const double *b = bezier + 4 * spline.dimension * segment;
            double seen[8];
            bool ahead = true;
            for (int i = 0; i < 4; i++)
                ahead = bat_map_look(list->path.map, spline.dimension, b + i * spline.dimension,
                                     seen + 2 * i) &&
                        ahead;
            if (!ahead) continue;
            bat_path_move(&list->path, seen[0], seen[1]);
            bat_path_cubic(&list->path, seen + 2);
        }
    }
    bat_free(bezier);
    free(joints);
}

/* Where the curve would go with the direction turned further, either way. */
static void ghosts(bat_overlay *list, bat_draft *draft, int point, vec axis,
                   const bat_tangents_options *options) {
    const size_t bytes = (size_t)draft->dimension * sizeof(double);
    double *tangent = draft->tangents + draft->dimension * point, turned[3];
    const vec kept = vec_load(tangent, draft->dimension);
    if (!(vec_norm(kept) > 0) || draft->count > GHOST_POINTS_MAX) return;
    bat_overlay_item(list, BAT_ROLE_GHOST, BAT_ITEM_STROKED, 1);
    for (size_t i = 0; i < sizeof GHOSTS / sizeof *GHOSTS; i++) {
        const double angle = GHOSTS[i] * BAT_PI / 180;
        vec_store(bat_splining_turned(kept, axis, bat_cos(angle), bat_sin(angle)), turned);
        memcpy(tangent, turned, bytes);
        beside(list, draft, point, options);
    }
    vec_store(kept, turned);
    memcpy(tangent, turned, bytes);
}

/* ---- values ---- */

typedef struct corner {
    double at[2], dx, dy;
} corner;

/* Beside the circle, on the one of its four sides that chords and handles keep most clear of. */
static corner value_corner(const bat_context *c, const bat_spline *spline, const bat_joint *joints,
                           int point) {
    static const double sides[4][2] = {{0, 1}, {0, -1}, {1, 0}, {-1, 0}};
    double lines[4][2], best = INFINITY;
    int count = 2, chosen = 0;
    const vec at = bat_splining_point(spline, point);
    bat_splining_seen_way(c, at, bat_splining_direction(spline, joints, point), lines[0]);
    for (int k = 0; k < 2; k++) lines[1][k] = -lines[0][k];
    for (int step = -1; step <= 1; step += 2)
        if (seen_chord(c, spline, joints, point, step, lines[count])) count++;
    for (int i = 0; i < 4; i++) {
        double worst = -1;
        for (int j = 0; j < count; j++)
            worst = fmax(worst, sides[i][0] * lines[j][0] + sides[i][1] * lines[j][1]);
        if (worst < best - 1e-9) best = worst, chosen = i;
    }
    double clear = BAT_PROMPT_RADIUS + 16;
    corner where = {{0, 0}, sides[chosen][0] * (clear + HALF_WIDTH), -LINE};
    bat_splining_seen(c, at, where.at);
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
    corner where = value_corner(c, spline, joints, point);
    const char *in = bat_word(c, BAT_STRING_VALUE_IN);
    const char *out = bat_word(c, BAT_STRING_VALUE_OUT);
    char text[BAT_LABEL_ROOM];
    vec chord = {0, 0, 0};
    if (!isnan(joint->angle_in)) {
        snprintf(text, sizeof text, "%s %.1f°   %s %.1f°", in, joint->angle_in * 180 / BAT_PI, out,
                 joint->angle_out * 180 / BAT_PI);
    } else { /* an end point has one chord */
        bool first = bat_splining_chord(spline, joints, point, 1, &chord);
        if (!first && bat_splining_chord(spline, joints, point, -1, &chord)) chord = vec_scale(chord, -1);
        double off = vec_angle(chord, bat_splining_direction(spline, joints, point));
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

/* Where the next point would lie. */
static bool next_place(bat_context *c, const bat_splining *s, double out[3]) {
    bat_hit hit;
    if (!s->hovering || bat_stage_place(c->stage, s->hover, NULL, &hit) != BAT_OK) return false;
    memcpy(out, hit.at, sizeof hit.at);
    return true;
}

/* A spline of one point: none of it is in the document yet. */
static void first_point(bat_context *c, bat_overlay *list) {
    bat_splining *s = bat_splining_of(c);
    double pixel = bat_stage_pixel(c->stage), next[3], at[2], way[2];
    const vec first = vec_load(s->first, 3), direction = vec_load(s->first_direction, 3);
    if (next_place(c, s, next)) {
        bat_draft *draft = &s->draft;
        bat_draft_begin(draft, s->dimension);
        if (bat_draft_insert(draft, 0, s->first) == BAT_OK && bat_draft_insert(draft, 1, next) == BAT_OK) {
            memcpy(draft->tangents, s->first_direction, (size_t)s->dimension * sizeof(double));
            bat_overlay_item(list, BAT_ROLE_GHOST, BAT_ITEM_STROKED, 1.5F);
            const bat_tangents_options options = bat_splining_options(c);
            beside(list, draft, 1, &options);
        }
    }
    bat_splining_seen(c, first, at);
    if (!bat_splining_is_even(c)) circle(list, at, BAT_PROMPT_RADIUS * pixel);
    bat_splining_seen_way(c, first, direction, way);
    if (vec_norm(direction) > 0) arrow(list, at, way, BAT_PROMPT_RADIUS * pixel, ARROW_HEAD * pixel, false);
    dot(list, BAT_ROLE_CHOSEN, at, CHOSEN_RADIUS * pixel);
}

/* The curve with the next point under the pen, or closed. */
static void next_point(bat_context *c, bat_overlay *list, const bat_spline *spline,
                       const bat_tangents_options *options) {
    bat_splining *s = bat_splining_of(c);
    double next[3];
    if (s->over.part != BAT_PART_NOTHING && s->over.part != BAT_PART_FIRST) return;
    if (!next_place(c, s, next) || spline->count > GHOST_POINTS_MAX ||
        bat_draft_load(&s->draft, spline) != BAT_OK)
        return;
    bool closes = s->over.part == BAT_PART_FIRST;
    s->draft.closed = closes;
    if (!closes && bat_draft_insert(&s->draft, s->draft.count, next) != BAT_OK) return;
    bat_overlay_item(list, BAT_ROLE_GHOST, BAT_ITEM_STROKED, 1.5F);
    beside(list, &s->draft, closes ? 0 : s->draft.count - 1, options);
}

static void mark(const bat_context *c, bat_overlay *list, const bat_spline *spline, int point,
                 double radius) {
    double at[2];
    bat_splining_seen(c, bat_splining_point(spline, point), at);
    dot(list, BAT_ROLE_CHOSEN, at, radius * bat_stage_pixel(c->stage));
}

static void marks(bat_context *c, bat_overlay *list, const bat_spline *spline) {
    const bat_splining *s = bat_splining_of(c);
    double pixel = bat_stage_pixel(c->stage), at[2];
    bat_overlay_item(list, BAT_ROLE_POINT, BAT_ITEM_FILLED | BAT_ITEM_STROKED, 1.5F);
    for (int i = 0; i < bat_spline_count(spline) && i < MARKS_MAX; i++) {
        bat_splining_seen(c, bat_splining_point(spline, i), at);
        if (i != s->point) bat_overlay_circle(list, at, POINT_RADIUS * pixel);
    }
    if (s->over.part == BAT_PART_FIRST && s->state == BAT_SPLINING_IDLE)
        mark(c, list, spline, 0, 1.5 * CHOSEN_RADIUS);
    if (s->point >= 0) mark(c, list, spline, s->point, CHOSEN_RADIUS);
}

static void prompt(bat_context *c, bat_overlay *list, const bat_spline *spline, const bat_joint *joints,
                   int point) {
    const bat_splining *s = bat_splining_of(c);
    double pixel = bat_stage_pixel(c->stage), way[2], at[2], radius = BAT_PROMPT_RADIUS * pixel;
    const vec place = bat_splining_point(spline, point),
              given = vec_load(spline->tangents + spline->dimension * point, spline->dimension);
    bool turning = s->state == BAT_SPLINING_DRAGGING && s->press.part == BAT_PART_DIRECTION;
    bat_splining_seen(c, place, at);
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
    bat_splining_seen_way(c, place, bat_splining_direction(spline, joints, point), way);
    arrow(list, at, way, radius, ARROW_HEAD * pixel, !(vec_norm(given) > 0));
}

static void guide(bat_context *c, bat_overlay *list, vec at) {
    const bat_splining *s = bat_splining_of(c);
    double reach = 3 * BAT_PROMPT_RADIUS * bat_stage_pixel(c->stage), ends[4];
    const vec way = vec_scale(vec_load(s->guide, 3), reach);
    bat_splining_seen(c, vec_sub(at, way), ends);
    bat_splining_seen(c, vec_add(at, way), ends + 2);
    bat_overlay_item(list, BAT_ROLE_GUIDE, BAT_ITEM_STROKED | BAT_ITEM_DASHED, 1);
    bat_overlay_polyline(list, 2, ends);
}

/* Under the pen, the disc on what a point would be placed on. */
static void ground(bat_context *c, bat_overlay *list) {
    const bat_splining *s = bat_splining_of(c);
    if (s->hovering && s->state == BAT_SPLINING_IDLE && s->over.part == BAT_PART_NOTHING)
        bat_disc_show(c->stage, s->hover, list);
}

void bat_splining_overlay(bat_context *c, bat_overlay *list) {
    bat_splining *s = bat_splining_of(c);
    const bat_spline *spline = bat_splining_spline(c);
    const bat_joint *joints = bat_splining_joints(c);
    bool dragging = s->state == BAT_SPLINING_DRAGGING;
    ground(c, list);
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
    const bool even = options->mode == BAT_TANGENTS_EVEN;
    bool turning = point >= 0 && !even &&
                   (dragging ? s->press.part != BAT_PART_POINT : s->on_direction && !s->placing);
    if (turning) zones(c, list, spline, joints, point, BAT_PROMPT_RADIUS * pixel);
    if (!dragging) {
        bat_overlay_item(list, BAT_ROLE_HIGHLIGHT, BAT_ITEM_STROKED, 1);
        bat_path_curve(&list->path, bat_object_curve(object, 0));
    }
    if (dragging && turning && s->travelled > 0)
        ghosts(list, &s->draft, point, bat_splining_normal(c, spline, joints, point), options);
    if (s->placing && !dragging) next_point(c, list, spline, options);
    if (dragging && s->snapped) guide(c, list, bat_splining_point(spline, point));
    if (point >= 0 && !s->placing && !even)
        handles(c, list, bat_splining_point(spline, point), &joints[point], pixel);
    if (point >= 0 && !even) prompt(c, list, spline, joints, point);
    if (!dragging && !s->placing && s->hovering && s->near >= 0 && s->near < bat_spline_count(spline) &&
        s->near != point)
        prompt(c, list, spline, joints, s->near);
    marks(c, list, spline);
    if (turning && !joints[point].dropped) values(c, list, spline, joints, point);
}
