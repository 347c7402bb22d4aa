/* glTF 2.0 as a format of drawings, binary and as text: a mesh for each node that has one. Metres, up is y. */
#include "format/gltf/gltf.h"

static int sniff(const char *text, size_t size) {
    return bat_gltf_is_binary(text, size) || bat_gltf_is_text(text, size) ? 100 : 0;
}
static int sniff_binary(const char *text, size_t size) { return bat_gltf_is_binary(text, size) ? 100 : 0; }

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    (void)how;
    return bat_faces_read(bat_gltf_parse, text, size, out, &report->lost.count[BAT_LOSS_UNKNOWN], problem);
}

static bat_status write_binary(const bat_document *document, char **out, size_t *size, bat_problem *problem) {
    return bat_faces_write(document, 1000, true, bat_gltf_put_parts, out, size, problem);
}

static bat_status write_text(const bat_document *document, char **out, size_t *size, bat_problem *problem) {
    return bat_faces_write(document, 1000, true, bat_gltf_put_parts_as_text, out, size, problem);
}

const bat_format bat_format_of_glb = {"glb", "model/gltf-binary", false, sniff_binary, read, write_binary};
const bat_format bat_format_of_gltf = {"gltf", "model/gltf+json", false, sniff, read, write_text};
