#include <limits>

#include "core/study/provenance_json.h"
#include "core/study/repeat_command.h"
#include "core/study/tiled_study.h"
#include "core/study/warnings_json.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

std::string tiledStudyJson(const TiledStudy& tiled) {
    Json json = Json::parse(studyJson(tiled.study));
    json["tiles"] = {{"side_cells", tiled.plan.side},
                     {"count", tiled.plan.count()},
                     {"empty", tiled.emptyTiles},
                     {"resumed", tiled.resumedTiles},
                     {"by_engine", tiled.tilesByEngine}};
    std::vector<RepeatOption> tiles;
    if (tiled.plan.side != TiledStudySettings::usualTileCells)
        tiles.push_back({"--tile", {std::to_string(tiled.plan.side)}});
    addRepeat(json, repeatCommand(tiled.study, std::numeric_limits<std::size_t>::max(), "city-study", tiles));
    return jsonText(json);
}

}  // namespace noonmark
