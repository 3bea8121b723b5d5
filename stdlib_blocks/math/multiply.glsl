// SPDX-License-Identifier: Apache-2.0
/// Multiplies two values, component by component.
/// @param a first factor
/// @param b second factor @default 1
genType multiply(genType a, genType b) { return a * b; }
