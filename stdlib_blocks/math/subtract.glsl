// SPDX-License-Identifier: Apache-2.0
/// Subtracts the second value from the first, component by component.
/// @param a what is reduced
/// @param b what is taken away @default 0
genType subtract(genType a, genType b) { return a - b; }
