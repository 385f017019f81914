// Search for the Lagrange multiplier at which the pixels together demand the slots of the budget
// (lib/demand.glsl). Total demand falls as the multiplier rises, so each round evaluates it at
// MULTIPLIER_CANDIDATES values between the bounds that the round before has found. Everything is log2.
// Needs the buffer `totals`.

struct MultiplierBounds {
  float high;  // total demand is within the budget
  float low;   // total demand exceeds it
};

/// Candidate i, from the highest on.
float candidateMultiplier(MultiplierBounds bounds, int i) {
  return bounds.high - (bounds.high - bounds.low) * float(i + 1) / float(MULTIPLIER_CANDIDATES + 1);
}

/// Bounds after the first `rounds` rounds. @param pixelsEach pixels that a sampled one stands for
MultiplierBounds multiplierBounds(int rounds, uint slots, float pixelsEach) {
  MultiplierBounds bounds = MultiplierBounds(MULTIPLIER_HIGHEST, MULTIPLIER_LOWEST);
  for (int round = 0; round < rounds; ++round) {
    int affordable = 0;
    for (int i = 0; i < MULTIPLIER_CANDIDATES; ++i) {
      uint demand = totals.sampledDemand[round * MULTIPLIER_VECTORS_A_ROUND + i / 4][i % 4];
      if (float(demand) * pixelsEach <= float(slots)) affordable = i + 1;
    }
    MultiplierBounds next = bounds;
    if (affordable > 0) next.high = candidateMultiplier(bounds, affordable - 1);
    if (affordable < MULTIPLIER_CANDIDATES) next.low = candidateMultiplier(bounds, affordable);
    bounds = next;
  }
  return bounds;
}

/// Pixels that a sampled one stands for.
float pixelsPerSample() {
  ivec2 samples = (ivec2(frame.size) + int(frame.sampledCellSide) - 1) / int(frame.sampledCellSide);
  return frame.size.x * frame.size.y / float(samples.x * samples.y);
}

/// One a little above the multiplier found and one a little below it, in x and y: the search knows it
/// from a sample of the pixels.
vec4[1] finalMultipliers() {
  MultiplierBounds bounds = multiplierBounds(MULTIPLIER_ROUNDS, frame.slots, pixelsPerSample());
  return vec4[1](vec4(bounds.high + MULTIPLIER_MARGIN, bounds.low - MULTIPLIER_MARGIN, 0.0, 0.0));
}
