// SPDX-License-Identifier: Apache-2.0
/// The length of a vector.
/// @param vector the vector
float magnitude(genType vector) { return length(vector); }
