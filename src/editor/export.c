#include "editor/export.h"

#include "editor/edit/excerpt.h"
#include "editor/editor.h"
#include "editor/session/session.h"
#include "format/export.h"
#include "format/formats.h"
#include "format/models.h"

#include <string.h>

bat_status bat_editor_export(const bat_editor *editor, const char *format, bat_excerpt part, bat_id id,
                             char **bytes, size_t *size, bat_problem *problem) {
    bat_document *document = NULL;
    problem->place[0] = problem->message[0] = '\0';
    bat_status status = id ? bat_excerpt_object(&editor->context, id, &document)
                           : bat_editor_excerpt(editor, part, &document);
    if (status != BAT_OK) return status;
    const bat_format *found = bat_format_named(format);
    const bat_model_format *space = bat_model_format_named(format);
    if (space && space->of_drawings) found = NULL;
    if (strcmp(format, "plain") == 0)
        status = bat_svg_write(document, false, bytes, size);
    else if (found)
        status = found->write ? found->write(document, bytes, size, problem) : BAT_ARGUMENT;
    else /* where the page stands does not depend on the part of it */
        status = bat_export_model(format, bat_stand_of(editor->context.session->document), document, bytes,
                                  size, problem);
    bat_document_free(document);
    return status;
}
