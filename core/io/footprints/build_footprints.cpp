#include "core/io/footprints/build_footprints.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/io/footprints/osm_semantics.h"

namespace noonmark {

namespace {

void addBuildings(FilePiece& piece, std::vector<AssembledBuilding> buildings, const Frame& frame) {
    const std::size_t first = piece.buildings.size();
    piece.groundM.resize(first + buildings.size());
    piece.buildings.resize(first + buildings.size());
    if (std::ranges::any_of(buildings, [](const auto& made) { return made.roof.has_value(); }))
        piece.roofs.resize(first + buildings.size());
    tbb::parallel_for(std::size_t{0}, buildings.size(), [&](std::size_t i) {
        AssembledBuilding& made = buildings[i];
        std::optional<float>& ground = piece.groundM[first + i];
        if (made.elevationM) ground = float(*made.elevationM - frame.originElevationM());
        if (!piece.roofs.empty()) piece.roofs[first + i] = std::move(made.roof);
        for (Part& part : made.building.parts) {
            part.bottomM += ground.value_or(0);
            part.topM += ground.value_or(0);
        }
        piece.buildings[first + i] = std::make_shared<const Building>(std::move(made.building));
    });
}

}  // namespace

Result<void> buildFootprints(FilePiece& piece, std::vector<UnplacedFeature> features,
                             const ReadSettings& settings, Progress& progress, const std::stop_token& stop) {
    if (!settings.frame) piece.frame = frameOf(features, settings.farAwayM);
    const Frame frame = settings.frame ? *settings.frame : *piece.frame;
    progress.report(shareOfReading, "repairing outlines");
    const auto placed = placeFeatures(std::move(features), frame, settings.farAwayM, piece.warnings, stop);
    progress.report(0.9, "making buildings");
    addBuildings(piece, assembleBuildings(placed, settings.metresPerLevel, piece.warnings, stop), frame);
    if (stop.stop_requested()) return cancelled();
    progress.report(1, "making buildings");
    return {};
}

std::string findCommonest(const Warnings& warnings) {
    const auto groups = groupWarnings(warnings);
    const auto most =
        std::ranges::max_element(groups, {}, [](const WarningGroup& group) { return group.where.size(); });
    return most == groups.end() ? "" : lineOf(*most);
}

}  // namespace noonmark
