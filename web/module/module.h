/* The C glue of the browser shell: what every file of the module shares. */
#ifndef BATTEN_WEB_MODULE_H
#define BATTEN_WEB_MODULE_H

#include <batten/batten.h>

/* An export under the function's own name. Numbers and addresses only cross the border. */
#define MODULE_EXPORT(name) __attribute__((export_name(#name)))

/* The one import: tells the host and does not return (the host throws). */
__attribute__((import_module("host"), import_name("panic"), noreturn)) void
module_panic(const char *file, int line, const char *text);
#define MODULE_CHECK(truth)                                                                                  \
    do {                                                                                                     \
        if (!(truth)) {                                                                                      \
            module_panic(__FILE_NAME__, __LINE__, #truth);                                                   \
        }                                                                                                    \
    } while (0)

/* Bytes handed over to the host, which frees them with memory_free. */
typedef struct module_bytes {
    char *data;
    size_t size;
} module_bytes;

#endif
