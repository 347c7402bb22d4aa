/* What of an object is seen: regions of the page, all of which it must lie in, and masks. Immutable, reference-counted, shared
 * by the copies of an object. */
#ifndef BATTEN_DOCUMENT_CLIP_H
#define BATTEN_DOCUMENT_CLIP_H

#include <batten/document.h>

enum { BAT_CLIP_REGIONS_MAX = 16 };

/* A region or a mask, and those within which it lies. */
typedef struct bat_clip bat_clip;

/* What the curves enclose (copied; planar; none: nothing is seen), within `within` (retained; NULL: everywhere).
 * BAT_COUNT: too many regions or curves. */
bat_status bat_clip_create(int count, bat_curve *const *curves, bool even_odd, const bat_clip *within,
                           bat_clip **out);
/* A mask: as much is seen as the picture (retained) covers, by its alpha; beyond it nothing. matrix: from its pixels. The region
 * is that of the picture. A matrix that is not regular: nothing is seen. BAT_NUMBER: no coordinates. Else as above. */
bat_status bat_clip_mask(const bat_picture *picture, const double matrix[6], const bat_clip *within,
                         bat_clip **out);
bat_clip *bat_clip_retain(const bat_clip *clip); /* NULL is fine, here and below */
void bat_clip_release(bat_clip *clip);
/* The regions of both, one of which may be NULL. */
bat_status bat_clip_join(const bat_clip *clip, const bat_clip *within, bat_clip **out);
/* The image under a matrix of base/matrix.h. */
bat_status bat_clip_mapped(const bat_clip *clip, const double matrix[6], bat_clip **out);
uint64_t bat_clip_digest(const bat_clip *clip); /* 0: NULL */

/* The regions, one after the other; NULL: there are no more. */
const bat_clip *bat_clip_within(const bat_clip *clip);
int bat_clip_curve_count(const bat_clip *clip);
const bat_curve *bat_clip_curve(const bat_clip *clip, int index);
bool bat_clip_is_even_odd(const bat_clip *clip);
int bat_clip_count(const bat_clip *clip);                       /* of regions */
const bat_picture *bat_clip_picture(const bat_clip *clip);      /* NULL: it is no mask */
const double *bat_clip_matrix(const bat_clip *clip);            /* of a mask, here and below */
void bat_clip_corners(const bat_clip *clip, double corners[8]); /* as bat_object_corners */

/* A copy that is seen only there; NULL: everywhere. BAT_ARGUMENT: objects of this kind paint and hold nothing. */
bat_status bat_object_with_clip(const bat_object *object, const bat_clip *clip, bat_object **out);
const bat_clip *bat_object_clip(const bat_object *object); /* NULL: it is seen everywhere */

#endif
