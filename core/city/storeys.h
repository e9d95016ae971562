#pragma once

namespace noonmark {

/// Height of a storey where a building states none, metres: of new towers, on facades, and where floors are
/// counted. Between homes (some 3 m) and offices (some 4 m). Heights that data state in storeys are read with
/// ReadSettings::metresPerLevel, which is the mean of existing buildings, most of them homes.
inline constexpr double defaultStoreyM = 3.5;

}  // namespace noonmark
