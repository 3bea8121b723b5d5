/// The file's name is not the function's.
float another_name(float x) { return x; }
