#include "document/style.h"

#include "document/digest.h"

bat_style bat_style_defaults(void) {
    return (bat_style){.stroked = true,
                       .stroke = 0x000000ff,
                       .fill = 0x000000ff,
                       .width = 2,
                       .opacity = 1,
                       .cap = BAT_CAP_ROUND,
                       .join = BAT_JOIN_ROUND,
                       .miter_limit = 4};
}

bool bat_style_valid(const bat_style *style) {
    return style->width >= 0 && style->width <= BAT_COORDINATE_MAX && style->opacity >= 0 &&
           style->opacity <= 1 && style->miter_limit >= 1 && style->miter_limit <= BAT_COORDINATE_MAX &&
           (unsigned)style->cap <= BAT_CAP_SQUARE && (unsigned)style->join <= BAT_JOIN_BEVEL;
}

uint64_t bat_style_digest(uint64_t digest, const bat_style *style) {
    digest = bat_digest_number(digest, style->stroked);
    digest = bat_digest_number(digest, style->filled);
    digest = bat_digest_number(digest, style->even_odd);
    digest = bat_digest_number(digest, style->stroke);
    digest = bat_digest_number(digest, style->fill);
    digest = bat_digest_double(digest, style->width);
    digest = bat_digest_double(digest, style->opacity);
    digest = bat_digest_number(digest, (uint64_t)style->cap);
    digest = bat_digest_number(digest, (uint64_t)style->join);
    return bat_digest_double(digest, style->miter_limit);
}
