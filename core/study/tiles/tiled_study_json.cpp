#include <limits>

#include "core/describe/command_flags.h"
#include "core/study/provenance/provenance_json.h"
#include "core/study/provenance/repeat_command.h"
#include "core/study/text/breakdown_text.h"
#include "core/study/text/warnings_json.h"
#include "core/study/tiles/tiled_study.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

std::string tiledStudyJson(const TiledStudy& tiled) {
    Json json = Json::parse(studyJson(tiled.study));
    if (tiled.study.settings.byMonth) json["by_month"] = monthsJson(tiled.months);
    json["tiles"] = {{"side_cells", tiled.plan.side},
                     {"count", tiled.plan.count()},
                     {"empty", tiled.emptyTiles},
                     {"resumed", tiled.resumedTiles},
                     {"by_engine", tiled.tilesByEngine}};
    std::vector<CommandOption> tiles;
    if (tiled.plan.side != TiledStudySettings::defaultTileCells)
        tiles.push_back({flags::tile, {std::to_string(tiled.plan.side)}});
    addRepeat(json,
              makeRepeatCommand(tiled.study, std::numeric_limits<std::size_t>::max(), "city-study", tiles));
    return toJsonText(json);
}

}  // namespace noonmark
