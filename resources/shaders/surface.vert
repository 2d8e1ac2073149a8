// A display grid of a patch in unit space. gl_VertexID gives the parameters: no buffer for what counting knows. In a net
// of windows it does not know them.
uniform mat4 u_matrix;
uniform mat3 u_view;
uniform vec2 u_counts;
uniform vec2 u_cells;
uniform vec4 u_eye;
uniform float u_point_size;

in vec3 a_position;
in vec3 a_normal;
in float a_part;
#ifdef NET
in vec2 a_cell;
#endif

#ifndef FACETS
out float v_part;
#endif
#ifdef NORMALS
out vec3 v_normal;
out vec3 v_toward;
#endif
#ifdef CELLS
out vec2 v_cell;
#endif

void main() {
#if defined(CELLS) && defined(NET)
    v_cell = a_cell;
#elif defined(CELLS)
    // In floats, which hold every index of a display grid and divide faster than integers.
    float row = floor((float(gl_VertexID) + 0.5) / u_counts.y);
    v_cell = vec2(row, float(gl_VertexID) - row * u_counts.y) / (u_counts - 1.0) * u_cells;
#endif
#ifndef FACETS
    v_part = a_part;
#endif
#ifdef NORMALS
    v_normal = u_view * a_normal;
    v_toward = u_view * (u_eye.xyz - u_eye.w * a_position);
#endif
    gl_Position = u_matrix * vec4(a_position, 1.0);
#ifdef POINTS
    gl_PointSize = u_point_size;
#endif
}
