#include "scenarios/project/results/changed_cells_json.h"

#include <algorithm>
#include <stdexcept>

#include "core/base/json_number.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

constexpr const char* building = "building";
constexpr const char* ground = "ground";

CellChange changeNamed(const Json& json) {
    if (json == building) return CellChange::becameBuilding;
    if (json == ground) return CellChange::becameGround;
    throw std::invalid_argument("a changed cell is of an unknown kind");
}

}  // namespace

Json changedCellsJson(const std::vector<CellChange>& change) {
    Json json = Json::array();
    for (std::size_t first = 0, end = 0; first < change.size(); first = end) {
        for (end = first + 1; end < change.size() && change[end] == change[first];) ++end;
        if (change[first] == CellChange::none) continue;
        json.push_back({first, end - first, change[first] == CellChange::becameBuilding ? building : ground});
    }
    return json;
}

std::vector<CellChange> parseChangedCells(const Json& json, std::size_t cells) {
    std::vector<CellChange> change(cells, CellChange::none);
    for (const Json& run : json) {
        const auto first = wholeNumberFrom<std::size_t>(run.at(0)),
                   count = wholeNumberFrom<std::size_t>(run.at(1));
        if (first > cells || count > cells - first)
            throw std::invalid_argument("changed cells lie outside the grid");
        std::fill_n(change.begin() + std::ptrdiff_t(first), count, changeNamed(run.at(2)));
    }
    return change;
}

}  // namespace noonmark
