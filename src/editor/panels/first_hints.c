#include "editor/panels/first_hints.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"

static uint32_t followed(const bat_context *c) {
    return c->settings->followed | ((1U << (uint32_t)c->settings->values[BAT_PROPERTY_FIRST_HINTS]) - 1);
}

void bat_first_follow(bat_context *c, bat_first hint) {
    double *next = &c->settings->values[BAT_PROPERTY_FIRST_HINTS];
    c->settings->followed |= 1U << hint;
    while (*next < BAT_FIRST_COUNT && c->settings->followed >> (uint32_t)*next & 1) ++*next;
}

uint32_t bat_first_shown(const bat_context *c) {
    return bat_document_count(c->session->document) ? ~followed(c) & ((1U << BAT_FIRST_COUNT) - 1) : 0;
}
