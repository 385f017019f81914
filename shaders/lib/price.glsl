// The search for the price at which the pixels together take the slots of the budget. Each round
// tries some prices between the bounds of the one before.

struct PriceBounds {
  float high;  // log2; at this price no more than the budget is asked for
  float low;
};

/// log2 of candidate i, from the highest on.
float candidatePrice(PriceBounds bounds, int i) {
  return bounds.high - (bounds.high - bounds.low) * float(i + 1) / float(PRICE_CANDIDATES + 1);
}

/// Bounds after the first `rounds` rounds. @param pixelsEach pixels that a sampled one stands for
PriceBounds priceBounds(int rounds, uint slots, float pixelsEach) {
  PriceBounds bounds = PriceBounds(PRICE_HIGHEST, PRICE_LOWEST);
  for (int round = 0; round < rounds; ++round) {
    int affordable = 0;
    for (int i = 0; i < PRICE_CANDIDATES; ++i) {
      uint asked = totals.priceDemand[round * PRICE_VECTORS + i / 4][i % 4];
      if (float(asked) * pixelsEach <= float(slots)) affordable = i + 1;
    }
    PriceBounds next = bounds;
    if (affordable > 0) next.high = candidatePrice(bounds, affordable - 1);
    if (affordable < PRICE_CANDIDATES) next.low = candidatePrice(bounds, affordable);
    bounds = next;
  }
  return bounds;
}

/// Pixels that a sampled one stands for.
float pixelsPerSample() {
  ivec2 samples = (ivec2(frame.size.xy) + int(frame.oit.z) - 1) / int(frame.oit.z);
  return frame.size.x * frame.size.y / float(samples.x * samples.y);
}

/// A price a little above and one a little below the one found; the others are not used.
vec4[1] finalPrices() {
  PriceBounds bounds = priceBounds(PRICE_ROUNDS, frame.oit.y, pixelsPerSample());
  return vec4[1](vec4(bounds.high + PRICE_MARGIN, bounds.low - PRICE_MARGIN, 0.0, 0.0));
}
