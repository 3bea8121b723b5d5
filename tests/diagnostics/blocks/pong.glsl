/// Calls the one again.
/// @param x a number
float pong(float x) { return ping(x) * 0.5; }
