/* Reference count of an immutable value. Copies of one document share such values and may be used on different
 * threads, so the count is atomic; where there are no threads (the WASM module) it is a plain number. */
#ifndef BATTEN_SRC_USERS_H
#define BATTEN_SRC_USERS_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct bat_users {
    atomic_size_t count;
} bat_users;

/* The count of a new value: its maker is the one user. */
#define BAT_USERS_ONE ((bat_users){1})

/* Adds a user. Needs no memory ordering: whoever adds a user already is one. */
static inline void bat_users_add(bat_users *users) {
    atomic_fetch_add_explicit(&users->count, 1, memory_order_relaxed);
}

/* Drops a user; true: it was the last. All accesses by the others are then complete, and the value can be
 * freed. */
static inline bool bat_users_drop(bat_users *users) {
    return atomic_fetch_sub_explicit(&users->count, 1, memory_order_acq_rel) == 1;
}

#endif
