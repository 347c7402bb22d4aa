/* Internal to 3MF: the tags of XML that bat_xml_check has found well-formed, one after the other. */
#ifndef BATTEN_FORMAT_THREEMF_TAGS_H
#define BATTEN_FORMAT_THREEMF_TAGS_H

#include <batten/base.h>

typedef struct bat_tags {
    const char *at, *end;
} bat_tags;

typedef struct bat_tag {
    const char *prefix, *name; /* of the element: before and behind the colon, not terminated */
    size_t prefix_size, name_size;
    bool opens, closes;   /* both: an element without content */
    const char *at, *end; /* its attributes */
} bat_tag;

/* False: there is none left. */
bool bat_tags_next(bat_tags *tags, bat_tag *out);
bool bat_tag_is(const bat_tag *tag, const char *name);
/* The value of an attribute of that name (any prefix), as it is written. False: it has none. O(attributes). */
bool bat_tag_find(const bat_tag *tag, const char *name, const char **value, size_t *size);
/* So many numbers, with blanks between. False: fewer, more, or something else. */
bool bat_tag_numbers(const bat_tag *tag, const char *name, int count, double *out);
/* A whole number from 0 to `most`. */
bool bat_tag_whole(const bat_tag *tag, const char *name, uint32_t most, uint32_t *out);

#endif
