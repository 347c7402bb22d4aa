/* A shape with levels as an object keeps it. */
#ifndef BATTEN_DOCUMENT_LEVELLED_H
#define BATTEN_DOCUMENT_LEVELLED_H

#include <batten/levels.h>

/* Of what the shape is made of: base, knots, details, gains, rules. The curves follow from them. */
uint64_t bat_digest_shape(uint64_t digest, const bat_shape *shape);
/* NULL, or what does not hold: the finest curve is what base and details give, but for rounding. */
const char *bat_shape_check_kept(const bat_shape *shape);

#endif
