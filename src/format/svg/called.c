/* The names of a file's elements, without their prefixes. */
#include "format/svg/plan.h"

#include <string.h>

bool bat_svg_is_called(const bat_svg_plan *plan, uint32_t element, const char *local) {
    const bat_svg_tag *tag = &plan->tags.list[element];
    const char *name = plan->text + tag->open + 1;
    const size_t length = bat_svg_tag_name(name - 1, tag->body - tag->open), size = strlen(local);
    return length >= size && memcmp(name + length - size, local, size) == 0 &&
           (length == size || name[length - size - 1] == ':');
}
