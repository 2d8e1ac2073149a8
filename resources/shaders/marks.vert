// Shapes of one kind, six vertices each: two triangles that hold it. Places are pixels of the device, y downward.
uniform vec2 u_pixels;

in vec4 a_place;
in vec4 a_shape;
in vec4 a_inks;
in vec4 a_more;

flat out vec4 v_fill;
#if defined(BOX) || defined(DOT)
flat out vec4 v_rim;
flat out vec4 v_box;
flat out vec4 v_bends;
#endif
#ifdef DOT
flat out float v_size;
#else
out vec4 v_at;
#endif

// Red, green and blue in one number, and an opacity, as a premultiplied colour.
vec4 premultiplied(vec2 ink) {
    vec3 parts = mod(floor(ink.x / vec3(1.0, 256.0, 65536.0)), 256.0);
    return vec4(parts / 255.0, 1.0) * ink.y;
}

#ifdef POLYGON
// How far a point lies inside of an edge of a polygon; far, where two corners are one.
float inside(vec2 point, vec2 start, vec2 end, float turn) {
    vec2 way = end - start;
    vec2 apart = point - start;
    float size = length(way);
    return size > 0.0 ? turn * (way.x * apart.y - way.y * apart.x) / size : 1e4;
}
#endif

void main() {
    int number = gl_VertexID % 6;
    int corner = number < 3 ? number : number == 3 ? 0 : number - 2;
    vec2 side = vec2(corner == 1 || corner == 2 ? 1.0 : 0.0, corner >= 2 ? 1.0 : 0.0);
    v_fill = premultiplied(a_inks.xy);
#if defined(BOX) || defined(DOT)
    v_rim = premultiplied(a_inks.zw);
    v_box = vec4(a_place.zw, a_shape.zw);
    v_bends = a_more;
    // Of a rim half lies beyond the edge, and so does half a pixel.
    vec2 reach = a_place.zw + 0.5 * a_shape.w + 0.6;
#endif
#ifdef DOT
    v_size = 2.0 * reach.x;
    gl_PointSize = v_size;
    vec2 at = a_place.xy;
#elif defined(BOX)
    // About a middle, turned by an angle.
    v_at = vec4((2.0 * side - 1.0) * reach, 0.0, 0.0);
    vec2 way = vec2(cos(a_shape.y), sin(a_shape.y));
    vec2 at = a_place.xy + v_at.x * way + v_at.y * vec2(-way.y, way.x);
#elif defined(SPRITE)
    vec2 past = side * (a_place.zw - a_place.xy);
    v_at = vec4(a_more.xy + past, 0.0, 0.0);
    vec2 at = a_place.xy + past;
#else
    vec2 at = corner == 0 ? a_place.xy : corner == 1 ? a_place.zw : corner == 2 ? a_more.xy : a_more.zw;
    v_at = vec4(at, 0.0, 0.0);
#endif
#ifdef POLYGON
    vec2 across = a_more.xy - a_place.xy;
    vec2 along = a_place.zw - a_place.xy;
    float turn = along.x * across.y - along.y * across.x < 0.0 ? -1.0 : 1.0;
    v_at = vec4(inside(at, a_place.xy, a_place.zw, turn), inside(at, a_place.zw, a_more.xy, turn),
                inside(at, a_more.xy, a_more.zw, turn), inside(at, a_more.zw, a_place.xy, turn));
#endif
    gl_Position = vec4(2.0 * at.x / u_pixels.x - 1.0, 1.0 - 2.0 * at.y / u_pixels.y, 0.0, 1.0);
}
