// A display grid of a patch in unit space. gl_VertexID gives the parameters: no buffer for what counting knows.
uniform mat4 u_matrix;
uniform mat3 u_view;
uniform ivec2 u_counts;
uniform vec2 u_cells;
uniform vec2 u_heights;
uniform float u_point_size;

in vec3 a_position;
in vec3 a_normal;

HEIGHT_SHADING out float v_height;
out vec3 v_normal;
out vec2 v_cell;

void main() {
    ivec2 index = ivec2(gl_VertexID / u_counts.y, gl_VertexID % u_counts.y);
    v_cell = vec2(index) / vec2(u_counts - 1) * u_cells;
    v_height = a_position.z * u_heights.x + u_heights.y;
    v_normal = u_view * a_normal;
    gl_Position = u_matrix * vec4(a_position, 1.0);
    gl_PointSize = u_point_size;
}
