#include "format/step/tokens.h"

#include "text/number.h"

#include <string.h>

static void skip_space(bat_step_place *p) {
    for (; p->at < p->end; p->at++) {
        if (*p->at == '/' && p->end - p->at > 1 && p->at[1] == '*') {
            p->at += 2;
            while (p->at < p->end && !(*p->at == '/' && p->at[-1] == '*')) p->line += *p->at++ == '\n';
            if (p->at >= p->end) return;
        } else if (*p->at != ' ' && *p->at != '\t' && *p->at != '\r' && *p->at != '\n' && *p->at != '\f') {
            return;
        }
        p->line += *p->at == '\n';
    }
}

static bool is_digit(char c) { return c >= '0' && c <= '9'; }
static bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }

/* Up to the closing mark, which is doubled where it stands for itself. */
static bat_step_token quoted(bat_step_place *p, bat_step_type type) {
    const char *from = p->at, mark = *p->at++;
    for (; p->at < p->end; p->at++) {
        p->line += *p->at == '\n';
        if (*p->at != mark) continue;
        if (type != BAT_STEP_ENUM && p->end - p->at > 1 && p->at[1] == mark) {
            p->at++;
            continue;
        }
        p->at++;
        return (bat_step_token){.type = type, .text = from, .size = (size_t)(p->at - from)};
    }
    return (bat_step_token){.type = BAT_STEP_BAD};
}

static bat_step_token object(bat_step_place *p) {
    bat_step_token token = {.type = BAT_STEP_OBJECT};
    const char *from = ++p->at;
    for (; p->at < p->end && is_digit(*p->at); p->at++) token.number = 10 * token.number + (*p->at - '0');
    if (p->at == from || p->at - from > 15) token.type = BAT_STEP_BAD;
    return token;
}

static bat_step_token number(bat_step_place *p) {
    bat_step_token token = {.type = BAT_STEP_NUMBER};
    const char *after = bat_number_scan(p->at, p->end, &token.number);
    if (!after) return (bat_step_token){.type = BAT_STEP_BAD};
    p->at = after;
    return token;
}

static bat_step_token name(bat_step_place *p) {
    bat_step_token token = {.type = BAT_STEP_NAME, .text = p->at};
    while (p->at < p->end && (is_letter(*p->at) || is_digit(*p->at) || *p->at == '-')) p->at++;
    token.size = (size_t)(p->at - token.text);
    return token;
}

bat_step_token bat_step_next(bat_step_place *p) {
    skip_space(p);
    if (p->at >= p->end) return (bat_step_token){.type = BAT_STEP_END};
    const char c = *p->at;
    if (c == '#') return object(p);
    if (c == '\'') return quoted(p, BAT_STEP_TEXT);
    if (c == '"') return quoted(p, BAT_STEP_BITS);
    if (c == '.' && p->end - p->at > 1 && is_letter(p->at[1])) return quoted(p, BAT_STEP_ENUM);
    if (is_digit(c) || c == '+' || c == '-' || c == '.') return number(p);
    if (is_letter(c) || c == '!') {
        if (c == '!') p->at++; /* of names that are a user's own */
        return name(p);
    }
    if (c == '\0' || !strchr("(),;=*$", c)) return (bat_step_token){.type = BAT_STEP_BAD};
    p->at++;
    return (bat_step_token){.type = BAT_STEP_MARK, .mark = c};
}

bool bat_step_is(const bat_step_token *token, const char *name) {
    return token->type == BAT_STEP_NAME && token->size == strlen(name) &&
           memcmp(token->text, name, token->size) == 0;
}
