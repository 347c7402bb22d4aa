/* A shape with levels, as stored in an object. */
#ifndef BATTEN_DOCUMENT_LEVELLED_H
#define BATTEN_DOCUMENT_LEVELLED_H

#include <batten/levels.h>

/* Adds what the shape is made from: base, knots, details, gains, rules. The curves follow from these. */
uint64_t bat_digest_shape(uint64_t digest, const bat_shape *shape);
/* NULL, or what is wrong. The finest curve must be what base and details give, up to rounding. */
const char *bat_shape_check_kept(const bat_shape *shape);

#endif
