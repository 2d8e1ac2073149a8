uniform sampler2D u_image;

out vec4 f_colour;

void main() {
    // The image's first row is the upper one; it holds blue, green, red, alpha, which OpenGL ES cannot upload by name.
    ivec2 place = ivec2(gl_FragCoord.xy);
    place.y = textureSize(u_image, 0).y - 1 - place.y;
    f_colour = texelFetch(u_image, place, 0).bgra;
}
