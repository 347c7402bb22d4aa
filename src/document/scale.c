#include "document/scale.h"

#include <math.h>

double bat_unit_corner(const bat_document *document, double corner[2]) {
    double page[4];
    bat_document_page(document, page);
    const bool given = page[2] > 0 && page[3] > 0;
    corner[0] = given ? page[0] : 0, corner[1] = given ? page[1] + page[3] : 0;
    return bat_document_scale(document);
}

bool bat_unit_is_said(const bat_document *document) {
    return bat_unit_is_said_by(bat_document_unit(document), bat_document_scale(document));
}

bool bat_unit_is_kept(const bat_document *document) {
    return bat_unit_is_said(document) || bat_document_unit(document) == BAT_UNIT_NONE;
}

bool bat_unit_same(const bat_document *a, const bat_document *b) {
    const double first = bat_document_scale(a), second = bat_document_scale(b);
    return bat_document_unit(a) == bat_document_unit(b) && fabs(first - second) <= 1e-8 * second;
}
