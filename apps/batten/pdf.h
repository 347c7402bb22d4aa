/* The first page of a PDF (or of an .ai file, which is one), as SVG, by poppler's pdftocairo, run as a program. */
#ifndef BATTEN_APPS_PDF_H
#define BATTEN_APPS_PDF_H

#include <stdbool.h>
#include <stddef.h>

bool pdf_is_one(const char *data, size_t size);
/* PostScript: EPS, with or without a preview before it, and .ai files of old. */
bool pdf_is_postscript(const char *data, size_t size);
/* *svg: malloc'ed, zero-terminated. Returns NULL, or what went wrong (static storage). */
const char *pdf_first_page(const char *data, size_t size, char **svg, size_t *svg_size);

#endif
