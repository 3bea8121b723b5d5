/// Comments that say something wrong.
/// @param nobody not a parameter
/// @param x the value @default 5 @range 0 1
/// @param name word @default "x"
/// @colour red
/// @return the result
float documentation(float x, float name) { return x + name; }
