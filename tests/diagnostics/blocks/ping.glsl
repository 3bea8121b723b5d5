/// Calls the other one.
/// @param x a number
float ping(float x) { return pong(x) + 1.0; }
