/* Strokes whose width changes along them, for plotters and cutters, which follow lines. */
#ifndef BATTEN_APPS_STROKES_H
#define BATTEN_APPS_STROKES_H

#include <batten/document.h>

#define OPTION_OUTLINE "--outline"

/* Each becomes a line of one width, that of its style. *count: how many did. The document may have changed on failure, here and
 * below. */
bat_status strokes_even(bat_document *document, int *count);
/* Each becomes the outline of what it covers, filled. */
bat_status strokes_outlined(bat_document *document);

#endif
