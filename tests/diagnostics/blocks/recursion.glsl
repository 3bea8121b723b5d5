/// Calls itself, over another function.
float other(float x) { return recursion(x - 1.0); }
float recursion(float x) { return x > 0.0 ? other(x) : 0.0; }
