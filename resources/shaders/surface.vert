// A display grid of a patch in unit space. gl_VertexID gives the parameters: no buffer for what counting knows. In a net
// of windows it does not know them.
uniform mat4 u_matrix;
uniform mat3 u_view;
uniform vec2 u_counts;
uniform vec2 u_cells;
uniform vec4 u_eye;
uniform float u_point_size;
#ifdef RAMP
uniform vec4 u_ramp;
#endif

in vec3 a_position;
in vec3 a_normal;
in float a_part;
#ifdef NET
in vec2 a_cell;
#endif

#ifdef SAMPLES
// A cell has the value at its first corner, which the indices name last in both of its triangles.
flat out float v_part;
#elif !defined(FACETS)
out float v_part;
#endif
#ifdef NORMALS
#ifdef SAMPLES
out vec3 v_place;
#else
out vec3 v_normal;
#endif
out vec3 v_toward;
#endif
#ifdef CELLS
out vec2 v_cell;
#endif

void main() {
#if defined(CELLS) && defined(NET)
    v_cell = a_cell;
#elif defined(CELLS)
    // In floats, which hold every index of 4096 x 4096 samples and divide faster than integers; where the quotient
    // is rounded past a whole number, what is left of the row tells.
    float row = floor(float(gl_VertexID) / u_counts.y);
    float column = float(gl_VertexID) - row * u_counts.y;
    float missed = float(column >= u_counts.y) - float(column < 0.0);
    v_cell = vec2(row + missed, column - missed * u_counts.y) / (u_counts - 1.0) * u_cells;
#endif
#ifdef RAMP
    v_part = clamp(dot(u_ramp, vec4(a_position, 1.0)), -1e3, 1e3);
#elif !defined(FACETS)
    v_part = a_part;
#endif
#ifdef NORMALS
#ifdef SAMPLES
    v_place = u_view * a_position;
#else
    v_normal = u_view * a_normal;
#endif
    v_toward = u_view * (u_eye.xyz - u_eye.w * a_position);
#endif
    gl_Position = u_matrix * vec4(a_position, 1.0);
#ifdef POINTS
    gl_PointSize = u_point_size;
#endif
}
