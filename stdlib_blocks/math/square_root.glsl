// SPDX-License-Identifier: Apache-2.0
/// The square root, component by component; 0 below zero.
/// @param value the value
genType square_root(genType value) { return sqrt(max(value, 0.0)); }
