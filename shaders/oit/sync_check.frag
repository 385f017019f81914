// Read, change, write without atomics: right only where fragments of a pixel take turns in order.
layout(location = 0) flat in uint triangle;
layout(r32ui, binding = 0) uniform uimage2D words;

void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  uint word = imageLoad(words, p).r;
  imageStore(words, p, uvec4(word * 1664525u + triangle + 1u));
}
