// SPDX-License-Identifier: Apache-2.0
/// The larger of two values, component by component.
/// @param a first value
/// @param b second value
genType maximum(genType a, genType b) { return max(a, b); }
