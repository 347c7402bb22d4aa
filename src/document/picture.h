/* A picture inside the document: counted, and told apart by a digest of its bytes. */
#ifndef BATTEN_SRC_PICTURE_H
#define BATTEN_SRC_PICTURE_H

#include <batten/document.h>

/* Pixels across and down, as they are meant to be seen (a JPEG's Exif may say that it lies on its side), from the
 * head of a PNG, JPEG or WebP file. The file's media type, or NULL: none of the three, or its head is broken. Reads
 * nothing beyond size; O(size) for JPEG, O(1) else. PNG 3rd edition 11.2.1; ITU-T T.81 B.2.2; RFC 9649; Exif 2.32. */
const char *bat_picture_head(const unsigned char *bytes, size_t size, uint32_t *width, uint32_t *height);

/* Some pictures, each once. All zero is none. */
typedef struct bat_pictures {
    bat_picture **list; /* retained */
    int count, room;
    size_t size; /* of their bytes */
} bat_pictures;

void bat_pictures_free(bat_pictures *pictures);
const bat_picture *bat_pictures_find(const bat_pictures *pictures, uint64_t digest); /* NULL: not there */
/* One that is there already changes nothing. BAT_COUNT: more than BAT_PICTURES_SIZE in all. BAT_ARGUMENT: another
 * one has that digest. On failure nothing changes. */
bat_status bat_pictures_add(bat_pictures *pictures, const bat_picture *picture);
void bat_pictures_drop(bat_pictures *pictures); /* the one added last */

/* The picture that the text holds; white space is passed over, as in data URIs of many lines. BAT_SYNTAX: it is not
 * base 64, or not padded; else what bat_picture_create says. */
bat_status bat_picture_from_base64(const char *text, size_t size, bat_picture **out);

#endif
