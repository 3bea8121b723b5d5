// SPDX-License-Identifier: Apache-2.0
/// The value without its sign, component by component.
/// @param value the value
genType absolute(genType value) { return abs(value); }
