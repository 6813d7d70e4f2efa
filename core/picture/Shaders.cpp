// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/Shaders.h"

namespace toile::picture::shaders {

// clang-format off: the line breaks are GLSL's

// Light is reckoned in linear values; `shown` brings them to the screen. Squares and roots stand for the
// screen's exponent of 2.2: they are much cheaper where the processor draws, and nobody sees the difference.
// Half a step of noise (Jimenez 2014) hides the bands that eight bits would show in soft gradients.
#define TOILE_GLSL_COMMON                                                                                              \
    "#version 330 core\n"                                                                                              \
    "vec3 linearOf(vec3 c) { return c * c; }\n"                                                                        \
    "float noise() { return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))); "           \
    "}\n"                                                                                                              \
    "vec3 shown(vec3 c) { return sqrt(max(c, 0.0)) + (noise() - 0.5) / 255.0; }\n"

// 1 = in the light. Five filtered comparisons, `blur` texels apart, soften the edge.
#define TOILE_GLSL_SHADOW                                                                                              \
    "uniform sampler2DShadow shadowMap; uniform mat4 shadowMatrix; uniform bool shadows;\n"                            \
    "uniform float shadowTexel;\n"                                                                                     \
    "float lightAt(vec3 point, float blur) {\n"                                                                        \
    "    if (!shadows) return 1.0;\n"                                                                                  \
    "    vec3 p = (shadowMatrix * vec4(point, 1.0)).xyz * 0.5 + 0.5;\n"                                                \
    "    if (any(lessThan(p, vec3(0.0))) || any(greaterThan(p, vec3(1.0)))) return 1.0;\n"                             \
    "    float r = blur * shadowTexel;\n"                                                                              \
    "    return 0.2 * (texture(shadowMap, p) + texture(shadowMap, p + vec3(r, 0.4 * r, 0.0)) +\n"                      \
    "                  texture(shadowMap, p + vec3(-r, -0.4 * r, 0.0)) +\n"                                            \
    "                  texture(shadowMap, p + vec3(-0.4 * r, r, 0.0)) +\n"                                             \
    "                  texture(shadowMap, p + vec3(0.4 * r, -r, 0.0)));\n"                                             \
    "}\n"

const ShaderSources background{
    .vertex = "#version 330 core\n"
              "out float height;\n"
              "void main() {\n"
              "    vec2 p = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
              "    height = p.y * 0.5 + 0.5;\n"
              "    gl_Position = vec4(p, 0.0, 1.0);\n"
              "}\n",
    .fragment = TOILE_GLSL_COMMON "in float height; uniform vec4 low; uniform vec4 high; out vec4 colour;\n"
                                  "void main() {\n"
                                  "    colour = vec4(mix(low.rgb, high.rgb, smoothstep(0.0, 1.0, height)) + "
                                  "(noise() - 0.5) / 255.0, 1.0);\n"
                                  "}\n"};

const ShaderSources shadow{.vertex = "#version 330 core\n"
                                     "layout(location = 0) in vec3 position; uniform mat4 shadowMatrix;\n"
                                     "void main() { gl_Position = shadowMatrix * vec4(position, 1.0); }\n",
                           .fragment = "#version 330 core\n"
                                       "void main() {}\n"};

const ShaderSources surface{.vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float cavity;
uniform mat4 view, projection;
out vec3 point, bent;
out float hollow;
void main() {
    point = position;
    bent = normal;
    hollow = cavity;
    gl_Position = projection * (view * vec4(position, 1.0));
}
)",
                            .fragment = TOILE_GLSL_COMMON TOILE_GLSL_SHADOW R"(
in vec3 point, bent;
in float hollow;
uniform vec3 eye, keyDirection, fillDirection, rimDirection; // directions point to the lights
uniform bool cloth;
uniform vec4 bodyColour, selectionColour;
uniform samplerBuffer triangleColours; // alpha: see SurfaceData.h
out vec4 colour;

// The wrong side: greyer; a pale fabric gets darker, a dark one paler, or nobody would see the difference.
vec3 wrongSide(vec3 c) {
    float grey = dot(c, vec3(0.2126, 0.7152, 0.0722));
    vec3 dull = mix(c, vec3(grey), 0.55);
    return grey > 0.45 ? dull * vec3(0.60, 0.585, 0.57) : mix(dull, vec3(0.80, 0.78, 0.75), 0.45);
}

void main() {
    vec3 n = normalize(bent), v = normalize(eye - point);
    float side = gl_FrontFacing ? 1.0 : -1.0;
    n *= side;
    vec3 base = linearOf(bodyColour.rgb);
    bool selected = false;
    if (cloth) {
        vec4 painted = texelFetch(triangleColours, gl_PrimitiveID);
        base = linearOf(painted.rgb);
        selected = painted.a < 0.5;
        if (selected) base = mix(base, linearOf(selectionColour.rgb), 0.10);
        bool rightSidesOnly = painted.a < (selected ? 0.2 : 0.8);
        if (!gl_FrontFacing && !rightSidesOnly) base = wrongSide(base);
    }
    // A surface turned away from the light is in shadow already; moving the look-up off the surface keeps it from
    // shading itself.
    float facing = dot(n, keyDirection);
    float lit = lightAt(point + n * mix(0.012, 0.004, clamp(facing, 0.0, 1.0)), 1.2);
    // The cloth's light goes a little round the edge, as in fibres.
    float key = cloth ? max((facing + 0.12) / 1.12, 0.0) : max(facing, 0.0);
    float fill = max(dot(n, fillDirection) * 0.6 + 0.4, 0.0);
    float grazing = 1.0 - max(dot(n, v), 0.0);
    float rim = grazing * grazing * grazing * max(dot(n, rimDirection) * 0.5 + 0.5, 0.0);
    float open = clamp(1.0 - side * hollow * 1.3, 0.3, 1.35); // valleys get less of the sky than ridges
    vec3 sky = mix(vec3(0.10, 0.095, 0.095), vec3(0.29, 0.305, 0.33), n.y * 0.5 + 0.5);
    vec3 light = sky * open + vec3(0.86, 0.83, 0.79) * (key * lit * mix(1.0, open, 0.4)) +
                 vec3(0.13, 0.145, 0.165) * (fill * open);
    vec3 c = base * light + mix(base, vec3(1.0), 0.35) * (rim * (cloth ? 0.22 : 0.16));
    if (!cloth) { // the soft gloss of a dress form's skin
        float gloss = max(dot(n, normalize(keyDirection + v)), 0.0);
        gloss *= gloss * gloss;
        gloss *= gloss * gloss; // ^9
        c += vec3(0.05) * (gloss * gloss * lit);
    }
    if (selected) c += linearOf(selectionColour.rgb) * (0.03 + 0.25 * grazing * grazing);
    colour = vec4(shown(c), 1.0);
}
)"};

const ShaderSources floor{.vertex = R"(#version 330 core
uniform mat4 view, projection;
uniform vec3 centre;
uniform float radius;
out vec3 point;
void main() {
    point = vec3(centre.x + radius * (gl_VertexID % 2 == 0 ? -1.0 : 1.0), 0.0,
                 centre.z + radius * (gl_VertexID / 2 == 0 ? -1.0 : 1.0));
    gl_Position = projection * (view * vec4(point, 1.0));
}
)",
                          .fragment = TOILE_GLSL_COMMON TOILE_GLSL_SHADOW R"(
in vec3 point;
uniform vec3 centre, eye;
uniform float radius;
out vec4 colour;

// How much of this pixel a grid's lines cover.
float grid(float pitch, float width) {
    vec2 cell = point.xz / pitch, perPixel = fwidth(cell);
    vec2 fromLine = abs(fract(cell - 0.5) - 0.5) / max(perPixel, 1e-6);
    vec2 cover = clamp(width * 0.5 + 0.5 - fromLine, 0.0, 1.0) * clamp(0.6 - perPixel, 0.0, 0.5) * 2.0;
    return max(cover.x, cover.y);
}

void main() {
    float away = length(point.xz - centre.xz) / radius;
    float near = 1.0 - smoothstep(0.25, 1.0, away);
    float slant = abs(normalize(eye - point).y);
    float lines = max(grid(0.1, 1.0) * 0.22, grid(1.0, 1.6) * 0.45) * smoothstep(0.0, 0.12, slant);
    float turn = 6.2832 * noise(); // many pixels together make a wide, soft edge
    vec3 spread = vec3(cos(turn), 0.0, sin(turn)) * 0.012;
    float dark = (1.0 - 0.5 * (lightAt(point + spread, 5.0) + lightAt(point - spread, 10.0))) * 0.24;
    float cover = 1.0 - (1.0 - lines) * (1.0 - dark);
    colour = vec4(vec3(0.24, 0.26, 0.30) * (lines > dark ? 1.0 : 0.6), cover * near);
}
)"};

const ShaderSources line{.vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 view, projection;
uniform vec2 size; // of the picture [px]
uniform float width; // [px]
uniform float towardsEye; // lines lie so far in front of the surface they belong to at most [m]
out vec3 seen;
void main() {
    vec3 p = (view * vec4(position, 1.0)).xyz;
    float pixel = 2.0 * max(-p.z, 0.0) / (projection[1][1] * size.y); // [m]
    // Half as far as they are wide, soft edges and all: so much a surface seen at 45 degrees hides of them.
    float before = min(towardsEye, 0.5 * (width + 1.0) * pixel);
    seen = p * (1.0 - min(before / max(length(p), 1e-6), 0.5));
}
)",
                         .geometry = R"(#version 330 core
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
in vec3 seen[];
uniform mat4 projection;
uniform vec2 size; // of the picture [px]
uniform float width; // [px]
flat out vec2 from, to;
void main() {
    const float front = -0.004; // nothing nearer to the eye is drawn [m]
    vec3 a = seen[0], b = seen[1];
    if (a.z > front && b.z > front) return;
    if (a.z > front) a = mix(b, a, (front - b.z) / (a.z - b.z));
    if (b.z > front) b = mix(a, b, (front - a.z) / (b.z - a.z));
    vec4 ca = projection * vec4(a, 1.0), cb = projection * vec4(b, 1.0);
    vec2 pa = (ca.xy / ca.w * 0.5 + 0.5) * size, pb = (cb.xy / cb.w * 0.5 + 0.5) * size;
    vec2 along = pb - pa;
    along = length(along) > 1e-4 ? normalize(along) : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    float reach = width * 0.5 + 1.0;
    for (int i = 0; i < 4; ++i) {
        bool end = i >= 2;
        vec2 p = (end ? pb + along * reach : pa - along * reach) + across * (i % 2 == 0 ? reach : -reach);
        vec4 c = end ? cb : ca;
        from = pa;
        to = pb;
        gl_Position = vec4((p / size * 2.0 - 1.0) * c.w, c.z, c.w);
        EmitVertex();
    }
    EndPrimitive();
}
)",
                         .fragment = R"(#version 330 core
flat in vec2 from, to;
uniform vec4 lineColour;
uniform float width;
out vec4 colour;
void main() {
    vec2 along = to - from, p = gl_FragCoord.xy - from;
    float s = clamp(dot(p, along) / max(dot(along, along), 1e-8), 0.0, 1.0);
    float cover = clamp(width * 0.5 + 0.5 - length(p - along * s), 0.0, 1.0);
    if (cover <= 0.0) discard;
    colour = vec4(lineColour.rgb, lineColour.a * cover);
}
)"};

// clang-format on

} // namespace toile::picture::shaders
