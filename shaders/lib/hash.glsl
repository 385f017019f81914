/// PCG hash (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering").
uint hashPcg(uint x) {
  uint state = x * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}
