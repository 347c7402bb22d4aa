/* A journal, line by line. */
#ifndef BATTEN_EDITOR_REPLAY_H
#define BATTEN_EDITOR_REPLAY_H

#include "text/json.h"
#include <batten/editor.h>

/* Does what a line says. first: it holds the document that the journal begins with. */
bat_status bat_replay_line(bat_editor *editor, bool first, const bat_json *json, bat_problem *problem);
/* Whether a line says nothing: it is empty, or a remark, which begins with "#". */
bool bat_replay_skips(const char *text, size_t size);

#endif
