#include "form/trace/tracks.h"

#include <stdlib.h>
#include <string.h>

/* Makes room for one more element of a growing array. */
static bool grow(void **array, size_t count, size_t *room, size_t size) {
    if (count < *room) return true;
    const size_t wanted = 2 * *room + 8;
    void *more = realloc(*array, wanted * size);
    if (!more) return false;
    *array = more, *room = wanted;
    return true;
}

bat_status bat_track_add(bat_track *track, const bat_track_point *point) {
    void *points = track->points;
    if (track->count >= BAT_POINTS_MAX) return BAT_COUNT;
    if (!grow(&points, track->count, &track->room, sizeof *point)) return BAT_MEMORY;
    track->points = points;
    track->points[track->count++] = *point;
    return BAT_OK;
}

bat_track *bat_tracks_begin(bat_tracks *tracks) {
    void *list = tracks->list;
    if (!grow(&list, tracks->count, &tracks->room, sizeof *tracks->list)) return NULL;
    tracks->list = list;
    bat_track *track = &tracks->list[tracks->count++];
    *track = (bat_track){.points = NULL};
    return track;
}

void bat_tracks_drop(bat_tracks *tracks) { free(tracks->list[--tracks->count].points); }

bat_status bat_tracks_cross(bat_tracks *tracks, const bat_track_point *point) {
    void *list = tracks->crossings;
    if (!grow(&list, tracks->crossing_count, &tracks->crossing_room, sizeof *point)) return BAT_MEMORY;
    tracks->crossings = list;
    tracks->crossings[tracks->crossing_count++] = *point;
    return BAT_OK;
}

void bat_tracks_clear(bat_tracks *tracks) {
    for (size_t i = 0; i < tracks->count; i++) free(tracks->list[i].points);
    free(tracks->list);
    free(tracks->crossings);
    *tracks = (bat_tracks){.list = NULL};
}

bat_status bat_tracks_finish(bat_tracks *made, bat_tracks **out) {
    bat_tracks *kept = malloc(sizeof *kept);
    if (!kept) {
        bat_tracks_clear(made);
        return BAT_MEMORY;
    }
    *kept = *made;
    *out = kept;
    return BAT_OK;
}

void bat_tracks_free(bat_tracks *tracks) {
    if (tracks) bat_tracks_clear(tracks);
    free(tracks);
}

size_t bat_tracks_count(const bat_tracks *tracks) { return tracks->count; }

size_t bat_tracks_points(const bat_tracks *tracks, size_t i, const bat_track_point **points) {
    *points = NULL;
    if (i >= tracks->count) return 0;
    *points = tracks->list[i].points;
    return tracks->list[i].count;
}

bool bat_tracks_is_closed(const bat_tracks *tracks, size_t i) {
    return i < tracks->count && tracks->list[i].closed;
}

size_t bat_tracks_crossing_count(const bat_tracks *tracks) { return tracks->crossing_count; }

const bat_track_point *bat_tracks_crossing(const bat_tracks *tracks, size_t i) {
    return i < tracks->crossing_count ? &tracks->crossings[i] : NULL;
}

bool bat_tracks_is_given_up(const bat_tracks *tracks) { return tracks->given_up; }
