/* How many use a value that never changes. Copies of one document share such values and may be on different threads,
 * so the count is atomic; where there are no threads (the module) it is a plain number. */
#ifndef BATTEN_SRC_USERS_H
#define BATTEN_SRC_USERS_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct bat_users {
    atomic_size_t count;
} bat_users;

/* What a value begins with: whoever made it. */
#define BAT_USERS_ONE ((bat_users){1})

/* One more. Needs no order: who adds a user has one. */
static inline void bat_users_add(bat_users *users) {
    atomic_fetch_add_explicit(&users->count, 1, memory_order_relaxed);
}

/* One fewer; true: it was the last, all that the others did with the value has been done, and it can go. */
static inline bool bat_users_drop(bat_users *users) {
    return atomic_fetch_sub_explicit(&users->count, 1, memory_order_acq_rel) == 1;
}

#endif
