#include "document/style.h"

#include "document/digest.h"
#include "text/json.h"

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

bat_status bat_style_check(const bat_style *style, bat_problem *problem) {
    if (!style) return bat_problem_set(problem, BAT_ARGUMENT, "style", "expected a style, found none");
    return bat_problem_outside(problem, "width", 0, 0, BAT_COORDINATE_MAX, style->width) ||
                   bat_problem_outside(problem, "opacity", 0, 0, 1, style->opacity) ||
                   bat_problem_outside(problem, "miter_limit", 0, 1, BAT_COORDINATE_MAX,
                                       style->miter_limit) ||
                   bat_problem_outside(problem, "cap", 0, 0, BAT_CAP_SQUARE, (double)style->cap) ||
                   bat_problem_outside(problem, "join", 0, 0, BAT_JOIN_BEVEL, (double)style->join)
               ? BAT_ARGUMENT
               : BAT_OK;
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
