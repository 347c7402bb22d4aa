/* The tangents tool's knowledge of its spline. */
#include "editor/tools/tangents/state.h"
#include "base/real.h"
#include "editor/scene/seen.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/tools/toolbox.h"
#include "editor/view/curve_ground.h"
#include "editor/view/stage.h"
#include "editor/view/way.h"
#include "hands/tangents/spline.h"
#include <stdlib.h>

bat_splining *bat_splining_of(const bat_context *c) { return bat_toolbox_that(c, BAT_EDITS_SPLINES)->state; }

static const double STRAIGHT = 1e-6; /* sine of the angle between chords that span no plane */
static const double BEHIND = 1e9;    /* where what lies behind the eye is put: out of everybody's reach */
static const double AT_EYE = 1e-6;   /* of a direction's length: seen shorter, it points at the eye */

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
    if (!spline) {
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

const bat_object *bat_splining_object(const bat_context *c) {
    return bat_document_at(c->session->document,
                           bat_document_find(c->session->document, bat_splining_of(c)->object));
}

bat_tangents_options bat_splining_next_options(const bat_context *c) {
    bat_tangents_options options = bat_tangents_defaults();
    options.mode = (bat_tangents_mode)c->settings->values[BAT_PROPERTY_SPLINE_MODE];
    return options;
}

/* Those of the chosen spline; NULL: there is none. */
static const bat_tangents_options *own_options(const bat_context *c) {
    const int at = bat_splining_of(c)->object
                       ? bat_document_find(c->session->document, bat_splining_of(c)->object)
                       : -1;
    const bat_object *object = at >= 0 ? bat_document_at(c->session->document, at) : NULL;
    return object ? bat_object_spline_options(object) : NULL;
}

bat_tangents_options bat_splining_options(const bat_context *c) {
    const bat_tangents_options *own = own_options(c);
    return own ? *own : bat_splining_next_options(c);
}

bat_tangents_mode bat_splining_mode(const bat_context *c) {
    const bat_tangents_options *own = own_options(c);
    return own ? own->mode : (bat_tangents_mode)c->settings->values[BAT_PROPERTY_SPLINE_MODE];
}

bool bat_splining_is_even(const bat_context *c) { return bat_splining_mode(c) == BAT_TANGENTS_EVEN; }

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

static bool to_unit(vec *v) {
    const double length = vec_norm(*v);
    if (!(length > 0)) return false;
    v->x /= length, v->y /= length, v->z /= length;
    return true;
}

vec bat_splining_point(const bat_spline *spline, int point) {
    return vec_load(spline->points + spline->dimension * point, spline->dimension);
}

bool bat_splining_chord(const bat_spline *spline, const bat_joint *joints, int point, int step, vec *out) {
    int other = point;
    for (int n = 0; n < bat_spline_count(spline); n++) {
        other += step;
        if (spline->closed) other = (other + bat_spline_count(spline)) % bat_spline_count(spline);
        if (other < 0 || other >= bat_spline_count(spline)) return false;
        if (joints[other].dropped) continue;
        *out = vec_sub(bat_splining_point(spline, other), bat_splining_point(spline, point));
        return to_unit(out);
    }
    return false;
}

vec bat_splining_direction(const bat_spline *spline, const bat_joint *joints, int point) {
    const bat_joint *joint = &joints[point];
    const int size = spline->dimension;
    const vec sources[] = {vec_load(joint->right, size), vec_load(joint->left, size),
                           vec_load(spline->tangents + size * point, size)};
    vec out;
    for (int i = 0; i < 3; i++) {
        out = sources[i];
        if (to_unit(&out)) return out;
    }
    if (bat_splining_chord(spline, joints, point, 1, &out)) return out;
    if (bat_splining_chord(spline, joints, point, -1, &out)) return (vec){-out.x, -out.y, -out.z};
    return (vec){1, 0, 0};
}

vec bat_splining_normal(bat_context *c, const bat_spline *spline, const bat_joint *joints, int point) {
    const bat_object *object = bat_splining_object(c);
    double normal[3] = {0, 0, 1}, best[3];
    vec before, after, across = {0, 0, 0};
    if (spline->dimension == 2) return vec_load(normal, 3);
    if (bat_splining_chord(spline, joints, point, -1, &before) &&
        bat_splining_chord(spline, joints, point, 1, &after))
        across = vec_cross(after, before);
    const bool straight = !(vec_norm(across) > STRAIGHT);
    if (straight && bat_curve_normal(bat_object_curve(object, 0), best)) across = vec_load(best, 3);
    vec_store(straight && !(vec_norm(across) > STRAIGHT) ? (vec){0, 0, 0} : vec_unit(across), normal);
    bat_stage_turn_away(c->stage, normal);
    return vec_load(normal, 3);
}

vec bat_splining_turned(vec d, vec axis, double cosine, double sine) {
    axis = vec_unit(vec_reject(axis, vec_unit(d)));
    const vec aside = vec_cross(axis, d);
    return (vec){cosine * d.x + sine * aside.x, cosine * d.y + sine * aside.y, cosine * d.z + sine * aside.z};
}

void bat_splining_seen(const bat_context *c, vec at, double out[2]) {
    double place[3];
    vec_store(at, place);
    if (!bat_stage_look(c->stage, 3, place, out)) out[0] = out[1] = BEHIND;
}

void bat_splining_seen_way(const bat_context *c, vec at, vec direction, double out[2]) {
    const double reach = bat_stage_pixel(c->stage) * BAT_PROMPT_RADIUS;
    double from[2], to[2];
    bat_splining_seen(c, at, from);
    bat_splining_seen(c, vec_add(at, vec_scale(direction, reach)), to);
    const double x = to[0] - from[0], y = to[1] - from[1], length = bat_hypot(x, y);
    const bool shown = length > AT_EYE * reach;
    out[0] = shown ? x / length : 0;
    out[1] = shown ? y / length : 0;
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
