#pragma once

// The folder core/io/heights turns attributes into heights, for all readers. height_text.h parses a length or
// a number of storeys; height_reading.h (this file) decides on one height from all fields of a feature, and
// with height_facts.h records which fields were used, for reports. read_part.h removes meshes with impossible
// sizes. read_settings.h stores ReadSettings as text.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/io/heights/field_roles.h"
#include "core/io/heights/unknown_fields.h"

namespace noonmark {

/// How heights are derived from a feature's fields; the defaults are those of ReadSettings.
struct HeightRules {
    double metresPerLevel = 3.2;
    double defaultHeightM = 9.6;
    bool decimalComma = false;  ///< "12,5" is a number; in OpenStreetMap it is a list
};

/// Separates the two fields in HeightReading::origin.
constexpr std::string_view elevationsMinus = " - ";

/// Anything lower counts as no height: on a mountain, float32 could not represent it.
constexpr double minHeightM = 0.01;

/// How warnings of heights by default begin (HeightReading::byDefault).
inline constexpr std::string_view noHeightInData = "no height in the data";

/// The elevation of a roof whose ground nothing states.
struct RoofElevation {
    double elevationM = 0;  ///< above the data's vertical datum
    std::string field;
};

/// A feature's extent above its own ground, metres; 0 <= bottomM <= topM - minHeightM.
struct HeightReading {
    double bottomM = 0;
    double topM = 0;
    HeightSource source = HeightSource::assumed;
    bool byDefault = false;  ///< no height in the data: topM is the default; the caller warns if it uses it
    bool slab = false;       ///< a canopy without a stated underside
    std::string origin;      ///< the field that topM came from, or "AbsH2 - AbsHMin"; empty if byDefault
    std::optional<RoofElevation> roof;       ///< only byDefault: all that the data have of its height
    std::optional<double> groundElevationM;  ///< above the data's vertical datum
};

/// A canopy without min_height is modelled as a slab of this thickness under its top.
constexpr double canopyThicknessM = 0.5;

/// Height: the first height field with a usable value; else the roof's elevation minus the ground's; else
/// storeys x metres per storey (plus the height of the roof); else the default, which for a canopy (`canopy`:
/// building=roof) is one storey. Underside: min_height, else the storeys below; else 0. Zero, negative and
/// implausible heights (over 2,000 m) are ignored, and so are those below minHeightM. If the underside is
/// not below the top, a measured height is counted from the ground, and a guessed one from the underside.
/// Every value that was not taken as written gives a warning (except see byDefault).
HeightReading readHeights(const FeatureValues& values, const HeightRules& rules, bool canopy,
                          const std::string& featureId, Warnings& warnings);

/// Number of features by HeightReading::origin; "" is the default height.
using HeightOrigins = std::map<std::string, std::size_t>;

/// Adds the fields that the heights of `file` came from, and warns of what was assumed of them. If more than
/// a tenth of its features have none, adds the unknown fields that could hold them; warns if no field of
/// heights or storeys is known.
void addHeightFacts(const HeightOrigins& origins, const std::vector<KnownField>& fields,
                    const UnknownFields& unknown, const std::string& file, HeightFacts& facts,
                    Warnings& warnings);

}  // namespace noonmark
