#pragma once

// The folder core/io/footprints reads buildings from layers of polygons: building_layers.h finds the layers
// that hold buildings, footprint_layer.h reads the features of one, feature_facts.h interprets their
// attributes, OpenStreetMap's tags in a converter's column among them, and this file assembles features into
// buildings, those of OpenStreetMap files (core/io/osm) too.

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/io/footprints/place_features.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

/// Assembles features into buildings by OpenStreetMap's rules for simple 3D buildings, which also hold for
/// files without parts: see groupIntoBuildings, computeRemainder and settleParts. Canopies (building=roof)
/// without a stated underside are overhangs. Ends early when stopped.
struct AssembledBuilding {
    Building building;                  ///< z above its own ground
    std::optional<double> elevationM;   ///< elevation of that ground, the lowest that its features state
    std::optional<RoofElevation> roof;  ///< of a building of one feature (HeightReading::roof)
};
std::vector<AssembledBuilding> assembleBuildings(const std::vector<PlacedFeature>& features,
                                                 double metresPerLevel, Warnings& warnings,
                                                 const std::stop_token& stop = {});

/// Translates a message of GDAL's vector readers into a warning text that a planner understands. Empty if the
/// message does not concern the data; an unknown message is returned unchanged.
std::string explainGdalWarning(std::string_view words);

/// Adds these messages as warnings: GDAL does not name the feature that a message is about, so there is one
/// for each kind, with its count.
void addMapRemarks(const std::vector<std::string>& words, const std::string& file, Warnings& warnings);

/// Share of a reader's progress that reading takes; repair and semantics take the rest.
inline constexpr double shareOfReading = 0.8;

/// Makes buildings from features and adds them to `piece`: all steps after reading. Chooses the piece's frame
/// if the settings state none. `features` is not empty. Error: cancelled().
Result<void> buildFootprints(FilePiece& piece, std::vector<UnplacedFeature> features,
                             const ReadSettings& settings, Progress& progress, const std::stop_token& stop);

/// The most frequent warning, for an error; empty without warnings.
std::string findMostFrequent(const Warnings& warnings);

/// Decides, for the parts of one building that start above the ground, whether they stand, are lowered or are
/// overhangs. From the lowest part up: a part is carried, and then stands, if standing parts reach up to its
/// underside below all of its footprint (except 5 % of it and 0.5 m2). Otherwise:
/// - If the gap to the parts that would carry it is at most `carryGapM`, or the gap to the ground at most
///   `groundGapM`, its underside is lowered to close the gap: mapped heights seldom match, and light would
///   pass through a slit that does not exist. Each gives a warning (repaired).
/// - Otherwise it becomes an overhang.
///
/// Parts with `isOverhanging` already set are left unchanged and carry nothing.
struct SettleRules {
    float groundM = 0;       ///< local z of the ground
    float carryGapM = 3.2F;  ///< a storey
    float groundGapM = 2;    ///< lower than a passage
};
void settleParts(std::vector<Part>& parts, const SettleRules& rules, Warnings& warnings);

}  // namespace noonmark
