#include "format/json/blend.h"
#include "format/json/word.h"

static const char *const BLENDS[] = {"cross", "magnitude", "local", NULL};
static const char *const TURNS[] = {"tangent", "frames", NULL};

bat_status bat_blend_read(const bat_fields *f, uint32_t node, bat_wire_options *out) {
    const uint32_t blend = bat_json_member(f->json, node, "blend");
    int kind = BAT_BLEND_CROSS;
    *out = bat_wire_defaults();
    if (!blend) return BAT_OK;
    bat_status status = bat_word_from_json(f->json, blend, "kind", BLENDS,
                                           "\"cross\", \"magnitude\" or \"local\"", &kind, f->problem);
    out->blend = (bat_blend)kind;
    if (status == BAT_OK)
        status = bat_fields_number(f, blend, "exponent", 1e-300, 1e300, "a number above 0", &out->exponent);
    return status;
}

void bat_blend_write(const bat_wire_options *options, bat_text *text) {
    bat_text_string(text, "{\"kind\":\"");
    bat_text_string(text, BLENDS[options->blend]);
    bat_text_string(text, "\",\"exponent\":");
    bat_text_number(text, options->exponent);
    bat_text_string(text, "}");
}

bat_status bat_turn_read(const bat_fields *f, uint32_t node, bat_wire_turn *out) {
    int turn = BAT_TURN_TANGENT;
    const bat_status status = bat_word_from_json(f->json, node, "turn", TURNS, "\"tangent\" or \"frames\"",
                                                 &turn, f->problem);
    *out = (bat_wire_turn)turn;
    return status;
}

void bat_turn_write(bat_wire_turn turn, bat_text *text) {
    if (turn == BAT_TURN_TANGENT) return;
    bat_text_string(text, ",\"turn\":\"");
    bat_text_string(text, TURNS[turn]);
    bat_text_string(text, "\"");
}
