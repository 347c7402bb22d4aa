/*
 * Who is connected to the server. Everybody is let in: when all places are taken, somebody else goes. First those
 * who have never shown the token, and of them the one who has been silent longest. So idle connections, however
 * many and from whatever address, keep nobody out.
 */
#ifndef BATTEN_APPS_GUESTS_H
#define BATTEN_APPS_GUESTS_H

#include <stdbool.h>
#include <stdint.h>

enum { GUESTS_MAX = 64 };

typedef struct guest {
    int socket; /* 0: a free place */
    bool known;
    uint64_t heard; /* when it came or asked last, counted in such events */
} guest;

typedef struct guest_list {
    guest places[GUESTS_MAX];
    uint64_t events;
} guest_list;

/* A place for the connection. Whoever had it is disconnected. */
guest *guests_come(guest_list *list, int socket);
/* It asked for something, with the token or without. */
void guests_hear(guest_list *list, guest *who, bool known);
/* The connection has ended. The place may be another's by now. */
void guests_go(guest *who, int socket);

#endif
