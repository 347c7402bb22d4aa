/* JSON (RFC 8259), read into a compact tree. Texts are UTF-8 without U+0000; numbers are correctly rounded and
 * finite; of several members with the same name the last counts. JSON is written with the bat_text calls. */
#ifndef BATTEN_TEXT_JSON_H
#define BATTEN_TEXT_JSON_H

#include <batten/base.h>

enum { BAT_JSON_DEPTH = 64 };
#define BAT_JSON_SIZE ((size_t)1 << 28) /* bytes of text */

typedef enum bat_json_type {
    BAT_JSON_NULL,
    BAT_JSON_FALSE,
    BAT_JSON_TRUE,
    BAT_JSON_NUMBER,
    BAT_JSON_TEXT,
    BAT_JSON_LIST,
    BAT_JSON_OBJECT
} bat_json_type;

typedef struct bat_json_node {
    union {
        double number;
        struct {
            uint32_t at, size; /* text: offset and length in `strings`; zero-terminated */
        } text;
        struct {
            uint32_t first, count; /* list: items; object: members, each a text (its name) and then a value */
        } list;
    } value;
    uint32_t next;     /* the next item; 0: none */
    uint32_t position; /* in the text */
    uint8_t type;      /* bat_json_type */
} bat_json_node;

typedef struct bat_json {
    const char *text; /* borrowed */
    size_t size;
    bat_json_node *nodes; /* node 1 is the root; 0 means "not there" */
    uint32_t count, room;
    char *strings;
} bat_json;

/* BAT_SYNTAX, BAT_NUMBER (1e999), BAT_COUNT (too long or too deep), BAT_MEMORY. Releases everything on
 * failure. */
bat_status bat_json_parse(const char *text, size_t size, bat_json *out, bat_problem *problem);
void bat_json_free(bat_json *json);

bat_json_type bat_json_type_of(const bat_json *json, uint32_t node);
/* The member's value; 0 when the node is not an object or has no such member. */
uint32_t bat_json_member(const bat_json *json, uint32_t object, const char *name);
/* First item of a list, 0 when the list is empty or the node is not a list; then follow nodes[].next. */
uint32_t bat_json_first(const bat_json *json, uint32_t list);
uint32_t bat_json_count(const bat_json *json, uint32_t list);   /* items; 0 when it is not a list */
const char *bat_json_text(const bat_json *json, uint32_t node); /* NULL when it is not a text */

/* Fills problem (may be NULL): place "line L, column C", message "what: expected ..., found ...". The "found"
 * part comes from the node's type; it is "none" for an object in which the member `what` is missing. Returns status. */
bat_status bat_json_complain(const bat_json *json, uint32_t node, bat_status status, const char *what,
                             const char *expected, bat_problem *problem);
/* The same with any message. */
bat_status bat_json_say(const bat_json *json, uint32_t node, bat_status status, const char *message,
                        bat_problem *problem);
/* Fills problem (may be NULL) with the given texts. Returns status. */
bat_status bat_problem_set(bat_problem *problem, bat_status status, const char *place, const char *message);
/* The same for a number that is not what was expected; place may have a "%zu" for the index. */
bat_status bat_problem_found(bat_problem *problem, bat_status status, const char *place, size_t index,
                             const char *expected, double found);
/* Whether a number is not from low to high (NaN is not); if so, that is said as above. */
bool bat_problem_outside(bat_problem *problem, const char *place, size_t index, double low, double high,
                         double found);
/* Puts what a place is in before it: "fill" makes "stops[1].at" "fill.stops[1].at". Returns status. */
bat_status bat_problem_inside(bat_problem *problem, bat_status status, const char *name);

#endif
