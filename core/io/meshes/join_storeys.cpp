#include "core/io/meshes/join_storeys.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <unordered_map>

#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_parts.h"
#include "core/city/meshes/mesh_sheets.h"

namespace noonmark {

namespace {

using Indices = std::vector<std::size_t>;

// Joins units whose lowest edges lie on the edges of a lower unit: a higher roof and the walls that rise to
// it from the surrounding roof.
class StepJoiner {
public:
    explicit StepJoiner(const std::vector<MeshUnit>& units) : units_(units), sets_(units.size()) {
        TriangleMesh all;
        for (const MeshUnit& unit : units) {
            append(all, unit.mesh);
            lowM_.push_back(computeBox(unit.mesh).low.z);
        }
        point_ = weldIndices(all.vertices, touchM);
        std::uint32_t first = 0;
        for (const MeshUnit& unit : units) {
            firstPoint_.push_back(first);
            first += std::uint32_t(unit.mesh.vertices.size());
        }
    }

    std::vector<MeshUnit> join() {
        findLowestOfEdges();
        for (std::size_t i = 0; i < units_.size(); ++i)
            if (const std::size_t carrier = carrierOf(i); carrier != i) sets_.join(i, carrier);
        joinSurrounded();
        std::map<std::size_t, MeshUnit> joined;
        for (std::size_t i = 0; i < units_.size(); ++i) {
            MeshUnit& unit = joined.try_emplace(sets_.of(i), MeshUnit{{}, units_[i].object}).first->second;
            append(unit.mesh, units_[i].mesh);
        }
        std::vector<MeshUnit> made;
        for (auto& [root, unit] : joined) made.push_back(std::move(unit));
        return made;
    }

private:
    void findLowestOfEdges() {
        for (std::size_t i = 0; i < units_.size(); ++i)
            for (const glm::uvec3 t : units_[i].mesh.triangles)
                for (int k = 0; k < 3; ++k) {
                    std::size_t& lowest = lowestOf_.try_emplace(edgeAt(i, t, k), i).first->second;
                    if (lowM_[i] < lowM_[lowest]) lowest = i;
                }
    }

    [[nodiscard]] std::uint64_t edgeAt(std::size_t unit, glm::uvec3 t, int side) const {
        return edgeOf(point_[firstPoint_[unit] + t[side]], point_[firstPoint_[unit] + t[(side + 1) % 3]]);
    }

    // The unit that holds most of a unit's lowest edges; itself if none does.
    [[nodiscard]] std::size_t carrierOf(std::size_t unit) const {
        constexpr float lowestEdgesM = 0.1F, lowerM = 0.5F;
        const TriangleMesh& mesh = units_[unit].mesh;
        std::map<std::size_t, int> edges;
        for (const glm::uvec3 t : mesh.triangles)
            for (int k = 0; k < 3; ++k) {
                if (std::max(mesh.vertices[t[k]].z, mesh.vertices[t[(k + 1) % 3]].z) >
                    lowM_[unit] + lowestEdgesM)
                    continue;
                const std::size_t other = lowestOf_.at(edgeAt(unit, t, k));
                if (lowM_[other] < lowM_[unit] - lowerM) ++edges[other];
            }
        std::size_t best = unit;
        int most = 0;
        for (const auto& [other, count] : edges)
            if (count > most) best = other, most = count;
        return best;
    }

    // For edges that do not match: joins a unit that starts above the ground with the lower units around half
    // of its outline that reach up to its foot.
    void joinSurrounded() {
        std::vector<std::vector<Footprint>> outlines;
        std::vector<Box2> boxes, grown;
        for (const MeshUnit& unit : units_) {
            outlines.push_back(computeCover(unit.mesh));
            boxes.emplace_back();
            for (const Footprint& piece : outlines.back()) boxes.back().add(bounds(piece));
            grown.push_back({boxes.back().low - besideM, boxes.back().high + besideM});
        }
        std::vector<Indices> around(units_.size());
        for (const auto& [unit, other] : findMeetingBoxes(boxes, grown))
            if (mayCarry(other, unit)) around[unit].push_back(other);
        for (std::size_t i = 0; i < units_.size(); ++i) joinSurrounded(i, around[i], outlines);
    }

    [[nodiscard]] bool mayCarry(std::size_t other, std::size_t unit) const {
        constexpr float reachM = 0.5F;
        return lowM_[other] + openAirM < lowM_[unit] &&
               computeBox(units_[other].mesh).high.z + reachM > lowM_[unit];
    }

    void joinSurrounded(std::size_t unit, const Indices& around,
                        const std::vector<std::vector<Footprint>>& outlines) {
        constexpr double surrounded = 0.5;
        double all = 0, most = 0;
        std::size_t carrier = unit;
        for (const std::size_t other : around) {
            const double share = computeShareBeside(outlines[unit], outlines[other], double(besideM));
            all += share;
            if (share > most) most = share, carrier = other;
        }
        if (all >= surrounded) sets_.join(unit, carrier);
    }

    static constexpr float besideM = 0.1F;
    const std::vector<MeshUnit>& units_;
    DisjointSets sets_;
    std::vector<float> lowM_;
    std::vector<std::uint32_t> point_, firstPoint_;
    std::unordered_map<std::uint64_t, std::size_t>
        lowestOf_;  // for each edge, the unit with the lowest point
};

bool isFloorOf(const TriangleMesh& sheet, const std::vector<Footprint>& sheetOutline,
               const TriangleMesh& body, const std::vector<Footprint>& bodyOutline) {
    constexpr float belowM = 0.5F;
    const Box3 box = computeBox(body);
    const float heightM = computeBox(sheet).low.z;
    if (isLevel(body) || heightM < box.low.z - belowM || heightM > box.high.z) return false;
    double sheetM2 = 0, bodyM2 = 0;
    for (const Footprint& piece : sheetOutline) sheetM2 += area(piece);
    for (const Footprint& piece : bodyOutline) bodyM2 += area(piece);
    const double shared = computeSharedArea(sheetOutline, bodyOutline);
    return shared >= 0.9 * sheetM2 && shared >= 0.5 * bodyM2;
}

}  // namespace

std::vector<MeshUnit> joinSteps(const std::vector<MeshUnit>& units) { return StepJoiner(units).join(); }

void joinFloors(std::vector<MeshUnit>& units) {
    std::vector<std::vector<Footprint>> outlines(units.size());
    std::vector<Box2> sheets(units.size()), bodies(units.size());
    if (std::ranges::none_of(units, [](const MeshUnit& unit) { return isLevel(unit.mesh); })) return;
    for (std::size_t i = 0; i < units.size(); ++i) {
        outlines[i] = computeCover(units[i].mesh);
        for (const Footprint& piece : outlines[i])
            (isLevel(units[i].mesh) ? sheets : bodies)[i].add(bounds(piece));
    }
    for (const auto& [sheet, body] : findMeetingBoxes(sheets, bodies)) {
        if (units[sheet].mesh.triangles.empty() ||
            !isFloorOf(units[sheet].mesh, outlines[sheet], units[body].mesh, outlines[body]))
            continue;
        append(units[body].mesh, units[sheet].mesh);
        units[sheet].mesh = {};
    }
    std::erase_if(units, [](const MeshUnit& unit) { return unit.mesh.triangles.empty(); });
}

}  // namespace noonmark
