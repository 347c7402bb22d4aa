#include "editor/session/replaced.h"

#include <stdint.h>
#include <stdlib.h>

/* The slot that holds the index, or where it belongs. */
static int *place_of(const bat_replaced *replaced, int index) {
    unsigned mask = (1U << replaced->bits) - 1,
             place = (uint32_t)index * 0x9e3779b9U >> (32 - replaced->bits);
    while (replaced->places[2 * place + 1] && replaced->places[2 * place] != index)
        place = (place + 1) & mask;
    return &replaced->places[(size_t)2 * place];
}

int bat_replaced_find(const bat_replaced *replaced, int index) {
    return replaced->bits ? place_of(replaced, index)[1] - 1 : -1;
}

bat_status bat_replaced_reserve(bat_replaced *replaced) {
    if (replaced->bits && 2 * (replaced->count + 1) <= 1 << replaced->bits) return BAT_OK;
    bat_replaced larger = {.bits = replaced->bits ? replaced->bits + 1 : 3};
    larger.places = calloc((size_t)2 << larger.bits, sizeof *larger.places);
    if (!larger.places) return BAT_MEMORY;
    for (size_t i = 0; replaced->bits && i < (size_t)1 << replaced->bits; i++)
        if (replaced->places[2 * i + 1])
            bat_replaced_add(&larger, replaced->places[2 * i], replaced->places[2 * i + 1] - 1);
    bat_replaced_clear(replaced);
    *replaced = larger;
    return BAT_OK;
}

void bat_replaced_add(bat_replaced *replaced, int index, int number) {
    int *place = place_of(replaced, index);
    place[0] = index;
    place[1] = number + 1;
    replaced->count++;
}

void bat_replaced_clear(bat_replaced *replaced) {
    free(replaced->places);
    *replaced = (bat_replaced){0};
}
