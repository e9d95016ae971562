#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/city/footprints/repair_footprint.h"
#include "tests/shared/shared_data.h"

namespace noonmark::tests {

struct HostilePolygon {
    std::string name;
    std::vector<RawRing> rings;
};

inline std::vector<RawRing> ringsOf(const nlohmann::json& json) {
    std::vector<RawRing> rings;
    for (const auto& ring : json) {
        rings.emplace_back();
        for (const auto& point : ring)
            rings.back().emplace_back(point.at(0).get<double>(), point.at(1).get<double>());
    }
    return rings;
}

/// The 59 polygons of the shared data, in the order of their names; empty if the data is missing.
inline std::vector<HostilePolygon> hostilePolygons() {
    std::vector<HostilePolygon> polygons;
    const auto folder = sharedData("hostile/earcut_polygons");
    if (!folder) return polygons;
    for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() != ".json" || name.starts_with('_')) continue;
        std::ifstream file(entry.path());
        polygons.push_back({name, ringsOf(nlohmann::json::parse(file))});
    }
    std::sort(polygons.begin(), polygons.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return polygons;
}

}  // namespace noonmark::tests
