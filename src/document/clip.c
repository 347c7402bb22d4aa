#include "document/clip.h"

#include "base/matrix.h"
#include "base/users.h"
#include "curve/curve.h"
#include "document/digest.h"

#include <stdlib.h>

struct bat_clip {
    bat_users users;
    bat_clip *within; /* retained; NULL: everywhere */
    int regions;      /* this one and those in `within` */
    int count;
    bool even_odd;
    uint64_t digest;
    bat_picture *picture; /* of a mask, retained; else NULL */
    double matrix[6];     /* of a mask */
    bat_curve *curves[];  /* owned */
};

/* matrix NULL: as they are. */
static bat_status copy_curve(const bat_curve *curve, const double *matrix, bat_curve **out) {
    double rows[12];
    if (!curve) return BAT_ARGUMENT;
    if (bat_curve_dimension(curve) != 2) return BAT_DIMENSION;
    if (!matrix) return bat_curve_copy(curve, out);
    bat_matrix_rows(matrix, 2, rows);
    return bat_curve_transform(curve, rows, out);
}

static bat_status create(int count, bat_curve *const *curves, bool even_odd, const double *matrix,
                         const bat_clip *within, bat_clip **out) {
    if (count < 0 || (count > 0 && !curves) || !out) return BAT_ARGUMENT;
    if (count > BAT_POINTS_MAX || (within && within->regions >= BAT_CLIP_REGIONS_MAX)) return BAT_COUNT;
    bat_clip *made = malloc(sizeof *made + (size_t)count * sizeof(bat_curve *));
    if (!made) return BAT_MEMORY;
    *made = (bat_clip){.users = BAT_USERS_ONE, .even_odd = even_odd, .regions = 1};
    bat_status status = BAT_OK;
    for (; made->count < count && status == BAT_OK; made->count += status == BAT_OK)
        status = copy_curve(curves[made->count], matrix, &made->curves[made->count]);
    if (status != BAT_OK) {
        bat_clip_release(made);
        return status;
    }
    made->within = bat_clip_retain(within);
    if (within) made->regions += within->regions;
    made->digest = bat_digest_number(bat_digest_begin(), bat_clip_digest(within));
    made->digest = bat_digest_number(made->digest, (uint64_t)count << 1 | even_odd);
    for (int i = 0; i < count; i++) made->digest = bat_digest_curve(made->digest, made->curves[i]);
    *out = made;
    return BAT_OK;
}

bat_status bat_clip_create(int count, bat_curve *const *curves, bool even_odd, const bat_clip *within,
                           bat_clip **out) {
    return create(count, curves, even_odd, NULL, within, out);
}

/* Where the picture lies, from its top left on clockwise, and back. */
static void go_round(const bat_picture *picture, const double m[6], int count, double *corners) {
    double sides[2];
    bat_picture_sides(picture, sides);
    for (int i = 0; i < count; i++) {
        const double x = i == 1 || i == 2 ? sides[0] : 0, y = i == 2 || i == 3 ? sides[1] : 0;
        for (int k = 0; k < 2; k++) corners[2 * i + k] = m[k] * x + m[2 + k] * y + m[4 + k];
    }
}

static bat_status edge_of(const bat_picture *picture, const double m[6], bat_curve **out) {
    static const double knots[] = {0, 0, 1, 2, 3, 4, 4};
    double corners[10];
    go_round(picture, m, 5, corners);
    return bat_curve_create(2, 1, false, 5, corners, 7, knots, out);
}

bat_status bat_clip_mask(const bat_picture *picture, const double matrix[6], const bat_clip *within,
                         bat_clip **out) {
    bat_curve *edge = NULL;
    bat_clip *made = NULL;
    if (!picture || !matrix || !out) return BAT_ARGUMENT;
    if (!bat_are_coordinates(matrix, 6)) return BAT_NUMBER;
    const bool regular = bat_matrix_is_regular(matrix);
    bat_status status = regular ? edge_of(picture, matrix, &edge) : BAT_OK;
    if (status == BAT_OK) status = create(regular, &edge, false, NULL, within, &made);
    bat_curve_free(edge);
    if (status != BAT_OK) return status;
    if (regular) {
        made->picture = bat_picture_retain(picture);
        made->digest = bat_digest_number(made->digest, bat_picture_digest(picture));
        for (int i = 0; i < 6; i++) {
            made->matrix[i] = matrix[i] + 0.0; /* -0 is 0 */
            made->digest = bat_digest_double(made->digest, made->matrix[i]);
        }
    }
    *out = made;
    return BAT_OK;
}

bat_clip *bat_clip_retain(const bat_clip *clip) {
    bat_clip *shared = (bat_clip *)clip; /* only the count changes */
    if (shared) bat_users_add(&shared->users);
    return shared;
}

void bat_clip_release(bat_clip *clip) {
    while (clip && bat_users_drop(&clip->users)) {
        bat_clip *within = clip->within;
        for (int i = 0; i < clip->count; i++) bat_curve_free(clip->curves[i]);
        bat_picture_release(clip->picture);
        free(clip);
        clip = within;
    }
}

/* One region in the place of `region`, mapped, within `within`. */
static bat_status remake(const bat_clip *region, const double *matrix, const bat_clip *within,
                         bat_clip **out) {
    double own[6];
    if (!region->picture) return create(region->count, region->curves, region->even_odd, matrix, within, out);
    if (!matrix) return bat_clip_mask(region->picture, region->matrix, within, out);
    bat_matrix_compose(matrix, region->matrix, own);
    return bat_clip_mask(region->picture, own, within, out);
}

/* The regions mapped by a matrix (NULL: as they are), and within `within` besides. */
static bat_status stack(const bat_clip *clip, const double *matrix, const bat_clip *within, bat_clip **out) {
    const bat_clip *list[BAT_CLIP_REGIONS_MAX];
    int count = 0;
    for (const bat_clip *at = clip; at; at = at->within) list[count++] = at;
    bat_clip *made = bat_clip_retain(within);
    while (count-- > 0) {
        bat_clip *next = NULL;
        const bat_status status = remake(list[count], matrix, made, &next);
        bat_clip_release(made);
        if (status != BAT_OK) return status;
        made = next;
    }
    *out = made;
    return BAT_OK;
}

bat_status bat_clip_join(const bat_clip *clip, const bat_clip *within, bat_clip **out) {
    if (clip && within) return stack(clip, NULL, within, out);
    *out = bat_clip_retain(clip ? clip : within);
    return BAT_OK;
}

bat_status bat_clip_mapped(const bat_clip *clip, const double matrix[6], bat_clip **out) {
    return stack(clip, matrix, NULL, out);
}

uint64_t bat_clip_digest(const bat_clip *clip) { return clip ? clip->digest : 0; }
const bat_clip *bat_clip_within(const bat_clip *clip) { return clip ? clip->within : NULL; }
int bat_clip_curve_count(const bat_clip *clip) { return clip ? clip->count : 0; }
const bat_curve *bat_clip_curve(const bat_clip *clip, int index) { return clip->curves[index]; }
bool bat_clip_is_even_odd(const bat_clip *clip) { return clip && clip->even_odd; }
int bat_clip_count(const bat_clip *clip) { return clip ? clip->regions : 0; }
const bat_picture *bat_clip_picture(const bat_clip *clip) { return clip ? clip->picture : NULL; }
const double *bat_clip_matrix(const bat_clip *clip) { return clip->matrix; }
void bat_clip_corners(const bat_clip *clip, double corners[8]) {
    go_round(clip->picture, clip->matrix, 4, corners);
}
