/* Internal: tracks while they are made. */
#ifndef BATTEN_FORM_TRACKS_H
#define BATTEN_FORM_TRACKS_H

#include <batten/trace.h>

typedef struct bat_track {
    bat_track_point *points;
    size_t count, room;
    bool closed;
} bat_track;

struct bat_tracks {
    bat_track *list;
    size_t count, room;
    bat_track_point *crossings;
    size_t crossing_count, crossing_room;
    bool given_up;
};

/* How near chords are to be: as given, or else the usual; never nearer than the least, below which rounding hides it. 0: what is given is
 * below. */
static inline double bat_chord(double given, double usual, double least) {
    if (given > 0) return given < least ? 0 : given;
    return usual > least ? usual : least;
}

bat_status bat_track_add(bat_track *track, const bat_track_point *point);
/* Begins a track; NULL: no memory. It stays where it is until the next one is begun. */
bat_track *bat_tracks_begin(bat_tracks *tracks);
/* Removes the last track. */
void bat_tracks_drop(bat_tracks *tracks);
bat_status bat_tracks_cross(bat_tracks *tracks, const bat_track_point *point);
/* Frees the tracks and crossings, not the list itself. */
void bat_tracks_clear(bat_tracks *tracks);
/* Hands over a list on the heap; frees its contents when that fails. */
bat_status bat_tracks_finish(bat_tracks *made, bat_tracks **out);

#endif
