/* Notices for the user, and requests to the host. */
#ifndef BATTEN_EDITOR_SESSION_NOTICE_H
#define BATTEN_EDITOR_SESSION_NOTICE_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"

enum { BAT_NOTICE_ROOM = 160 };

typedef struct bat_notices {
    bat_string notice; /* BAT_STRING_COUNT: none */
    char notice_text[BAT_NOTICE_ROOM];
    uint32_t notice_version;
    bat_command_id offer; /* that the notice offers to do; BAT_COMMAND_COUNT: nothing */
    uint32_t requests;    /* to the host, BAT_ASK_ bits */
} bat_notices;

/* In the language in force. */
const char *bat_word(const bat_context *c, bat_string text);
/* The same with its first `count` "%" replaced by the values, one each; cut when there is no room. */
void bat_word_fill(const bat_context *c, bat_string text, int count, const char *const *values, char *out,
                   size_t room);
/* One that says that memory ran out offers a copy of the drawing. */
void bat_notice(bat_context *c, bat_string text);
/* Sets the notice to the text with its first "%" replaced by the value. */
void bat_notice_value(bat_context *c, bat_string text, const char *value);
/* Refuses what cannot be done in a tilted view, and offers the way home. */
void bat_notice_tilted(bat_context *c);
/* Refuses a stroke on a ground that is seen edge-on, and offers to turn to it. */
void bat_notice_edge_on(bat_context *c);
/* Tells that the drawing holds a view, and offers to turn to it. */
void bat_notice_saved_view(bat_context *c);
/* Tells that the system took a stroke away, and offers to bring it back. */
void bat_notice_taken_away(bat_context *c);
/* Tells that what is drawn can be turned about its line, and offers to. */
void bat_notice_revolves(bat_context *c);
/* What the notice offered has been taken up: nothing is said any more. */
void bat_notice_taken(bat_context *c);
/* Says why a command did nothing: `why`, or where that is BAT_STRING_COUNT that it failed. Returns the status, BAT_STATE
 * where there was none. */
bat_status bat_notice_refuse(bat_context *c, bat_status status, bat_string why);
void bat_notice_failure(bat_context *c, bat_status status); /* memory ran out, or no curve was made */

#endif
