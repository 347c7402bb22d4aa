/* Stands in for the SVG reader and writer until the library has them; left out of the build as soon as it
 * does. */
#include <batten/format.h>

bat_svg_options bat_svg_defaults(void) { return (bat_svg_options){0, 0.02}; }

bat_status bat_svg_reader_create(const bat_svg_options *options, bat_svg_reader **out) {
    (void)options;
    (void)out;
    return BAT_UNSUPPORTED;
}

bat_status bat_svg_reader_start(bat_svg_reader *reader, const char *name, const char *const *attributes) {
    (void)reader;
    (void)name;
    (void)attributes;
    return BAT_UNSUPPORTED;
}

bat_status bat_svg_reader_text(bat_svg_reader *reader, const char *text, size_t size) {
    (void)reader;
    (void)text;
    (void)size;
    return BAT_UNSUPPORTED;
}

bat_status bat_svg_reader_end(bat_svg_reader *reader) {
    (void)reader;
    return BAT_UNSUPPORTED;
}

bat_status bat_svg_reader_finish(bat_svg_reader *reader, bat_document **out, bat_svg_report *report,
                                 bat_problem *problem) {
    (void)reader;
    (void)out;
    (void)report;
    (void)problem;
    return BAT_UNSUPPORTED;
}

void bat_svg_reader_free(bat_svg_reader *reader) { (void)reader; }

void bat_svg_report_line(const bat_svg_report *report, char *line, size_t room) {
    (void)report;
    if (room) line[0] = '\0';
}

bat_status bat_svg_write(const bat_document *document, bool with_native, char **text, size_t *size) {
    (void)document;
    (void)with_native;
    (void)text;
    (void)size;
    return BAT_UNSUPPORTED;
}
