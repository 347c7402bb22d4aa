/* A wire with the parameters of its reference, from which it was redrawn. */
#ifndef BATTEN_FORM_WIRE_MATCH_H
#define BATTEN_FORM_WIRE_MATCH_H

#include <batten/curve.h>

/* The same curve over the reference's domain. Where it begins and ends as the reference does, span by span, its parameters
 * there are the reference's, so that what was not redrawn stays where it is; in between, and of closed curves all over, they
 * are spread evenly. Where the parts join it is continuous, and smooth but for its speed. *out NULL with BAT_OK: it has that
 * domain already. BAT_ARGUMENT: one is closed, the other open. O(points + knots). */
bat_status bat_wire_match(const bat_curve *reference, const bat_curve *curve, bat_curve **out);

#endif
