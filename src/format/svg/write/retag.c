#include "format/svg/write/retag.h"
#include "text/entities.h"

#include <string.h>

/* Offsets of a declaration in a style attribute. */
typedef struct declaration {
    size_t name, name_end, value, value_end;
} declaration;

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

static bool next_declaration(const bat_text *style, size_t *at, declaration *found) {
    const char *text = style->data;
    size_t i = *at, colon = SIZE_MAX;
    while (i < style->size && (is_space(text[i]) || text[i] == ';')) i++;
    if (i >= style->size) return false;
    found->name = i;
    char quote = 0;
    int depth = 0;
    for (; i < style->size && (quote || depth > 0 || text[i] != ';'); i++) {
        const char c = text[i];
        if (quote) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '(')
            depth++;
        else if (c == ')')
            depth -= depth > 0;
        else if (c == ':' && colon == SIZE_MAX)
            colon = i;
    }
    *at = i;
    if (colon == SIZE_MAX) colon = i;
    found->name_end = colon;
    while (found->name_end > found->name && is_space(text[found->name_end - 1])) found->name_end--;
    found->value = colon < i ? colon + 1 : i;
    while (found->value < i && is_space(text[found->value])) found->value++;
    found->value_end = i;
    while (found->value_end > found->value && is_space(text[found->value_end - 1])) found->value_end--;
    return true;
}

/* The last declaration of a property counts. */
static bool find_declaration(const bat_text *style, const char *property, declaration *found) {
    const size_t length = strlen(property);
    declaration at;
    bool any = false;
    for (size_t i = 0; next_declaration(style, &i, &at);)
        if (at.name_end - at.name == length && memcmp(style->data + at.name, property, length) == 0) {
            *found = at;
            any = true;
        }
    return any;
}

bool bat_svg_retag_has(const bat_svg_retag *r, const char *name, bat_svg_piece *piece) {
    const size_t length = strlen(name);
    size_t at = 1 + bat_svg_tag_name(r->tag, r->size);
    while (bat_svg_next_piece(r->tag, r->size, &at, piece))
        if (piece->equal - piece->name == length && memcmp(r->tag + piece->name, name, length) == 0)
            return true;
    return false;
}

void bat_svg_retag_begin(bat_svg_retag *r, const char *tag, size_t size, const char *types, size_t types_size,
                         bool sheets) {
    *r = (bat_svg_retag){.tag = tag, .size = size, .sheets = sheets};
    bat_svg_piece piece;
    r->styled = bat_svg_retag_has(r, "style", &piece);
    if (r->styled &&
        !bat_xml_decode(tag + piece.value, piece.end - piece.value, types, types_size, true, &r->style))
        r->failed = true;
    if (r->style.failed) r->failed = true;
}

void bat_svg_retag_free(bat_svg_retag *r) {
    bat_text_free(&r->values);
    bat_text_free(&r->style);
}

static bat_svg_change *change_of(bat_svg_retag *r, const char *name) {
    for (int i = 0; i < r->count; i++)
        if (strcmp(r->changes[i].name, name) == 0) return &r->changes[i];
    if (r->count == BAT_SVG_CHANGES) {
        r->failed = true;
        return &r->changes[0];
    }
    r->changes[r->count] = (bat_svg_change){.name = name};
    return &r->changes[r->count++];
}

void bat_svg_retag_set(bat_svg_retag *r, const char *name, const char *value) {
    bat_svg_piece piece;
    if (!value && !bat_svg_retag_has(r, name, &piece)) return;
    bat_svg_change *change = change_of(r, name);
    change->gone = !value;
    change->at = r->values.size;
    change->size = value ? strlen(value) : 0;
    if (value) bat_text_string(&r->values, value);
}

void bat_svg_retag_set_raw(bat_svg_retag *r, const char *name, const char *value) {
    bat_svg_retag_set(r, name, value);
    change_of(r, name)->raw = true;
}

bool bat_svg_retag_declares(const bat_svg_retag *r, const char *property) {
    declaration found;
    return find_declaration(&r->style, property, &found);
}

bool bat_svg_retag_says(const bat_svg_retag *r, const char *property) {
    declaration found;
    bat_svg_piece piece;
    return find_declaration(&r->style, property, &found) || bat_svg_retag_has(r, property, &piece);
}

void bat_svg_retag_style(bat_svg_retag *r, const char *property, const char *value) {
    bat_svg_piece piece;
    if (!bat_svg_retag_declares(r, property) && !r->sheets && !r->insists &&
        (!r->styled || bat_svg_retag_has(r, property, &piece)))
        bat_svg_retag_set(r, property, value);
    else
        bat_svg_retag_declare(r, property, value, r->insists);
}

void bat_svg_retag_declare(bat_svg_retag *r, const char *property, const char *value, bool insists) {
    declaration found;
    bat_text made = {0};
    if (find_declaration(&r->style, property, &found)) {
        bat_text_add(&made, r->style.data, found.value);
        bat_text_string(&made, value);
        if (insists) bat_text_string(&made, " !important");
        bat_text_add(&made, r->style.data + found.value_end, r->style.size - found.value_end);
    } else {
        if (r->style.size > 0) bat_text_add(&made, r->style.data, r->style.size);
        if (made.size > 0 && made.data[made.size - 1] != ';') bat_text_string(&made, ";");
        bat_text_string(&made, property);
        bat_text_string(&made, ":");
        bat_text_string(&made, value);
        if (insists) bat_text_string(&made, " !important");
    }
    if (made.failed) r->failed = true;
    bat_text_free(&r->style);
    r->style = made;
    r->restyled = true;
}

bool bat_svg_retag_changed(const bat_svg_retag *r) {
    return r->failed || r->style.failed || r->values.failed || r->count > 0 || r->restyled || r->rename ||
           r->drops;
}

static void quote(const bat_svg_retag *r, const bat_svg_change *change, bat_text *out) {
    bat_text_string(out, "\"");
    if (change->size > 0 && change->raw)
        bat_text_add(out, r->values.data + change->at, change->size);
    else if (change->size > 0)
        bat_text_xml(out, r->values.data + change->at, change->size, true);
    bat_text_string(out, "\"");
}

static void write_value(const bat_svg_retag *r, const bat_svg_change *change, bat_text *out) {
    bat_text_string(out, " ");
    bat_text_string(out, change->name);
    bat_text_string(out, "=");
    quote(r, change, out);
}

/* The tag's name, with the prefix that it had. */
static void write_name(const bat_svg_retag *r, bat_text *out) {
    const size_t length = bat_svg_tag_name(r->tag, r->size);
    const char *colon = memchr(r->tag + 1, ':', length);
    if (!r->rename)
        bat_text_add(out, r->tag + 1, length);
    else if (colon)
        bat_text_add(out, r->tag + 1, (size_t)(colon - r->tag));
    if (r->rename) bat_text_string(out, r->rename);
}

void bat_svg_retag_write(bat_svg_retag *r, bat_text *out) {
    bool used[BAT_SVG_CHANGES] = {false};
    if (r->restyled) {
        bat_svg_change *change = change_of(r, "style");
        change->at = r->values.size;
        change->size = r->style.size;
        change->gone = false;
        if (r->style.data) bat_text_add(&r->values, r->style.data, r->style.size);
    }
    if (r->failed || r->values.failed || r->style.failed) {
        out->failed = true;
        return;
    }
    bat_text_string(out, "<");
    write_name(r, out);
    size_t at = 1 + bat_svg_tag_name(r->tag, r->size);
    for (bat_svg_piece piece; bat_svg_next_piece(r->tag, r->size, &at, &piece);) {
        const char *name = r->tag + piece.name;
        const size_t length = piece.equal - piece.name;
        int k = 0;
        while (k < r->count &&
               (strlen(r->changes[k].name) != length || memcmp(r->changes[k].name, name, length) != 0))
            k++;
        if (k < r->count) {
            used[k] = true;
            if (r->changes[k].gone) continue;
            bat_text_add(out, r->tag + piece.lead, piece.value - piece.lead - 1);
            quote(r, &r->changes[k], out);
        } else if (!r->drops || !r->drops(name, length))
            bat_text_add(out, r->tag + piece.lead, piece.end + 1 - piece.lead);
    }
    for (int k = 0; k < r->count; k++)
        if (!used[k] && !r->changes[k].gone) write_value(r, &r->changes[k], out);
    bat_text_add(out, r->tag + at, r->size - at);
}

bool bat_svg_is_written_alone(const bat_svg_retag *r) {
    static const char own[] =
        "data:image/svg+xml;base64,PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHdpZHRoPSI";
    bat_svg_piece piece;
    if (!bat_svg_retag_has(r, "href", &piece)) return false;
    return piece.end - piece.value >= sizeof own && memcmp(r->tag + piece.value, own, sizeof own - 1) == 0;
}
