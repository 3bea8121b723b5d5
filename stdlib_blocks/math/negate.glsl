// SPDX-License-Identifier: Apache-2.0
/// Turns the sign of a value around, component by component.
/// @param value the value
genType negate(genType value) { return -value; }
