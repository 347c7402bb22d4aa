/* The C glue of the browser shell: declarations shared by all files of the module. */
#ifndef BATTEN_WEB_MODULE_H
#define BATTEN_WEB_MODULE_H

#include <batten/batten.h>

/* Exports a function under its own name. Only numbers and addresses cross the boundary. */
#define MODULE_EXPORT(name) __attribute__((export_name(#name)))

/* The only import: reports to the host and does not return (the host throws). */
__attribute__((import_module("host"), import_name("panic"), noreturn)) void
module_panic(const char *file, int line, const char *text);
#define MODULE_CHECK(truth)                                                                                  \
    do {                                                                                                     \
        if (!(truth)) {                                                                                      \
            module_panic(__FILE_NAME__, __LINE__, #truth);                                                   \
        }                                                                                                    \
    } while (0)

/* Bytes owned by the host, which frees them with memory_free. */
typedef struct module_bytes {
    char *data;
    size_t size;
} module_bytes;

#endif
