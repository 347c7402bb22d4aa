/* Internal to pictures: light.def for shaders. */
#ifndef BATTEN_FORM_SHADER_H
#define BATTEN_FORM_SHADER_H

/* The constants in the language of OpenGL ES 3 shaders: a constant for each BAT_SHADE and BAT_TINT by its name, and
 * `float matte(vec3 normal)`, the light on a place. */
const char *bat_shader_constants(void);

#endif
