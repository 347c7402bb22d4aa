/* Weak stand-ins until the SVG reader and writer are linked; to be deleted with their arrival. */
#include <batten/format.h>

#define WEAK __attribute__((weak))

WEAK bat_svg_options bat_svg_defaults(void) { return (bat_svg_options){0}; }

WEAK bat_status bat_svg_reader_create(const bat_svg_options *options, bat_svg_reader **out) {
    (void)options, (void)out;
    return BAT_UNSUPPORTED;
}

WEAK bat_status bat_svg_reader_start(bat_svg_reader *reader, const char *name,
                                     const char *const *attributes) {
    (void)reader, (void)name, (void)attributes;
    return BAT_UNSUPPORTED;
}

WEAK bat_status bat_svg_reader_text(bat_svg_reader *reader, const char *text, size_t size) {
    (void)reader, (void)text, (void)size;
    return BAT_UNSUPPORTED;
}

WEAK bat_status bat_svg_reader_end(bat_svg_reader *reader) {
    (void)reader;
    return BAT_UNSUPPORTED;
}

WEAK bat_status bat_svg_reader_finish(bat_svg_reader *reader, bat_document **out, bat_svg_report *report,
                                      bat_problem *problem) {
    (void)reader, (void)out, (void)report, (void)problem;
    return BAT_UNSUPPORTED;
}

WEAK void bat_svg_reader_free(bat_svg_reader *reader) { (void)reader; }

WEAK void bat_svg_report_line(const bat_svg_report *report, char *line, size_t room) {
    (void)report, (void)room;
    line[0] = 0;
}

WEAK bat_status bat_svg_write(const bat_document *document, bool with_native, char **text, size_t *size) {
    (void)document, (void)with_native, (void)text, (void)size;
    return BAT_UNSUPPORTED;
}
