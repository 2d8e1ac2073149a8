uniform sampler2D u_image;

in vec2 v_place;

out vec4 f_colour;

void main() {
    // Painted images hold blue, green, red, alpha in memory, which OpenGL ES cannot upload by name.
    f_colour = texture(u_image, v_place).bgra;
}
