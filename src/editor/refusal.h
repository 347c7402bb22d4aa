/* Why a call by name was refused. */
#ifndef BATTEN_EDITOR_REFUSAL_H
#define BATTEN_EDITOR_REFUSAL_H

#include "editor/editor.h"

/* Each returns the status, and keeps what was wrong for bat_editor_problem. */
bat_status bat_refusal_command(bat_editor *editor, bat_status status, const char *name);
bat_status bat_refusal_property(bat_editor *editor, bat_status status, const char *name, double value);
bat_status bat_refusal_text(bat_editor *editor, bat_status status, const char *name, const char *text);
bat_status bat_refusal_keys(bat_editor *editor, bat_status status, const char *name, const char *keys);

#endif
