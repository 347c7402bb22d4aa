/* A picture of a drawing: its page, or what is seen of it in space. */
#ifndef BATTEN_APPS_PICTURE_H
#define BATTEN_APPS_PICTURE_H

#include "form/shade/shade.h"

#include <batten/document.h>

typedef enum picture_kind {
    PICTURE_UNKNOWN,
    PICTURE_SVG,
    PICTURE_PNG,
    PICTURE_PDF,
    PICTURE_EPS
} picture_kind;

/* "svg", "png", "pdf" or "eps", in any case. */
picture_kind picture_kind_of(const char *ending);
/* By the ending of a file's name. */
picture_kind picture_kind_called(const char *name);

/* What is asked for; {kind} is the default. */
typedef struct picture_wanted {
    picture_kind kind;
    long size[2];        /* 0: not given */
    double dpi;          /* pixels an inch; 0: not given */
    uint32_t background; /* 0xRRGGBBAA */
    bat_look look;
    const char *view; /* a VIEW, or NAME@SECONDS; NULL: not given */
    double sheet[2];  /* mm: a PDF over as many sheets as it takes; 0: one page */
    double overlap;   /* mm of the drawing on two neighbouring sheets */
} picture_wanted;

/* Makes the bytes of the file, malloc'ed, of the drawing that was read from `in`; its document forgets the file's text. Returns 0,
 * or an exit status after reporting the failure. */
int picture_make(const char *in, bat_document *document, const picture_wanted *w, unsigned char **data,
                 size_t *size);

#endif
