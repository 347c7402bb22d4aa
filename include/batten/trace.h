/*
 * Batten: curves that surfaces have in a view or with each other: silhouettes, sections by a plane, intersections. They
 * are traced as polylines, each point with its parameters on the surfaces (docs/math/surfaces.md).
 */
#ifndef BATTEN_TRACE_H
#define BATTEN_TRACE_H

#include <batten/view.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A point of a track, and where it lies on the surface. */
typedef struct bat_track_point {
    double point[3];
    double uv[2];       /* in the domain; from one point to the next it may jump by a period */
    double other_uv[2]; /* on the other surface, where there is one; else 0 */
} bat_track_point;

/* A list of tracks. A track is a polyline without branches; a closed one ends at its first point, given again. */
typedef struct bat_tracks bat_tracks;

BAT_API void bat_tracks_free(bat_tracks *tracks); /* NULL is fine */
BAT_API size_t bat_tracks_count(const bat_tracks *tracks);
/* The points of track i, owned by the list; returns how many there are, at least 2. No such
 * track: NULL and 0. */
BAT_API size_t bat_tracks_points(const bat_tracks *tracks, size_t i, const bat_track_point **points);
/* false: no such track. */
BAT_API bool bat_tracks_is_closed(const bat_tracks *tracks, size_t i);
/* Places where tracks cross or touch; they end there. NULL: no such crossing. */
BAT_API size_t bat_tracks_crossing_count(const bat_tracks *tracks);
BAT_API const bat_track_point *bat_tracks_crossing(const bat_tracks *tracks, size_t i);
/* Whether tracing was given up: there are more than 64 crossings, as where a surface is touched along a curve. Silhouettes
 * and sections have no tracks then. */
BAT_API bool bat_tracks_is_given_up(const bat_tracks *tracks);

/*
 * The silhouettes of a surface in a view: where it turns from facing the eye to facing away. The polylines' chords are
 * within 3e-3 pixels of them in the image. Their topology is exact for the polynomials det(S_u, S_v, gaze); poles
 * and patches that are seen exactly from their edge have none. Creases (knots where the surface is not smooth) end
 * a silhouette. In perspective, what lies behind the eye is traced, too, with chords as long as they happen to be.
 * Statuses as bat_viewpoint_check. O(spans), and more where silhouettes nearly cross.
 */
BAT_API bat_status bat_surface_silhouettes(const bat_surface *surface, const bat_viewpoint *view,
                                           bat_tracks **out);
/* Where a plane cuts a surface, with chords within `tolerance` (0: 1e-6 of the surface's size). A part of the surface
 * that lies in the plane has no tracks. BAT_ARGUMENT: normal is zero, or the tolerance below 0; BAT_NUMBER: a number is
 * not finite or too large; BAT_TOLERANCE, and no tracks: the tolerance is below 1e-12 of the greatest coordinate, which
 * rounding hides. Four times as fine has twice as many points. */
BAT_API bat_status bat_surface_section(const bat_surface *surface, const double origin[3],
                                       const double normal[3], double tolerance, bat_tracks **out);

/* How the intersection of two surfaces is looked for. */
typedef struct bat_intersect_options {
    size_t size;      /* of this struct, as base.h says */
    double tolerance; /* surfaces this close touch; a loop less deep is a contact; 0: 1e-4 of the size */
    /* greatest distance of the polylines' chords; 0: 1e-6 of the size; below 1e-12 of the greatest coordinate: BAT_TOLERANCE,
     * and no tracks */
    double chord;
    double leaf; /* parts of this size, relative to the surface's, are searched one by one; 0: .03 */
} bat_intersect_options;

BAT_API void bat_intersect_options_init(bat_intersect_options *options, size_t size);
static inline bat_intersect_options bat_intersect_defaults(void) {
    bat_intersect_options options;
    bat_intersect_options_init(&options, sizeof options);
    return options;
}

/*
 * Where two surfaces meet: branches as tracks, their points on both surfaces to 1e-9 of the size (that of the smaller one);
 * and the contacts, where they touch or their branches cross, as crossings. Branches end at contacts where they cross,
 * and at the edges of the surfaces. Given up: the surfaces touch along a curve or lie on each other (the contacts found are
 * given), or over a million pairs of parts had to be looked at (no tracks). options may be NULL: the defaults. O(spans of
 * a times spans of b) for their boxes, and more where they come near each other.
 */
BAT_API bat_status bat_surface_intersect(const bat_surface *a, const bat_surface *b,
                                         const bat_intersect_options *options, bat_tracks **out);
/* Track i as a cubic spline within `tolerance` of its points, closed as the track is. Statuses of bat_fit. */
BAT_API bat_status bat_tracks_curve(const bat_tracks *tracks, size_t i, double tolerance, bat_curve **out);

#ifdef __cplusplus
}
#endif
#endif
