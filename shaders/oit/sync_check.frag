// Self-test of per-pixel ordering: reads, changes and writes a word without atomics, which is right only
// where the rasteriser draws the fragments of a pixel in order.
layout(location = 0) flat in uint triangle;
layout(r32ui, binding = 0) uniform uimage2D words;

void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  uint word = imageLoad(words, p).r;
  imageStore(words, p, uvec4(word * 1664525u + triangle + 1u));
}
