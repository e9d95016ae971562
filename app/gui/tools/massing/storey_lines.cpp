#include "app/gui/tools/massing/storey_lines.h"

#include <algorithm>

#include "core/city/meshes/mesh_section.h"

namespace noonmark {

namespace {

constexpr int maxFloors = 1000;
constexpr double sameLevelM = 0.01;

void addRing(const Ring& ring, double z, std::vector<std::vector<glm::vec3>>& lines) {
    std::vector<glm::vec3>& line = lines.emplace_back();
    for (const glm::vec2 point : ring) line.emplace_back(point, float(z));
}

void addOutline(const Footprint& outline, double z, std::vector<std::vector<glm::vec3>>& lines) {
    addRing(outline.outer, z, lines);
    for (const Ring& hole : outline.holes) addRing(hole, z, lines);
}

void addFloor(const Part& part, double z, std::vector<std::vector<glm::vec3>>& lines) {
    if (!part.mesh) return addOutline(part.footprint, z, lines);
    for (const Footprint& piece : cutSection(*part.mesh, z).pieces) addOutline(piece, z, lines);
}

}  // namespace

std::vector<std::vector<glm::vec3>> makeStoreyLines(const Building& building, double groundM,
                                                    double storeyHeightM) {
    std::vector<std::vector<glm::vec3>> lines;
    const double topM = double(noonmark::topM(building));
    for (int floor = 1; floor <= maxFloors; ++floor) {
        const double z = groundM + floor * storeyHeightM;
        if (z > topM - sameLevelM) break;
        for (const Part& part : building.parts)
            if (double(part.bottomM) <= z - sameLevelM && z + sameLevelM <= double(part.topM))
                addFloor(part, z, lines);
    }
    return lines;
}

}  // namespace noonmark
