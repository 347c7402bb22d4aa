/* What is seen of a drawing: by its cameras, and as a model for other programs. */
#ifndef BATTEN_APPS_SHOT_H
#define BATTEN_APPS_SHOT_H

#include <batten/document.h>
#include <batten/format.h>

/* Whether `view` is NAME@SECONDS and a camera of the drawing has that name. */
bool is_shot(const bat_document *document, const char *view);
/* The view of that camera then, and the drawing as it is then: skeletons stand in it as they do at that time. size 0: 960 x 540.
 * Clamps the time to the moves. Returns a status of the program. */
int shot_view(const char *file, bat_document *document, const char *view, const long size[2],
              bat_viewpoint *out);
/* The visible surfaces, the meshes as one, and the curves of all else that is painted; copies. BAT_COUNT: too many vertices. */
bat_status model_shown(const bat_document *document, bat_model *out);

#endif
