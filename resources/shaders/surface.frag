uniform sampler2D u_colours;
uniform vec2 u_fine;
uniform vec2 u_coarse;
uniform vec4 u_line;
uniform float u_line_width;
uniform float u_pixel_ratio;

HEIGHT_SHADING in float v_height;
in vec3 v_normal;
in vec2 v_cell;

out vec4 f_colour;

// Half of the first and of the last texel of 256 lie outside the map's range.
const vec2 TEXELS = vec2(255.0 / 256.0, 0.5 / 256.0);
const vec3 KEY_LIGHT = vec3(-0.36, 0.48, 0.80);

// Coverage of lines every `period` cells; where they come closer than some pixels they fade into the surface.
float lines(vec2 period, float closest, float widest) {
    vec2 place = v_cell / period;
    vec2 per_pixel = max(fwidth(place), vec2(1e-6));
    vec2 pixels = abs(fract(place - 0.5) - 0.5) / per_pixel;
    vec2 cover = clamp(0.5 * u_line_width + 0.5 - pixels, 0.0, 1.0);
    vec2 spacing = 1.0 / (per_pixel * u_pixel_ratio);
    cover *= smoothstep(vec2(closest), vec2(widest), spacing);
    return max(cover.x, cover.y);
}

vec3 lit(vec3 colour) {
    vec3 normal = normalize(v_normal);
    normal = normal.z < 0.0 ? -normal : normal;
    float key = max(dot(normal, KEY_LIGHT), 0.0);
    float shine = pow(max(dot(normal, normalize(KEY_LIGHT + vec3(0.0, 0.0, 1.0))), 0.0), 48.0);
    return colour * (0.40 + 0.52 * key + 0.14 * normal.z) + 0.10 * shine;
}

void main() {
    vec3 colour = texture(u_colours, vec2(clamp(v_height, 0.0, 1.0) * TEXELS.x + TEXELS.y, 0.5)).rgb;
#ifdef POINTS
    vec2 from_middle = 2.0 * gl_PointCoord - 1.0;
    if (dot(from_middle, from_middle) > 1.0) discard;
    f_colour = vec4(colour, 1.0);
#else
    float line = u_line.a > 0.0 ? max(lines(u_coarse, 1.5, 4.0), 0.6 * lines(u_fine, 2.5, 9.0)) : 0.0;
#ifdef WIREFRAME
    if (line < 0.02) discard;
    f_colour = vec4(colour, 1.0) * line;
#else
#ifdef LIGHT
    colour = lit(colour);
#endif
    f_colour = vec4(mix(colour, u_line.rgb, line * u_line.a), 1.0);
#endif
#endif
}
