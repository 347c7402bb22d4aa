/* Contacts of two curves: what is made of the places where they come within the gap. */
#ifndef BATTEN_SRC_RELATE_CONTACT_H
#define BATTEN_SRC_RELATE_CONTACT_H

#include <batten/relate.h>

typedef struct bat_touching {
    bat_crossing at; /* the best place of it */
    double distance; /* of the curves there */
    bool exact;      /* they cross there, not in parallel, as far as rounding tells */
    bool counted;    /* it is one exact crossing, no more; of a contact: all of its places are */
    int turn; /* how often a goes to the left of b, less to the right, at its places; set by bat_contacts_settle */
    bool alone;           /* no other place was found to belong to it; set there */
    size_t group;         /* the first place of the same contact; set there */
    bat_crossing ends[2]; /* the first and the last of its places along a; set there */
} bat_touching;

/* Makes one contact of all places between which the curves stay within the gap of each other, and gives each its kind and
 * sign. Returns how many are left, at the beginning of the array, ascending in the first place's u. */
size_t bat_contacts_settle(const bat_curve *a, const bat_curve *b, double gap, size_t count,
                           bat_touching *all);

#endif
