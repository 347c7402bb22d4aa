#include "editor/edit/profile.h"

#include <math.h>
#include <string.h>

/* The stops of those with a name. */
static const struct {
    size_t count;
    bat_width_stop stops[3];
} shapes[] = {[BAT_PROFILE_EVEN] = {0},
              [BAT_PROFILE_END] = {2, {{0, 1}, {1, 0}}},
              [BAT_PROFILE_START] = {2, {{0, 0}, {1, 1}}},
              [BAT_PROFILE_BOTH] = {3, {{0, 0}, {0.5, 1}, {1, 0}}},
              [BAT_PROFILE_WAIST] = {3, {{0, 1}, {0.5, 0.3}, {1, 1}}}};

static const double GAP = 1e-6; /* between two profiles that do not meet */

static bat_width_profile own(const bat_object *object) {
    const bat_paint *paint = bat_object_paint(object);
    return paint ? (bat_width_profile){paint->width_count, paint->widths} : (bat_width_profile){0};
}

static bool same(const bat_width_profile *a, size_t count, const bat_width_stop *stops) {
    bool is = a->count == count;
    for (size_t i = 0; i < count && is; i++)
        is = a->stops[i].at == stops[i].at && a->stops[i].share == stops[i].share;
    return is;
}

bat_profile bat_profile_of(const bat_object *object) {
    const bat_width_profile profile = own(object);
    for (int k = BAT_PROFILE_EVEN; k < BAT_PROFILE_OTHER; k++)
        if (same(&profile, shapes[k].count, shapes[k].stops)) return (bat_profile)k;
    return BAT_PROFILE_OTHER;
}

bat_status bat_profile_set(const bat_object *object, size_t count, const bat_width_stop *stops,
                           bat_object **out) {
    const bat_paint *before = bat_object_paint(object);
    bat_paint paint = {0};
    if (before) paint = *before;
    paint.width_count = count, paint.widths = stops;
    return bat_object_with_paint(object, &paint, out);
}

bat_status bat_profile_give(const bat_object *object, bat_profile profile, bat_object **out) {
    const bat_width_profile kept = own(object);
    return profile == BAT_PROFILE_OTHER
               ? bat_profile_set(object, kept.count, kept.stops, out)
               : bat_profile_set(object, shapes[profile].count, shapes[profile].stops, out);
}

bat_status bat_profile_stretch(const bat_object *object, double from, double to, bat_object **out) {
    const bat_width_profile profile = own(object);
    bat_width_stop stops[BAT_WIDTHS_MAX];
    if (!profile.count) {
        *out = bat_object_retain(object);
        return BAT_OK;
    }
    return bat_profile_set(object, bat_width_stretch(&profile, from, to, stops), stops, out);
}

enum { BETWEEN = 4 }; /* parts of each gap, so that a step beside it bends no more than the last */

/* Adds the profile's value at a place of the piece from..to, of which to may lie in the next period of a closed curve. */
static size_t add_value(const bat_width_profile *profile, bool closed, const double range[2], double at,
                        bat_width_stop *out, size_t count) {
    double value[2];
    const double place = range[0] + at * (range[1] - range[0]);
    if (count >= BAT_WIDTHS_MAX || (count && !(at > out[count - 1].at + GAP))) return count;
    bat_width_eval(profile, closed, place > 1 ? place - 1 : place, value);
    out[count] = (bat_width_stop){at, value[0]};
    return count + 1;
}

/* The stops of a piece; the gaps at its ends, which are cut, get some between, so that they bend as before. */
static size_t cut_piece(const bat_width_profile *profile, bool closed, const double range[2],
                        bat_width_stop *out) {
    const size_t n = profile->count;
    size_t count = add_value(profile, closed, range, 0, out, 0);
    double last = 0, next = 1;
    for (size_t i = 0; i <= 2 * n; i++) {
        next = i < 2 * n ? (profile->stops[i % n].at + (double)(i / n) - range[0]) / (range[1] - range[0])
                         : 1;
        if (!(next > GAP)) continue;
        next = next < 1 - GAP ? next : 1;
        const int parts = last == 0 || next == 1 ? BETWEEN : 1;
        for (int k = 1; k < parts; k++)
            count = add_value(profile, closed, range, last + (next - last) * k / parts, out, count);
        if (count == BAT_WIDTHS_MAX) count--; /* the end is always there */
        count = add_value(profile, closed, range, next, out, count);
        last = next;
        if (next == 1) break;
    }
    return count;
}

bat_status bat_profile_piece(bat_object **part, const bat_object *whole, bool closed, double from,
                             double to) {
    const bat_width_profile profile = own(whole);
    bat_width_stop stops[BAT_WIDTHS_MAX];
    bat_object *made = NULL;
    if (!profile.count || !(from >= 0 && from < to && to <= from + 1)) return BAT_OK;
    const size_t count = cut_piece(&profile, closed, (double[]){from, to}, stops);
    const bat_status status = bat_profile_set(*part, count, stops, &made);
    if (status != BAT_OK) return status;
    bat_object_release(*part);
    *part = made;
    return BAT_OK;
}

/* Adds the object's profile, turned round or not, between two shares of the length, in another unit of width. */
static size_t add_part(const bat_object *object, bool turned, double low, double high, double factor,
                       bat_width_stop *stops, size_t count) {
    const bat_width_profile profile = own(object);
    bat_width_stop part[BAT_WIDTHS_MAX] = {{0, 1}, {1, 1}};
    const size_t n = profile.count ? bat_width_stretch(&profile, turned, !turned, part) : 2;
    const size_t times = n * BETWEEN < BAT_WIDTHS_MAX / 2 ? BETWEEN : 1;
    for (size_t i = 0; i < (n - 1) * times + 1 && count < BAT_WIDTHS_MAX; i++) {
        const bat_width_stop *stop = &part[i / times];
        const double between = (double)(i % times) / (double)times;
        const double place = i % times ? stop->at + between * (stop[1].at - stop->at) : stop->at;
        double value[2];
        bat_width_eval(&(bat_width_profile){n, part}, false, place, value);
        const double at = fmin(low + (high - low) * place, 1);
        if (count > 0 && at <= stops[count - 1].at + GAP / 2) continue; /* they meet there */
        stops[count++] = (bat_width_stop){at, fmin(value[0] * factor, BAT_WIDTH_SHARE_MAX)};
    }
    return count;
}

bat_status bat_profile_join(bat_object **object, const bat_object *a, bool turn_a, const bat_object *b,
                            bool turn_b, double share) {
    bat_width_stop stops[BAT_WIDTHS_MAX];
    const double width = bat_object_style(a)->width, other = bat_object_style(b)->width;
    if ((!own(a).count && !own(b).count) || !(width > 0)) return BAT_OK;
    share = fmin(fmax(share, 2 * GAP), 1 - 2 * GAP);
    size_t count = add_part(a, turn_a, 0, share, 1, stops, 0);
    double end[2], start[2] = {other / width, 0};
    const bat_width_profile first = {count, stops}, second = own(b);
    bat_width_eval(&first, false, share, end);
    if (second.count) {
        bat_width_eval(&second, false, turn_b, start);
        start[0] *= other / width;
    }
    const double from = fabs(end[0] - start[0]) > 1e-9 ? share + GAP : share; /* a step, or one stop */
    count = add_part(b, turn_b, from, 1, other / width, stops, count);
    bat_object *made = NULL;
    const bat_status status = bat_profile_set(*object, count, stops, &made);
    if (status != BAT_OK) return status;
    bat_object_release(*object);
    *object = made;
    return BAT_OK;
}
