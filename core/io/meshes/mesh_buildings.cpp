#include "core/io/meshes/mesh_buildings.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <memory>

#include "core/base/stop_scope.h"
#include "core/city/meshes/mesh_parts.h"
#include "core/city/meshes/mesh_sheets.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/io/meshes/mesh_units.h"

namespace noonmark {

namespace {

// Adds units to a piece as buildings.
class BuildingAdder {
public:
    BuildingAdder(const std::vector<NamedMesh>& objects, const std::string& file, FilePiece& piece)
        : objects_(objects), file_(file), piece_(piece) {}

    void add(const std::vector<MeshUnit>& units, Progress& progress, const std::stop_token& stop) {
        std::vector<std::size_t> ofObject(objects_.size());
        for (const MeshUnit& unit : units) ++ofObject[unit.object];
        std::vector<std::size_t> number(objects_.size());
        std::vector<std::string> ids;
        for (const MeshUnit& unit : units) {
            const std::string& name = objects_[unit.object].name;
            const std::string id = name.empty() ? "mesh" : name;
            const std::size_t n = ++number[unit.object];
            ids.push_back(ofObject[unit.object] == 1 ? id : fmt::format("{} {}", id, n));
        }
        std::vector<MeshParts> made = makeParts(units, ids, progress, stop);
        for (std::size_t i = 0; i < units.size() && !stop.stop_requested(); ++i)
            add(std::move(made[i]), objects_[units[i].object].name, ids[i]);
    }

private:
    [[nodiscard]] std::vector<MeshParts> makeParts(const std::vector<MeshUnit>& units,
                                                   const std::vector<std::string>& ids, Progress& progress,
                                                   const std::stop_token& stop) const {
        std::vector<MeshParts> made(units.size());
        std::atomic<std::size_t> done = 0;
        tbb::parallel_for(std::size_t{0}, units.size(), [&](std::size_t i) {
            const StopScope scope(stop);
            if (StopScope::isStopped()) return;
            made[i] = partsOf(units[i].mesh, ids[i], file_ + ": " + ids[i]);
            progress.report(double(++done) / double(units.size()), "finding the buildings");
        });
        return made;
    }

    void add(MeshParts made, const std::string& name, const std::string& id) {
        std::ranges::move(made.warnings, std::back_inserter(piece_.warnings));
        if (made.parts.empty()) return;
        markOverhangs(made.parts, [](glm::dvec2) { return 0.0F; });
        for (Part& part : made.parts) closeToTheGround(part);
        piece_.buildings.push_back(
            std::make_shared<const Building>(Building{id, name, {}, std::move(made.parts)}));
    }

    // A deck: every engine treats it as solid down to the ground.
    static void closeToTheGround(Part& part) {
        const bool isSlab = !part.mesh && part.topM - part.bottomM < 2 * levelSheetM;
        if (isSlab && !part.isOverhanging && part.bottomM > 0 && part.bottomM <= openAirM) part.bottomM = 0;
    }

    const std::vector<NamedMesh>& objects_;
    const std::string& file_;
    FilePiece& piece_;
};

// The lowest point of each building is its base.
void stateBases(FilePiece& piece) {
    piece.ownZero = true;
    for (const auto& building : piece.buildings)
        piece.groundM.emplace_back(std::ranges::min_element(building->parts, {}, &Part::bottomM)->bottomM);
}

}  // namespace

bool addBuildings(const std::vector<NamedMesh>& objects, const std::string& file, FilePiece& piece,
                  Progress& progress, const std::stop_token& stop) {
    progress.report(0, "finding the buildings");
    const std::vector<NamedMesh> joined = joinSurfaces(objects);
    BuildingAdder adder(joined, file, piece);
    adder.add(detectUnits(joined, file, piece.warnings, stop), progress, stop);
    stateBases(piece);
    return !stop.stop_requested();
}

}  // namespace noonmark
