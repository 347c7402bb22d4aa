#include "document/lettering.h"

#include "base/users.h"
#include "document/digest.h"
#include "text/utf8.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct bat_lettered {
    bat_users users;
    bat_lettering lettering;
    bat_picture *picture;
    char strings[]; /* content and family */
};

bat_lettering bat_lettering_defaults(void) {
    return (bat_lettering){.content = "", .family = "sans-serif", .size = 24, .weight = 400, .line = 1.2};
}

/* ---- markup ---- */

static void put_number(bat_text *out, const char *before, double number) {
    bat_text_string(out, before);
    bat_text_number(out, number);
    bat_text_string(out, "\"");
}

/* A line that stands where it is said; one alone stands where the text does. */
static void put_line(const bat_lettering *l, int number, const char *line, size_t size, bat_text *out) {
    put_number(out, "<tspan x=\"", l->at[0]);
    put_number(out, " y=\"", l->at[1] + number * (l->line * l->size));
    bat_text_string(out, ">");
    bat_text_xml(out, line, size, false);
    bat_text_string(out, "</tspan>");
}

static void put_content(const bat_lettering *l, bat_text *out) {
    const char *line = l->content, *end = strchr(line, '\n');
    if (!end) {
        bat_text_xml(out, line, strlen(line), false);
        return;
    }
    for (int number = 0; line; number++) {
        put_line(l, number, line, end ? (size_t)(end - line) : strlen(line), out);
        line = end ? end + 1 : NULL;
        end = line ? strchr(line, '\n') : NULL;
    }
}

void bat_lettering_markup(const bat_lettering *l, uint32_t colour, bat_text *out) {
    static const char *const anchors[] = {"", " text-anchor=\"middle\"", " text-anchor=\"end\""};
    char fill[24];
    put_number(out, " xml:space=\"preserve\" x=\"", l->at[0]);
    put_number(out, " y=\"", l->at[1]);
    bat_text_string(out, " font-family=\"");
    bat_text_xml(out, l->family, strlen(l->family), true);
    put_number(out, "\" font-size=\"", l->size);
    if (l->weight != 400) put_number(out, " font-weight=\"", l->weight);
    if (l->italic) bat_text_string(out, " font-style=\"italic\"");
    if (l->spacing != 0) put_number(out, " letter-spacing=\"", l->spacing);
    bat_text_string(out, anchors[l->align]);
    snprintf(fill, sizeof fill, " fill=\"#%06lx\"", (unsigned long)(colour >> 8));
    bat_text_string(out, fill);
    if ((colour & 255) < 255) put_number(out, " fill-opacity=\"", floor((colour & 255) / 0.255 + 0.5) / 1000);
    put_number(out, " data-line=\"", l->line);
    for (int k = 0; k < 4; k++) {
        bat_text_string(out, k ? " " : " data-box=\"");
        bat_text_number(out, l->box[k]);
    }
    bat_text_string(out, "\">");
    put_content(l, out);
}

/* ---- the value ---- */

static bool is_said(const char *text) { return text && *text && bat_utf8_valid(text, strlen(text)); }

static bat_status check(const bat_lettering *l) {
    const double places[] = {l->at[0], l->at[1], l->box[0], l->box[1], l->box[2], l->box[3], l->spacing};
    if (!is_said(l->content) || !is_said(l->family) || (unsigned)l->align > BAT_ALIGN_END)
        return BAT_ARGUMENT;
    if (strlen(l->content) > BAT_LETTERING_SIZE || strlen(l->family) > BAT_LETTERING_FAMILY) return BAT_COUNT;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++)
        if (!(fabs(places[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    const bool good = l->size > 0 && l->size <= BAT_COORDINATE_MAX && l->weight >= 1 && l->weight <= 1000 &&
                      l->line >= 0 && l->line <= 100 && l->box[0] < l->box[2] && l->box[1] < l->box[3];
    return good ? BAT_OK : BAT_NUMBER;
}

static bat_status show(const bat_lettering *l, uint32_t colour, bat_picture **out) {
    bat_text text = {0};
    bat_status status = bat_drawing_open(l->box, &text) ? BAT_OK : BAT_NUMBER;
    bat_text_string(&text, "<text");
    bat_lettering_markup(l, colour, &text);
    bat_text_string(&text, "</text></svg>");
    if (text.failed) status = BAT_MEMORY;
    if (status == BAT_OK) status = bat_picture_create(text.data, text.size, out);
    bat_text_free(&text);
    return status == BAT_UNSUPPORTED ? BAT_NUMBER : status; /* a side of too many pixels */
}

bat_status bat_lettered_create(const bat_lettering *lettering, uint32_t colour, bat_lettered **out) {
    bat_status status = check(lettering);
    if (status != BAT_OK) return status;
    const size_t content = strlen(lettering->content) + 1, family = strlen(lettering->family) + 1;
    bat_lettered *made = malloc(sizeof *made + content + family);
    if (!made) return BAT_MEMORY;
    *made = (bat_lettered){.users = BAT_USERS_ONE, .lettering = *lettering};
    memcpy(made->strings, lettering->content, content);
    memcpy(made->strings + content, lettering->family, family);
    bat_lettering *own = &made->lettering;
    own->content = made->strings, own->family = made->strings + content;
    own->spacing += 0.0; /* -0 becomes 0, so that equal texts have equal bits */
    for (int k = 0; k < 4; k++) own->box[k] += 0.0;
    for (int k = 0; k < 2; k++) own->at[k] += 0.0;
    status = show(own, colour, &made->picture);
    if (status == BAT_OK)
        *out = made;
    else
        free(made);
    return status;
}

bat_lettered *bat_lettered_retain(const bat_lettered *lettered) {
    bat_lettered *user = (bat_lettered *)lettered; /* the reference count is not part of the value */
    bat_users_add(&user->users);
    return user;
}

void bat_lettered_release(bat_lettered *lettered) {
    if (!lettered || !bat_users_drop(&lettered->users)) return;
    bat_picture_release(lettered->picture);
    free(lettered);
}

const bat_lettering *bat_lettered_of(const bat_lettered *lettered) { return &lettered->lettering; }

bat_picture *bat_lettered_picture(const bat_lettered *lettered) { return lettered->picture; }

uint64_t bat_lettering_digest(uint64_t digest, const bat_lettering *l) {
    const double numbers[] = {l->size,  l->weight, l->italic, l->spacing, l->line,   l->align,
                              l->at[0], l->at[1],  l->box[0], l->box[1],  l->box[2], l->box[3]};
    digest = bat_digest_text(bat_digest_text(digest, l->content), l->family);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        digest = bat_digest_double(digest, numbers[i]);
    return digest;
}

bool bat_lettering_same(const bat_lettering *a, const bat_lettering *b) {
    return bat_lettering_digest(bat_digest_begin(), a) == bat_lettering_digest(bat_digest_begin(), b);
}
