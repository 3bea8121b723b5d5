// SPDX-License-Identifier: Apache-2.0
/// The largest whole number that is not above the value, component by component.
/// @param value the value
genType round_down(genType value) { return floor(value); }
