// SPDX-License-Identifier: Apache-2.0
/// Moves a value from one range to another: `in_low` becomes `out_low`, `in_high` becomes
/// `out_high`.
/// Where the first range is empty the result is `out_low`.
/// @param value the value
/// @param in_low start of the range that the value comes from @default 0
/// @param in_high end of that range; it may lie below its start @default 1
/// @param out_low start of the range that the result is in @default 0
/// @param out_high end of that range; it may lie below its start @default 1
/// @param limited whether results beyond the ends of the range are kept at its ends @default false
genType remap(genType value, genType in_low, genType in_high, genType out_low, genType out_high,
              const bool limited) {
  genType t = divide(value - in_low, in_high - in_low);
  return mix(out_low, out_high, limited ? clamp(t, 0.0, 1.0) : t);
}
