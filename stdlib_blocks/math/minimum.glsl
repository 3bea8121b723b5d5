// SPDX-License-Identifier: Apache-2.0
/// The smaller of two values, component by component.
/// @param a first value
/// @param b second value
genType minimum(genType a, genType b) { return min(a, b); }
