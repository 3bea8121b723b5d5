// SPDX-License-Identifier: Apache-2.0
/// Adds two values, component by component.
/// @param a first term
/// @param b second term @default 0
genType add(genType a, genType b) { return a + b; }
