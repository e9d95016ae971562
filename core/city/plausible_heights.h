#pragma once

namespace noonmark {

/// Limits for the height of a building and the elevation of its ground, read or designed. The tallest
/// building has 828 m; towers of 1,000 m are being built, some of 1,700 m have been proposed. Land lies
/// between -430 m (the Dead Sea) and 8,849 m.
inline constexpr double tallestBuildingM = 2000;
inline constexpr double minLandM = -500, maxLandM = 9000;  ///< above the ellipsoid or sea level

}  // namespace noonmark
