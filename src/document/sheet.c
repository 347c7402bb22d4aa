#include "document/sheet.h"

#include <math.h>
#include <string.h>

bat_sheet bat_sheet_of(const bat_document *document) {
    bat_sheet sheet = {.scale = bat_document_scale(document),
                       .unit = bat_document_unit(document),
                       .stand = bat_document_stand(document)};
    bat_document_page(document, sheet.page);
    return sheet;
}

bat_status bat_sheet_put(bat_document *document, const bat_sheet *sheet) {
    const bat_sheet before = bat_sheet_of(document);
    bat_status status = bat_document_set_page(document, sheet->page);
    if (status == BAT_OK) status = bat_document_set_scale(document, sheet->scale, sheet->unit);
    if (status != BAT_OK) (void)bat_document_set_page(document, before.page);
    if (status == BAT_OK) bat_document_set_stand(document, sheet->stand);
    return status;
}

bool bat_sheet_has_page(const bat_sheet *sheet) { return sheet->page[2] > 0 && sheet->page[3] > 0; }

bool bat_sheet_same(const bat_sheet *a, const bat_sheet *b) {
    return memcmp(a->page, b->page, sizeof a->page) == 0 && a->scale == b->scale && a->unit == b->unit &&
           a->stand == b->stand;
}

bat_sheet bat_sheet_resized(const bat_sheet *now, const double size[2]) {
    bat_sheet sheet = *now;
    memcpy(sheet.page + 2, size, 2 * sizeof *size);
    return sheet;
}

bat_sheet bat_sheet_scaled(const bat_sheet *now, const double size[2]) {
    const double across = size[0] / now->page[2], down = size[1] / now->page[3];
    const double factor = fmin(across, down), rounding = 1e-12 * factor;
    bat_sheet sheet = *now;
    sheet.scale *= factor;
    for (int i = 0; i < 2; i++) {
        if (fabs((i ? down : across) - factor) <= rounding) continue; /* it fills this side as it did */
        sheet.page[2 + i] = size[i] / factor;
        sheet.page[i] -= (sheet.page[2 + i] - now->page[2 + i]) / 2;
    }
    return sheet;
}
