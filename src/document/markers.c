#include "document/markers.h"

#include "base/matrix.h"
#include "curve/curve.h"
#include "document/clip.h"
#include "document/digest.h"
#include "document/kind.h"
#include "document/paint.h"
#include "document/style.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct bat_marker {
    bat_users users;
    uint64_t digest;
    bat_marking marking;
    bat_marker_part parts[];
};

struct bat_markers {
    bat_markers_head head;
    bat_marked marked;
};

static bool is_part(const bat_marker_part *part) {
    const bat_object *object = part->object;
    if ((unsigned)part->fill >= BAT_INKS || (unsigned)part->stroke >= BAT_INKS) return false;
    return object && bat_object_leads(object) && !bat_object_markers(object) && !bat_object_parent(object) &&
           bat_curve_dimension(bat_object_curve(object, 0)) == 2;
}

static bat_status check(const bat_marking *m) {
    if ((unsigned)m->turn > BAT_MARKER_REVERSED || m->count < 0 || (m->count > 0 && !m->parts))
        return BAT_ARGUMENT;
    if (m->count > BAT_MARKER_PARTS_MAX) return BAT_COUNT;
    if (!bat_are_coordinates(&m->angle, 1) || !bat_are_coordinates(m->matrix, 6) ||
        !bat_matrix_is_regular(m->matrix))
        return BAT_NUMBER;
    if (m->clipped && (!bat_are_coordinates(m->clip, 4) || m->clip[2] < 0 || m->clip[3] < 0))
        return BAT_NUMBER;
    for (int i = 0; i < m->count; i++)
        if (!is_part(&m->parts[i])) return BAT_ARGUMENT;
    return BAT_OK;
}

/* -0 is 0. */
static uint64_t digest_numbers(uint64_t digest, const double *numbers, int count) {
    for (int i = 0; i < count; i++) digest = bat_digest_double(digest, numbers[i] + 0.0);
    return digest;
}

static uint64_t digest_part(uint64_t digest, const bat_marker_part *part) {
    const bat_object *object = part->object;
    digest = bat_digest_number(digest, (uint64_t)part->fill << 2 | (uint64_t)part->stroke);
    digest = bat_style_digest(digest, bat_object_style(object));
    for (int k = 0; k < BAT_PAINT_PARTS; k++)
        digest = bat_digest_number(digest, bat_paint_digest(bat_object_paint(object), (bat_paint_part)k));
    digest = bat_digest_number(digest, bat_clip_digest(bat_object_clip(object)));
    digest = bat_digest_number(digest, (uint64_t)bat_object_curve_count(object));
    for (int i = 0; i < bat_object_curve_count(object); i++)
        digest = bat_digest_number(digest, bat_object_curve_digest(object, i));
    return digest;
}

static uint64_t digest_marking(const bat_marking *m) {
    uint64_t digest = bat_digest_number(bat_digest_begin(), (uint64_t)m->turn << 1 | m->by_width);
    digest = digest_numbers(digest_numbers(digest, &m->angle, 1), m->matrix, 6);
    if (m->clipped) digest = digest_numbers(digest, m->clip, 4);
    for (int i = 0; i < m->count; i++) digest = digest_part(digest, &m->parts[i]);
    return digest;
}

bat_status bat_marker_create(const bat_marking *marking, bat_marker **out) {
    const bat_status status = check(marking);
    if (status != BAT_OK) return status;
    const size_t room = (size_t)marking->count * sizeof(bat_marker_part);
    bat_marker *made = malloc(sizeof *made + room);
    if (!made) return BAT_MEMORY;
    *made = (bat_marker){.users = BAT_USERS_ONE, .marking = *marking};
    if (room) memcpy(made->parts, marking->parts, room);
    made->marking.parts = made->parts;
    if (!marking->clipped) memset(made->marking.clip, 0, sizeof made->marking.clip);
    for (int i = 0; i < marking->count; i++) bat_object_retain(made->parts[i].object);
    made->digest = digest_marking(&made->marking);
    *out = made;
    return BAT_OK;
}

bat_marker *bat_marker_retain(const bat_marker *marker) {
    bat_marker *shared = (bat_marker *)marker; /* only the count changes */
    if (shared) bat_users_add(&shared->users);
    return shared;
}

void bat_marker_release(bat_marker *marker) {
    if (!marker || !bat_users_drop(&marker->users)) return;
    for (int i = 0; i < marker->marking.count; i++) bat_object_release((bat_object *)marker->parts[i].object);
    free(marker);
}

const bat_marking *bat_marker_marking(const bat_marker *marker) { return marker ? &marker->marking : NULL; }
uint64_t bat_marker_digest(const bat_marker *marker) { return marker ? marker->digest : 0; }

static void end(bat_markers *markers) {
    for (int k = 0; k < BAT_MARKER_PLACES; k++) bat_marker_release(markers->marked.markers[k]);
    free(markers);
}

bat_status bat_markers_create(const bat_marked *marked, bat_markers **out) {
    bool any = false;
    for (int k = 0; k < BAT_MARKER_PLACES; k++) any = any || marked->markers[k];
    if (!any || (unsigned)marked->order >= BAT_MARKER_ORDERS) return BAT_ARGUMENT;
    if (!bat_are_coordinates(marked->frame, 4) || !bat_matrix_is_regular(marked->frame)) return BAT_NUMBER;
    bat_markers *made = malloc(sizeof *made);
    if (!made) return BAT_MEMORY;
    *made = (bat_markers){.head = {.users = BAT_USERS_ONE, .end = end}, .marked = *marked};
    uint64_t digest = bat_digest_number(bat_digest_begin(), (uint64_t)marked->order);
    digest = digest_numbers(digest, marked->frame, 4);
    for (int k = 0; k < BAT_MARKER_PLACES; k++) {
        bat_marker_retain(marked->markers[k]);
        digest = bat_digest_number(digest, bat_marker_digest(marked->markers[k]));
    }
    made->head.digest = digest;
    *out = made;
    return BAT_OK;
}

const bat_marked *bat_markers_marked(const bat_markers *markers) { return &markers->marked; }
