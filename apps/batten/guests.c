#include "guests.h"

#include <sys/socket.h>

/* Whether a must leave before b. */
static bool less_wanted(const guest *a, const guest *b) {
    if (!a->socket || !b->socket) return !a->socket && b->socket;
    return a->known != b->known ? !a->known : a->heard < b->heard;
}

guest *guests_come(guest_list *list, int socket) {
    guest *place = &list->places[0];
    for (int i = 1; i < GUESTS_MAX; i++) {
        if (less_wanted(&list->places[i], place)) place = &list->places[i];
    }
    if (place->socket) shutdown(place->socket, SHUT_RDWR); /* the closing is noticed where all closings are */
    *place = (guest){.socket = socket, .heard = ++list->events};
    return place;
}

void guests_hear(guest_list *list, guest *who, bool known) {
    who->known |= known;
    who->heard = ++list->events;
}

void guests_go(guest *who, int socket) {
    if (who->socket == socket) who->socket = 0;
}
