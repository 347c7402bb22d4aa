/* What belongs to a file besides its content: owner, group, mode, and extended attributes with access control lists. */
#ifndef BATTEN_APPS_LIKENESS_H
#define BATTEN_APPS_LIKENESS_H

#include <stdbool.h>

/*
 * Makes the new file `to` like the file `from`; both are open. False: not all of it could be had. Then nobody may do
 * more with the new file than with the other, except its owner: without the group, the group may do what all may.
 *
 * Not copied, as for a file that is written to: the bits that run it as its owner or group, and the attributes that speak
 * of its content (capabilities, measured hashes).
 */
bool likeness_give(int from, int to);

#endif
