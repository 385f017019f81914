// A dense network as straight-line code: NETWORK_BODY, made by passes/oit/learned/network_layout.cpp,
// computes the outputs y[] from the inputs x[] with every weight as a constant. Compilers do not unroll
// so long a loop, and where branches and loads of a group of threads are emulated, loads of weights cost
// five times the arithmetic.
// INPUTS, OUTPUTS: sizes.

/// @param x features in their units
void evaluateNetwork(const float x[INPUTS], out float y[OUTPUTS]) {
  NETWORK_BODY
}
