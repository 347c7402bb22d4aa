/*
 * Who is connected to the server. Everybody is let in; when all places are taken, another guest must leave: first
 * those who have never shown the token, and among them the one who has been silent longest. So idle connections,
 * however many and from whatever address, keep nobody out.
 */
#ifndef BATTEN_APPS_GUESTS_H
#define BATTEN_APPS_GUESTS_H

#include <stdbool.h>
#include <stdint.h>

enum { GUESTS_MAX = 64 };

typedef struct guest {
    int socket; /* 0: a free place */
    bool known;
    uint64_t heard; /* when it arrived or last asked, counted in such events */
} guest;

typedef struct guest_list {
    guest places[GUESTS_MAX];
    uint64_t events;
} guest_list;

/* A place for the connection. Whoever had the place is disconnected. */
guest *guests_come(guest_list *list, int socket);
/* The guest has made a request, with or without the token. */
void guests_hear(guest_list *list, guest *who, bool known);
/* The connection has ended. By now the place may belong to another. */
void guests_go(guest *who, int socket);

#endif
