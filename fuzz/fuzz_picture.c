/* Any bytes as a picture, and as base 64 of one: never read out of bounds; accepted pictures have valid sizes,
 * and come back from base 64 bit for bit. */
#include "document/picture.h"
#include "text/base64.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(bat_picture *picture) {
    double sides[2];
    size_t size, back;
    const void *bytes = bat_picture_bytes(picture, &size);
    bat_picture *again = NULL;
    bat_text text = {0};
    bat_picture_sides(picture, sides);
    for (int k = 0; k < 2; k++)
        if (!(sides[k] >= 1 && sides[k] <= BAT_PICTURE_SIDE)) abort();
    bat_base64_write(&text, bytes, size);
    if (bat_picture_from_base64(text.data, text.size, &again) != BAT_OK) abort();
    const void *read = bat_picture_bytes(again, &back);
    if (back != size || memcmp(bytes, read, size) != 0) abort();
    if (bat_picture_digest(picture) != bat_picture_digest(again)) abort();
    bat_text_free(&text);
    bat_picture_release(again);
    bat_picture_release(picture);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bat_picture *picture = NULL;
    bat_problem problem;
    if ((bat_picture_create(data, size, &picture) == BAT_OK) !=
        (bat_picture_check(data, size, &problem) == BAT_OK))
        abort();
    if (picture) check(picture);
    if (bat_picture_from_base64((const char *)data, size, &picture) == BAT_OK) check(picture);
    return 0;
}
