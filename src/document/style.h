#ifndef BATTEN_DOCUMENT_STYLE_H
#define BATTEN_DOCUMENT_STYLE_H

#include <batten/document.h>

bool bat_style_valid(const bat_style *style);
uint64_t bat_style_digest(uint64_t digest, const bat_style *style);

#endif
