/* Every status has its own message; an unknown number also gets one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/base.h>

static void messages_differ(void **state) {
    (void)state;
    for (int i = BAT_OK; i <= BAT_STATE; i++) {
        assert_non_null(bat_status_message((bat_status)i));
        for (int j = 0; j < i; j++)
            assert_true(strcmp(bat_status_message((bat_status)i), bat_status_message((bat_status)j)) != 0);
    }
    assert_string_equal(bat_status_message((bat_status)99), "unknown status");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(messages_differ)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
