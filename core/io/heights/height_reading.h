#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/warnings.h"
#include "core/city/building.h"
#include "core/io/footprints/feature_value.h"

namespace noonmark {

/// How heights are made of what a feature says; the defaults are those of ReadSettings.
struct HeightRules {
    double metresPerLevel = 3.2;
    double defaultHeightM = 9.6;
    bool decimalComma = false;  ///< "12,5" is a number; in OpenStreetMap it is a list
};

/// Between the two fields of HeightReading::origin.
constexpr std::string_view elevationsMinus = " - ";

/// What is lower counts as no height: in float32, on a mountain, it would be none.
constexpr double leastHeightM = 0.01;

/// A feature's extent above its own ground, metres; 0 <= bottomM <= topM - leastHeightM.
struct HeightReading {
    double bottomM = 0;
    double topM = 0;
    HeightSource source = HeightSource::assumed;
    bool byDefault = false;  ///< nothing in the data: topM is the default; the caller warns where it is used
    bool slab = false;       ///< a canopy whose underside is not in the data
    std::string origin;      ///< the field that topM came from, or "AbsH2 - AbsHMin"; empty where byDefault
    std::optional<double> groundElevationM;  ///< above the data's vertical datum
};

/// A canopy without min_height is drawn as a slab of this thickness under its top.
constexpr double canopyThicknessM = 0.5;

/// Height: the first height field that holds one; else the roof's elevation over the ground's; else storeys
/// (and the roof's own height) x metres a storey; else the default, for a canopy (`canopy`: building=roof)
/// one storey. The underside: min_height, else storeys below; else 0. Zero, negative and absurd heights (over
/// 2,000 m) count as none, and so do those below leastHeightM. Where the underside is not below the top, a
/// measured height is drawn from the
/// ground, and a guessed one is put on the underside. Every value that was not taken as written is a warning
/// (but see byDefault).
HeightReading readHeights(const FeatureValues& values, const HeightRules& rules, bool canopy,
                          const std::string& featureId, Warnings& warnings);

}  // namespace noonmark
