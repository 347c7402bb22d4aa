/* Reading, copying, turning and levels of camera moves survive the failure of any one of their allocations: BAT_MEMORY, the
 * move as it was, nothing leaked. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/camera.h>
#include "support/alloc_fail.h"

#define PATH                                                                                                 \
    "{\"degree\":2,\"closed\":true,\"knots\":[0,1,2,3,4],\"points\":[[0,0,9],[4,0,9],[4,4,9],[0,4,8]]}"
#define KEYS                                                                                                 \
    "{\"degree\":1,\"closed\":true,\"knots\":[0,1,2,3],\"points\":[[0,0,0,1],[0,0,1,1],[0,0,1,-0.5]]}"
#define TARGET "{\"degree\":1,\"closed\":false,\"knots\":[0,0,1,1],\"points\":[[2,2,0],[3,1,0]]}"
#define LEVEL "\"levels\":[{\"knots\":[0,2,3,5],\"details\":[[0,0,0.1],[0.1,0,0],[0,0.2,0]]}]"
#define TIMING                                                                                               \
    "\"timing\":{\"duration\":3,\"curve\":{\"degree\":1,\"closed\":false,\"knots\":[0,0,1,1],\"values\":[0," \
    "1]}}"

static const char *const MOVES[] = {
    "{\"path\":" PATH ",\"orientation\":{\"mode\":\"free\",\"base\":" KEYS "," LEVEL "}," TIMING "}",
    "{\"path\":{\"base\":" PATH ",\"levels\":[]},\"orientation\":{\"mode\":\"along\",\"base\":" KEYS "," LEVEL
    "}}",
    "{\"path\":" PATH ",\"orientation\":{\"mode\":\"look-at\",\"up\":[0,0,1],\"target\":" TARGET "," LEVEL
    "},"
    "\"fov\":{\"degree\":1,\"closed\":false,\"knots\":[0,0,1,1],\"values\":[30,50]}}",
    "{\"path\":" PATH ",\"orientation\":{\"mode\":\"look-at\",\"target\":[2,2,0]}}",
};

static bat_status everything(const char *text) {
    const double rotation[4] = {0.1, 0, 0, 1};
    bat_camera *camera = NULL, *copy = NULL;
    bat_status status = bat_camera_read(text, strlen(text), &camera, NULL);
    if (status == BAT_OK) status = bat_camera_copy(camera, &copy);
    if (status == BAT_OK && bat_camera_base(copy, NULL)) {
        status = bat_camera_turn_base(copy, rotation);
        if (status == BAT_OK) status = bat_camera_turn(copy, 0, 0.5, rotation);
    }
    if (status == BAT_OK && bat_camera_levels(copy) > 0) status = bat_camera_turn(copy, 1, 0.5, rotation);
    char *bytes = NULL;
    size_t size = 0;
    if (status == BAT_OK) status = bat_gltf_write_move(camera, 1, 0.5, &bytes, &size);
    assert_true((status == BAT_OK) == (bytes != NULL));
    bat_free(bytes);
    bat_camera_free(camera), bat_camera_free(copy);
    return status;
}

static void each_allocation(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof MOVES / sizeof *MOVES; i++) {
        const long before = alloc_live();
        for (int n = 1;; n++) {
            alloc_fail_at(n);
            const bat_status status = everything(MOVES[i]);
            const bool reached = alloc_fail_reached();
            alloc_fail_at(0);
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            assert_int_equal(alloc_live(), before);
            if (!reached) break;
            assert_true(n < 1000);
        }
    }
}

static void pooling(void **state) {
    (void)state;
    double values[2] = {2, 1};
    alloc_fail_at(1);
    assert_int_equal(bat_pool_ascending(2, values), BAT_MEMORY);
    alloc_fail_at(0);
    assert_true(values[0] == 2 && values[1] == 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_allocation), cmocka_unit_test(pooling)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
