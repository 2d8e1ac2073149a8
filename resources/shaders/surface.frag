uniform sampler2D u_colours;
#ifdef FACETS
uniform highp sampler2D u_samples;
uniform vec4 u_facets;
#endif
uniform vec3 u_undefined;
uniform vec4 u_below;
uniform float u_no_value;
uniform vec3 u_light_stripe;
uniform vec3 u_dark_stripe;
uniform vec3 u_degrees;
uniform float u_relief;
uniform vec2 u_cells;
uniform vec4 u_fine;
uniform vec4 u_coarse;
uniform vec4 u_line;
uniform float u_line_width;
uniform float u_logical;

#ifdef SAMPLES
flat in float v_part;
#elif !defined(FACETS)
in float v_part;
#endif
#ifdef NORMALS
#ifdef SAMPLES
in vec3 v_place;
#else
in vec3 v_normal;
#endif
in vec3 v_toward;
#endif
#ifdef CELLS
in vec2 v_cell;
#endif

out vec4 f_colour;

// Half of the first and of the last texel of 256 lie outside the map's range.
const vec2 TEXELS = vec2(255.0 / 256.0, 0.5 / 256.0);
const vec3 KEY_LIGHT = vec3(-0.36, 0.48, 0.80);
// Halfway between the light and the viewer.
const vec3 GLOSS = vec3(-0.18974, 0.25298, 0.94868);

#ifdef LINES
// Coverage of lines every `period.xy` cells, whose inverses are `period.zw`; where they come closer than some pixels
// they fade into the surface.
vec2 lines(vec4 period, vec2 pixels_per_cell, vec2 fading) {
    vec2 spacing = period.xy * pixels_per_cell;
    vec2 pixels = abs(fract(v_cell * period.zw - 0.5) - 0.5) * spacing;
    vec2 cover = clamp(0.5 * u_line_width + 0.5 - pixels, 0.0, 1.0);
    return cover * clamp(spacing * fading.x - fading.y, 0.0, 1.0);
}

float line_cover() {
    vec2 pixels_per_cell = 1.0 / max(fwidth(v_cell), vec2(1e-6));
    // From 2 to 4 logical pixels apart coarse lines appear, from 3 to 8 fine ones.
    vec2 coarse = lines(u_coarse, pixels_per_cell, vec2(0.5 * u_logical, 1.0));
    vec2 fine = lines(u_fine, pixels_per_cell, vec2(0.2 * u_logical, 0.6));
    // Of a line along the border only half lies on the surface: there it has its whole width inside.
    vec2 border = clamp(u_line_width + 0.5 - min(v_cell, u_cells - v_cell) * pixels_per_cell, 0.0, 1.0);
    vec2 cover = max(border, max(coarse, 0.6 * fine));
    return max(cover.x, cover.y);
}
#endif

#ifdef NORMALS
vec3 unit_normal() {
#ifdef SAMPLES
    // Of the facet, toward the viewer or away: that is the same to all who ask.
    return normalize(cross(dFdx(v_place), dFdy(v_place)));
#else
    return normalize(v_normal);
#endif
}
#endif

#ifdef LIGHT
vec3 lit(vec3 colour) {
    vec3 normal = unit_normal();
    normal = normal.z < 0.0 ? -normal : normal;
    float key = max(dot(normal, KEY_LIGHT), 0.0);
    float shine = max(dot(normal, GLOSS), 0.0);
    shine *= shine;
    shine *= shine;
    shine *= shine;
    shine *= shine;
    shine *= shine;
    return colour * mix(1.0, 0.52 + 0.44 * key + 0.10 * normal.z, u_relief) + 0.08 * shine * u_relief;
}
#endif

vec3 map_colour(float part) {
    return texture(u_colours, vec2(clamp(part, 0.0, 1.0) * TEXELS.x + TEXELS.y, 0.5)).rgb;
}

#ifdef UNCOLOURED
vec3 surface_colour() {
    return map_colour(0.5);
}
#elif defined(ZEBRA)
// What the surface mirrors of a room with light and dark rings around the vertical.
vec3 surface_colour() {
    vec3 mirrored = reflect(-normalize(v_toward), unit_normal());
    float stripes = degrees(acos(clamp(mirrored.y, -1.0, 1.0))) / u_degrees.x;
    float width = fwidth(stripes);
    float light = clamp((abs(fract(stripes) - 0.5) - 0.25) / max(width, 1e-6) + 0.5, 0.0, 1.0);
    // Where stripes come closer than two pixels they melt into one another.
    return mix(u_dark_stripe, u_light_stripe, mix(light, 0.5, clamp(3.0 * width - 0.75, 0.0, 1.0)));
}
#elif defined(ISOPHOTES)
// Bands of equal angle between the normal and the line of sight, with a line where one ends.
vec3 surface_colour() {
    float facing = abs(dot(normalize(v_toward), unit_normal()));
    float bands = degrees(acos(clamp(facing, 0.0, 1.0))) / u_degrees.y;
    float last = u_degrees.z / u_degrees.y - 1.0;
    float width = max(fwidth(bands), 1e-6);
    float edge = clamp(floor(bands + 0.5), 1.0, last);
    float pixels = (bands - edge) / width;
    vec3 colour = mix(map_colour((edge - 1.0) / last), map_colour(edge / last), clamp(pixels + 0.5, 0.0, 1.0));
    return colour * (1.0 - 0.45 * clamp(1.2 - abs(pixels), 0.0, 1.0) * clamp(1.5 - 4.0 * width, 0.0, 1.0));
}
#else
vec3 surface_colour() {
#ifdef FACETS
    // The value at the cell's first corner, as MATLAB's surf takes it; u runs along the rows of the texture.
    vec2 cell = clamp(floor(v_cell * u_facets.zw), vec2(0.0), u_facets.xy);
    float part = texelFetch(u_samples, ivec2(cell.yx), 0).r;
#else
    float part = v_part;
#endif
    return part < u_no_value ? u_undefined : map_colour(part);
}
#endif

void main() {
    vec3 colour = surface_colour();
#if !defined(POINTS) && !defined(WIREFRAME)
    // The triangles are wound around S_u x S_v.
    colour = gl_FrontFacing == (u_below.a < 0.0) ? mix(colour, u_below.rgb, abs(u_below.a)) : colour;
#endif
#ifdef POINTS
    vec2 from_middle = 2.0 * gl_PointCoord - 1.0;
    if (dot(from_middle, from_middle) > 1.0) discard;
#endif
#ifdef LIGHT
    colour = lit(colour);
#endif
#ifdef WIREFRAME
    float line = line_cover();
    if (line < 0.02) discard;
    f_colour = vec4(colour, 1.0) * line;
#else
#ifdef LINES
    colour = mix(colour, u_line.rgb, line_cover() * u_line.a);
#endif
    f_colour = vec4(colour, 1.0);
#endif
}
