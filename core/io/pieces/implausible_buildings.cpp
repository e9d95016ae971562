#include "core/io/pieces/implausible_buildings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/city/plausible_heights.h"

namespace noonmark {

namespace {

constexpr float farthestM = 1e6F, deepestM = -2e4F, highestM = 2e4F;

// Null if it is plausible.
const char* whyImplausible(const Building& building) {
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
    for (const Part& part : building.parts) {
        if (!std::isfinite(part.bottomM) || !std::isfinite(part.topM)) return "its height is not a number";
        low = std::min(low, part.bottomM), high = std::max(high, part.topM);
    }
    if (building.parts.empty()) return nullptr;
    if (double(high) - double(low) > tallestBuildingM) return "it is higher than 2,000 m";
    if (low < deepestM || high > highestM) return "it lies more than 20 km below or above the ground";
    const Box2 box = bounds(building);
    const bool near = box.low.x >= -farthestM && box.low.y >= -farthestM && box.high.x <= farthestM &&
                      box.high.y <= farthestM;
    return near ? nullptr : "it lies more than 1,000 km from the middle of the city";
}

void warn(const std::string& file, const Building& building, const char* why, Warnings& warnings) {
    warnings.push_back({WarningKind::leftOut, why, fmt::format("{}: {}", file, building.sourceId)});
}

}  // namespace

Result<void> leaveOutImplausible(const std::string& file, FilePiece& piece) {
    const bool grounds = !piece.groundM.empty();
    std::size_t kept = 0;
    const char* lastWhy = nullptr;
    for (std::size_t i = 0; i < piece.buildings.size(); ++i) {
        if (const char* why = whyImplausible(*piece.buildings[i])) {
            warn(file, *piece.buildings[i], why, piece.warnings);
            lastWhy = why;
            continue;
        }
        if (grounds) piece.groundM[kept] = piece.groundM[i];
        if (!piece.roofs.empty() && kept != i) piece.roofs[kept] = std::move(piece.roofs[i]);
        piece.buildings[kept++] = std::move(piece.buildings[i]);
    }
    if (kept == 0 && lastWhy != nullptr)
        return failure(fmt::format("No building can be used, each because {}", lastWhy), file,
                       "Check the unit of its coordinates and which axis is up");
    piece.buildings.resize(kept);
    if (grounds) piece.groundM.resize(kept);
    if (!piece.roofs.empty()) piece.roofs.resize(kept);
    return {};
}

}  // namespace noonmark
