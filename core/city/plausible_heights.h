#pragma once

namespace noonmark {

/// What a building's height and its ground's elevation may be, read or designed. The tallest building has
/// 828 m; towers of 1,000 m are being built, some of 1,700 m were proposed. Land lies between -430 m (the
/// Dead Sea) and 8,849 m.
inline constexpr double tallestBuildingM = 2000;
inline constexpr double lowestLandM = -500, highestLandM = 9000;  ///< above the ellipsoid or the sea

}  // namespace noonmark
