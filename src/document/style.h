#ifndef BATTEN_DOCUMENT_STYLE_H
#define BATTEN_DOCUMENT_STYLE_H

#include <batten/document.h>

uint64_t bat_style_digest(uint64_t digest, const bat_style *style);

#endif
