/* What is seen of a strand: between splits visibility is constant, and a ray towards the eye decides. */
#include "form/sight/strand.h"

#include <math.h>
#include <stdlib.h>

enum { HITS = 64, HALVINGS = 40 };
static const double nearer = 0.02; /* pixels by which what hides is nearer */
static const double fine = 0.02;   /* pixels to which a change is found */

static bat_status look(const bat_sight_scene *s, const bat_strand *strand, double place, bool *hidden) {
    bat_bead bead;
    double origin[3], way[3];
    bat_surface_point hits[HITS];
    bat_strand_locate(s, strand, place, &bead);
    const vec back = vec_scale(bat_gaze_towards(&s->gaze, bead.at), -1);
    const double least = nearer * bat_gaze_pixel(&s->gaze, bead.at);
    const double most = s->gaze.focus > 0 ? vec_norm(vec_sub(s->gaze.eye, bead.at)) : INFINITY;
    /* From beyond what does not count: a ray that begins on a silhouette touches the surface there, and would cost the
     * search a thousand cells. */
    vec_store(vec_add(bead.at, vec_scale(back, least)), origin);
    vec_store(back, way);
    *hidden = false;
    for (size_t i = 0; i < s->scene->surface_count && !*hidden; i++) {
        size_t count = 0;
        bat_status status = bat_surface_finder_hits(s->finders[i], origin, way, HITS, hits, &count);
        if (status != BAT_OK) return status;
        for (size_t k = 0; k < count && k < HITS; k++)
            *hidden = *hidden || (hits[k].distance > 0 && hits[k].distance + least < most);
    }
    return BAT_OK;
}

typedef struct list {
    bat_seen_stretch *stretches;
    size_t count, room;
    bool joined; /* the next stretch may go on with the last one */
} list;

/* Goes on to a place with what is seen on the way. */
static bat_status go(list *l, double from, double to, bool hidden) {
    if (!(to > from)) return BAT_OK;
    if (l->joined && l->count > 0 && l->stretches[l->count - 1].hidden == hidden) {
        l->stretches[l->count - 1].to = to;
        return BAT_OK;
    }
    if (l->count == l->room) {
        const size_t room = 2 * l->room + 8;
        bat_seen_stretch *more = realloc(l->stretches, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        l->stretches = more, l->room = room;
    }
    l->stretches[l->count++] = (bat_seen_stretch){from, to, hidden};
    l->joined = true;
    return BAT_OK;
}

/* Where visibility changes between two places that differ. */
static bat_status change(const bat_sight_scene *s, const bat_strand *strand, double low, double high,
                         bool first, double *out) {
    for (int i = 0; i < HALVINGS; i++) {
        bat_bead a, b;
        bool hidden;
        bat_strand_locate(s, strand, low, &a);
        bat_strand_locate(s, strand, high, &b);
        if (bat_hypot(a.pixel[0] - b.pixel[0], a.pixel[1] - b.pixel[1]) < fine) break;
        bat_status status = look(s, strand, 0.5 * (low + high), &hidden);
        if (status != BAT_OK) return status;
        *(hidden == first ? &low : &high) = 0.5 * (low + high);
    }
    *out = 0.5 * (low + high);
    return BAT_OK;
}

/* Whether what lies between two splits is beyond the window, where strands are split. */
static bool is_beyond(const bat_sight_scene *s, const bat_strand *strand, double from, double to) {
    const size_t k = (size_t)fmin(fmax(floor(0.5 * (from + to)), 0), (double)(strand->count - 2));
    return bat_sight_beyond(s, &strand->beads[k], &strand->beads[k + 1]) > 0;
}

/* What lies between two splits: three rays, and where they differ the changes between them. */
static bat_status decide(const bat_sight_scene *s, const bat_strand *strand, double from, double to,
                         list *l) {
    const double at[3] = {from + 0.15 * (to - from), 0.5 * (from + to), from + 0.85 * (to - from)};
    bool hidden[3];
    bat_status status = BAT_OK;
    if (is_beyond(s, strand, from, to)) return go(l, from, to, false);
    for (int k = 0; k < 3 && status == BAT_OK; k++) status = look(s, strand, at[k], &hidden[k]);
    for (int k = 0; k < 2 && status == BAT_OK; k++) {
        double place = at[k];
        if (hidden[k] == hidden[k + 1]) continue;
        status = change(s, strand, at[k], at[k + 1], hidden[k], &place);
        if (status == BAT_OK) status = go(l, from, place, hidden[k]);
        from = place;
    }
    return status == BAT_OK ? go(l, from, to, hidden[2]) : status;
}

bat_status bat_strand_stretches(const bat_sight_scene *s, const bat_strand *strand, bat_seen_stretch **out,
                                size_t *count) {
    list l = {.stretches = NULL};
    double from = 0;
    bat_status status = BAT_OK;
    for (size_t i = 0; i <= strand->split_count && strand->count > 1 && status == BAT_OK; i++) {
        const bool last = i == strand->split_count;
        const double to = last ? (double)(strand->count - 1) : strand->splits[i].place;
        status = decide(s, strand, from, to, &l);
        if (!last && strand->splits[i].corner) l.joined = false;
        from = to;
    }
    if (status != BAT_OK) {
        free(l.stretches);
        return status;
    }
    *out = l.stretches, *count = l.count;
    return BAT_OK;
}
