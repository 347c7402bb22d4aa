#include "text/base64.h"
#include "document/picture.h"

#include "document/digest.h"
#include "base/users.h"
#include "text/json.h"

#include <stdlib.h>
#include <string.h>

struct bat_picture {
    bat_users users;
    uint32_t width, height;
    const char *type;
    uint64_t digest;
    size_t size;
    unsigned char bytes[];
};

/* The type of a picture and its sides. */
static bat_status look(const void *bytes, size_t size, const char **type, uint32_t sides[2],
                       bat_problem *problem) {
    if (!bytes) return bat_problem_set(problem, BAT_ARGUMENT, "bytes", "expected a picture, found none");
    if (bat_problem_outside(problem, "size", 0, 0, (double)BAT_PICTURE_SIZE, (double)size)) return BAT_COUNT;
    *type = bat_picture_head(bytes, size, &sides[0], &sides[1]);
    return *type ? BAT_OK
                 : bat_problem_set(problem, BAT_UNSUPPORTED, "bytes",
                                   "expected the head of a PNG, JPEG or WebP file, or of an SVG file that "
                                   "stands alone, of up to 65535 pixels a side");
}

bat_status bat_picture_check(const void *bytes, size_t size, bat_problem *problem) {
    const char *type;
    return look(bytes, size, &type, (uint32_t[2]){0}, problem);
}

bat_status bat_picture_create(const void *bytes, size_t size, bat_picture **out) {
    uint32_t sides[2];
    const char *type;
    if (!out) return BAT_ARGUMENT;
    const bat_status status = look(bytes, size, &type, sides, NULL);
    if (status != BAT_OK) return status;
    bat_picture *picture = malloc(sizeof *picture + size);
    if (!picture) return BAT_MEMORY;
    *picture = (bat_picture){
        .users = BAT_USERS_ONE, .width = sides[0], .height = sides[1], .type = type, .size = size};
    picture->digest = bat_digest_bytes(bat_digest_begin(), bytes, size);
    memcpy(picture->bytes, bytes, size);
    *out = picture;
    return BAT_OK;
}

bat_picture *bat_picture_retain(const bat_picture *picture) {
    bat_picture *user = (bat_picture *)picture; /* the reference count is not part of the value */
    if (user) bat_users_add(&user->users);
    return user;
}

void bat_picture_release(bat_picture *picture) {
    if (picture && bat_users_drop(&picture->users)) free(picture);
}

const void *bat_picture_bytes(const bat_picture *picture, size_t *size) {
    if (size) *size = picture->size;
    return picture->bytes;
}
const char *bat_picture_type(const bat_picture *picture) { return picture->type; }
bool bat_picture_is_drawing(const bat_picture *picture) { return picture->type[6] == 's'; }
uint64_t bat_picture_digest(const bat_picture *picture) { return picture->digest; }
void bat_picture_sides(const bat_picture *picture, double sides[2]) {
    sides[0] = picture->width, sides[1] = picture->height;
}

void bat_pictures_free(bat_pictures *pictures) {
    for (int i = 0; i < pictures->count; i++) bat_picture_release(pictures->list[i]);
    free(pictures->list);
    *pictures = (bat_pictures){0};
}

const bat_picture *bat_pictures_find(const bat_pictures *pictures, uint64_t digest) {
    for (int i = 0; i < pictures->count; i++)
        if (pictures->list[i]->digest == digest) return pictures->list[i];
    return NULL;
}

bat_status bat_pictures_add(bat_pictures *pictures, const bat_picture *picture) {
    const bat_picture *known = bat_pictures_find(pictures, picture->digest);
    if (known) {
        bool same = known->size == picture->size && !memcmp(known->bytes, picture->bytes, known->size);
        return same ? BAT_OK : BAT_ARGUMENT;
    }
    if (picture->size > BAT_PICTURES_SIZE - pictures->size) return BAT_COUNT;
    if (pictures->count == pictures->room) {
        int room = 2 * pictures->room + 4;
        bat_picture **list = realloc(pictures->list, (size_t)room * sizeof *list);
        if (!list) return BAT_MEMORY;
        pictures->list = list;
        pictures->room = room;
    }
    pictures->list[pictures->count++] = bat_picture_retain(picture);
    pictures->size += picture->size;
    return BAT_OK;
}

void bat_pictures_drop(bat_pictures *pictures) {
    bat_picture *last = pictures->list[--pictures->count];
    pictures->size -= last->size;
    bat_picture_release(last);
}

bat_status bat_picture_from_base64(const char *text, size_t size, bat_picture **out) {
    unsigned char *bytes = malloc(size / 4 * 3 + 3);
    size_t made;
    if (!bytes) return BAT_MEMORY;
    bat_status status = bat_base64_read(text, size, bytes, &made);
    if (status == BAT_OK) status = bat_picture_create(bytes, made, out);
    free(bytes);
    return status;
}
