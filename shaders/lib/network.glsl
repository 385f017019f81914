// A dense network, written out: NETWORK_BODY, made by passes/oit/network_layout.cpp, turns the inputs
// x[] into said[] with every weight as a constant. Compilers do not unroll so long a loop, and where
// branches and loads of a group of threads are emulated, loads of weights cost five times their use.
// INPUTS, OUTPUTS: sizes.

/// @param x features in their units
void evaluateNetwork(const float x[INPUTS], out float said[OUTPUTS]) {
  NETWORK_BODY
}
