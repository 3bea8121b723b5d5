// SPDX-License-Identifier: Apache-2.0
/// The dot product of two vectors: the sum of the products of their components.
/// @param a first vector
/// @param b second vector
float dot_product(genType a, genType b) { return dot(a, b); }
