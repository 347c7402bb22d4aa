#include "editor/panels/first_hints.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"

static uint32_t followed(const bat_context *c) {
    return c->settings->followed | ((1U << (uint32_t)c->settings->values[BAT_PROPERTY_FIRST_HINTS]) - 1);
}

uint32_t bat_first_shown(const bat_context *c) {
    return bat_document_count(c->session->document) ? ~followed(c) & ((1U << BAT_FIRST_COUNT) - 1) : 0;
}
