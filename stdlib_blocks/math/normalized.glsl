// SPDX-License-Identifier: Apache-2.0
/// The vector of length 1 that points the same way; 0 where the vector is shorter than 1e-15.
/// @param vector the vector
genType normalized(genType vector) {
  return vector * inversesqrt(max(dot(vector, vector), 1e-30));
}
