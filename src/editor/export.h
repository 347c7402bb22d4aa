/* The drawing in other formats, as hosts ask for it. */
#ifndef BATTEN_EDITOR_EXPORT_H
#define BATTEN_EDITOR_EXPORT_H

#include <batten/editor.h>

/* That object with all in it, or, when id is 0, that part of the drawing (bat_editor_excerpt), in a format of the table, as SVG without our data ("plain"), or as a model
 * (bat_export_model). The caller frees *bytes with bat_free. problem says why there are none. */
bat_status bat_editor_export(const bat_editor *editor, const char *format, bat_excerpt part, bat_id id,
                             char **bytes, size_t *size, bat_problem *problem);

#endif
