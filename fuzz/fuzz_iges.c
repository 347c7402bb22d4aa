/* Any bytes as IGES: a model or an error status; what was read is written and reads back the same. */
#include <batten/batten.h>

#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bat_model model, again;
    bat_problem problem;
    char *text = NULL;
    size_t length = 0;
    if (bat_iges_read((const char *)data, size, &model, &problem) != BAT_OK) return 0;
    if (model.surface_count + model.curve_count == 0) abort();
    if (bat_iges_write(&model, &text, &length) != BAT_OK) abort();
    if (bat_iges_read(text, length, &again, &problem) != BAT_OK) abort();
    if (again.left_out || again.surface_count != model.surface_count) abort();
    if (again.curve_count != model.curve_count) abort();
    for (size_t i = 0; i < model.surface_count; i++)
        if (!bat_surface_is_equal(model.surfaces[i], again.surfaces[i])) abort();
    for (size_t i = 0; i < model.curve_count; i++)
        if (bat_curve_degree(model.curves[i]) != bat_curve_degree(again.curves[i])) abort();
    bat_free(text);
    bat_model_clear(&model);
    bat_model_clear(&again);
    return 0;
}
