#include "format/json/losses.h"

#include "document/document.h"
#include "document/source.h"

#include <limits.h>
#include <string.h>

static const char keys[BAT_LOSS_COUNT][12] = {
    [BAT_LOSS_TEXT] = "texts",        [BAT_LOSS_IMAGE] = "images",      [BAT_LOSS_GRADIENT] = "gradients",
    [BAT_LOSS_PATTERN] = "patterns",  [BAT_LOSS_CLIP] = "clips",        [BAT_LOSS_MASK] = "masks",
    [BAT_LOSS_FILTER] = "filters",    [BAT_LOSS_MARKER] = "markers",    [BAT_LOSS_DASH] = "dashes",
    [BAT_LOSS_ORDER] = "orders",      [BAT_LOSS_EFFECT] = "effects",    [BAT_LOSS_UNEVEN] = "uneven",
    [BAT_LOSS_BLEND] = "blends",      [BAT_LOSS_OPACITY] = "opacities", [BAT_LOSS_HINT] = "hints",
    [BAT_LOSS_COPY] = "copies",       [BAT_LOSS_NESTED] = "nested",     [BAT_LOSS_SWITCH] = "switches",
    [BAT_LOSS_INVISIBLE] = "hidden",  [BAT_LOSS_BROKEN] = "broken",     [BAT_LOSS_UNKNOWN] = "unknown",
    [BAT_LOSS_TITLE] = "titles",      [BAT_LOSS_LINK] = "links",        [BAT_LOSS_ANIMATION] = "animations",
    [BAT_LOSS_SCRIPT] = "scripts",    [BAT_LOSS_EMBEDDED] = "embedded", [BAT_LOSS_UNUSED] = "unused",
    [BAT_LOSS_METADATA] = "metadata", [BAT_LOSS_FOREIGN] = "foreign",   [BAT_LOSS_RULE] = "rules",
    [BAT_LOSS_PAGE] = "page",         [BAT_LOSS_NATIVE] = "native",
};

const char *bat_loss_key(bat_loss kind) { return (unsigned)kind < BAT_LOSS_COUNT ? keys[kind] : NULL; }

bool bat_loss_is_seen(bat_loss kind) {
    static const bool seen[BAT_LOSS_COUNT] = {
        [BAT_LOSS_TEXT] = true,     [BAT_LOSS_IMAGE] = true,   [BAT_LOSS_GRADIENT] = true,
        [BAT_LOSS_PATTERN] = true,  [BAT_LOSS_CLIP] = true,    [BAT_LOSS_MASK] = true,
        [BAT_LOSS_FILTER] = true,   [BAT_LOSS_MARKER] = true,  [BAT_LOSS_DASH] = true,
        [BAT_LOSS_ORDER] = true,    [BAT_LOSS_EFFECT] = true,  [BAT_LOSS_UNEVEN] = true,
        [BAT_LOSS_BLEND] = true,    [BAT_LOSS_OPACITY] = true, [BAT_LOSS_HINT] = true,
        [BAT_LOSS_NESTED] = true,   [BAT_LOSS_BROKEN] = true,  [BAT_LOSS_ANIMATION] = true,
        [BAT_LOSS_EMBEDDED] = true,
    };
    return (unsigned)kind < BAT_LOSS_COUNT && seen[kind];
}

bat_losses bat_losses_seen(const bat_losses *losses) {
    bat_losses seen = *losses;
    for (int i = 0; i < BAT_LOSS_COUNT; i++)
        if (!bat_loss_is_seen((bat_loss)i)) seen.count[i] = 0;
    return seen;
}

int bat_losses_total(const bat_losses *losses) {
    int total = 0;
    for (int i = 0; i < BAT_LOSS_COUNT; i++)
        total = losses->count[i] > INT_MAX - total ? INT_MAX : total + losses->count[i];
    return total;
}

int bat_losses_told(const bat_losses *losses, const bat_document *document) {
    const int total = bat_losses_total(losses);
    const bat_source *source = bat_document_origin(document);
    if (!total || losses->count[BAT_LOSS_NATIVE] || !source) return total;
    const bat_losses seen = bat_losses_seen(losses);
    int objects = 0;
    bat_id id = bat_source_lost_id(source, 0);
    if (!id) return bat_losses_total(&seen);
    for (int i = 1; id; id = bat_source_lost_id(source, i++)) objects += bat_document_find(document, id) >= 0;
    return objects;
}

void bat_losses_to_json(const bat_losses *losses, bat_text *text) {
    bool any = false;
    bat_text_string(text, "{");
    for (int i = 0; i < BAT_LOSS_COUNT; i++) {
        if (losses->count[i] <= 0) continue;
        if (any) bat_text_string(text, ",");
        bat_text_json_string(text, keys[i]);
        bat_text_string(text, ":");
        bat_text_integer(text, (uint64_t)losses->count[i]);
        any = true;
    }
    bat_text_string(text, "}");
}

void bat_losses_from_json(const bat_json *json, uint32_t node, bat_losses *losses) {
    for (int i = 0; i < BAT_LOSS_COUNT; i++) {
        uint32_t member = bat_json_member(json, node, keys[i]);
        double count = bat_json_type_of(json, member) == BAT_JSON_NUMBER ? json->nodes[member].value.number
                                                                         : 0;
        losses->count[i] = count >= 1 && count <= INT_MAX ? (int)count : 0;
    }
}
