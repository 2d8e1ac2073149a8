#if defined(SPRITE) || defined(PHOTO)
uniform sampler2D u_image;
#endif
#ifdef PHOTO
uniform mat3 u_onto;
#endif

flat in vec4 v_fill;
#if defined(BOX) || defined(DOT)
flat in vec4 v_rim;
flat in vec4 v_box;
flat in vec4 v_bends;
#endif
#ifdef DOT
flat in float v_size;
#else
in vec4 v_at;
#endif

out vec4 f_colour;

// What is painted holds blue, green, red, alpha, which OpenGL ES cannot upload by name.
void main() {
#ifdef DOT
    vec2 place = (gl_PointCoord - 0.5) * v_size;
#elif defined(BOX)
    vec2 place = v_at.xy;
#endif
#if defined(BOX) || defined(DOT)
    // With rounded corners, filled, and with a rim about its edge: a disc and a line are such boxes too.
    vec2 joint = vec2(v_box.x - v_box.z, 0.0);
    // Where a line bends, each of its pieces keeps to its own side.
    bool is_mine = dot(place + joint, v_bends.xy) >= 0.0 && dot(place - joint, v_bends.zw) <= 0.0;
    vec2 beyond = abs(place) - v_box.xy + v_box.z;
    float away = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - v_box.z;
    vec4 fill = v_fill * clamp(0.5 - away, 0.0, min(1.0, 2.0 * min(v_box.x, v_box.y)));
    vec4 rim = v_rim * clamp(0.5 * v_box.w + 0.5 - abs(away), 0.0, min(1.0, v_box.w));
    f_colour = is_mine ? rim + fill * (1.0 - rim.a) : vec4(0.0);
#elif defined(SPRITE)
    f_colour = texelFetch(u_image, ivec2(v_at.xy), 0).bgra * v_fill.a;
#elif defined(PHOTO)
    vec3 place = u_onto * vec3(v_at.xy, 1.0);
    f_colour = texture(u_image, place.xy / place.z).bgra * v_fill.a;
#else
    f_colour = v_fill * clamp(min(min(v_at.x, v_at.y), min(v_at.z, v_at.w)) + 0.5, 0.0, 1.0);
#endif
}
