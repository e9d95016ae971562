#include "scenarios/edits/read_shape.h"

#include <algorithm>

#include "core/io/files/file_kind.h"

namespace noonmark {

namespace {

Building joinBuildings(const City& city, const std::string& id) {
    Building whole{.sourceId = id, .name = id};
    for (const auto& building : city.buildings)
        whole.parts.insert(whole.parts.end(), building->parts.begin(), building->parts.end());
    return whole;
}

double lowestM(const Building& building) {
    float lowest = 1e30F;
    for (const Part& part : building.parts) lowest = std::min(lowest, part.bottomM);
    return double(lowest);
}

}  // namespace

Result<ImportMesh> readShape(const std::filesystem::path& file, const std::string& id,
                             const ReadSettings& settings, const Frame& frame, Warnings& warnings,
                             Progress& progress, std::stop_token stop) {
    const auto kind = detectFileKind(file);
    if (!kind) return tl::make_unexpected(kind.error());
    ReadSettings here = settings;
    here.frame = frame;
    if (*kind == FileKind::mesh) here.meshAnchor.reset();  // the user places it
    auto read = readCity({file}, here, progress, std::move(stop));
    if (!read) return tl::make_unexpected(read.error());
    std::ranges::move(read->warnings, std::back_inserter(warnings));
    Building whole = joinBuildings(read->city, id);
    if (whole.parts.empty())
        return failure("The file contains no building", file.string(),
                       "Export the building as a closed solid");
    if (*kind != FileKind::mesh) {
        const float footM = lowestM(whole);  // before the building is moved from: arguments have no order
        whole = liftBuilding(std::move(whole), -footM);
    }
    return ImportMesh{std::make_shared<const Building>(std::move(whole)), {}, file.filename().string()};
}

}  // namespace noonmark
