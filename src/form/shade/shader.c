#include "form/shade/shader.h"

const char *bat_shader_constants(void) {
    return
#define BAT_SHADE(name, value) "const float " #name "=float(" #value ");\n"
#define BAT_TINT(name, red, green, blue) "const vec3 " #name "=vec3(" #red "," #green "," #blue ");\n"
#include "form/shade/light.def"
        "float matte(vec3 n){return AMBIENT"
#define BAT_LIGHT(name, x, y, z, strength)                                                                   \
    "+float(" #strength ")*max(0.,(dot(n,vec3(" #x "," #y "," #z "))+WRAP)/(1.+WRAP))"
#include "form/shade/light.def"
        ";}\n";
}
