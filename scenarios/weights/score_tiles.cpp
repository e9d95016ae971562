#include "scenarios/weights/score_tiles.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "core/engines/api/shadow_field.h"
#include "scenarios/weights/score.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

namespace {

std::map<std::string, double> listFigures(const Score& score) {
    std::map<std::string, double> figures{{"weighted_shade_m2h", score.weightedShadeM2h},
                                          {"score_m2", score.scoreM2},
                                          {"receiver_area_m2", score.receiverAreaM2}};
    for (const MonthFigures& month : score.months) {
        const std::string name =
            fmt::format("{:04}-{:02}", int(month.month.year()), unsigned(month.month.month()));
        figures["weighted_shade_m2h_" + name] = month.weightedShadeM2h;
        figures["score_m2_" + name] = month.scoreM2;
        figures["shadow_area_m2_" + name] = month.shadowAreaM2;
    }
    return figures;
}

class ScoreMeasure : public TileMeasure {
public:
    ScoreMeasure(const ScoredCity& scored, const TileQuestion& question)
        : scored_(scored), question_(question) {}

    [[nodiscard]] std::vector<TileMap> maps() const override { return listScoreMaps(); }

    Result<TileAnswer> measure(const Grid& tile, Progress& progress, const std::stop_token& stop) override {
        const auto zone = Zone::named(question_.settings.period.zone);
        if (!zone) return tl::make_unexpected(zone.error());
        const auto receivers = placeReceiversInPart(*scored_.city, question_.settings.region, tile, stop);
        if (!receivers) return tl::make_unexpected(receivers.error());
        Cost cost;
        countSkippedCells(cost, *receivers);
        if (receivers->cells.empty()) return TileAnswer{.result = {.cost = std::move(cost)}};
        auto score = computeScore(*scored_.city, *receivers, question_.sun, *zone, scored_.weights,
                                  question_.engine, progress, stop);
        if (!score) return tl::make_unexpected(score.error());
        return answerOf(*std::move(score), receivers->cells.size(), std::move(cost));
    }

private:
    // A score has no minutes of shadow.
    [[nodiscard]] TileAnswer answerOf(Score score, std::size_t receivers, Cost cost) const {
        constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
        TileAnswer answer{.result = {.sums = {receivers, unknown, unknown},
                                     .figures = listFigures(score),
                                     .cost = std::move(cost)}};
        answer.result.engineKey = score.engineKey.empty() ? question_.settings.engine : score.engineKey;
        answer.result.engine = std::move(score.engine);
        answer.bands.push_back(std::move(score.score));
        return answer;
    }

    ScoredCity scored_;
    TileQuestion question_;
};

}  // namespace

TileSubject makeScoreSubject(const ScoredCity& scored) {
    return {.key = "score;" + weightsCsv(scored.weights),
            .cities = {scored.city},
            .region = scored.region,
            .measure = [scored](const TileQuestion& question) -> std::unique_ptr<TileMeasure> {
                return std::make_unique<ScoreMeasure>(scored, question);
            }};
}

std::vector<TileMap> listScoreMaps(const LegendChoice& legend) {
    TileMap map{.name = "score", .title = "Shadow score", .bands = {}};
    map.bands.push_back({"shadow score", "", nullptr});
    map.colours =
        makeSignedScale(withoutQuantiles(legend), ColourScale::Of::wanted, {}, legendScale(1), 0, {});
    return {std::move(map)};
}

}  // namespace noonmark
