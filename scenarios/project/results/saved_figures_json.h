#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "core/describe/figure_text.h"
#include "core/measures/statistics.h"
#include "core/receivers/place.h"
#include "scenarios/impact/impact.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score.h"

namespace noonmark {

struct SavedResult;
struct SavedSunByPlace;

/// Cells that became building or ground, as runs in grid order: [first cell, length, "building" or "ground"].
nlohmann::ordered_json changedCellsJson(const std::vector<CellChange>& change);

/// Parses such runs for a grid of `cells` cells. Throws nlohmann's exceptions or std::invalid_argument where
/// the JSON does not match.
std::vector<CellChange> parseChangedCells(const nlohmann::ordered_json& json, std::size_t cells);

/// Parse the figures that studyJson(), impactJson() and scoreJson() write. They throw nlohmann's exceptions
/// or std::invalid_argument where the JSON does not match.
ShadowStatistics parseStatistics(const nlohmann::ordered_json& study);
ImpactFigures parseImpactFigures(const nlohmann::ordered_json& figures);  ///< as of figuresJson()
ComparisonFigures parseComparison(const nlohmann::ordered_json& impact);
std::vector<MonthFigures> parseScoreMonths(const nlohmann::ordered_json& months);  ///< as of monthsJson()
/// What is there with trees, evergreens first; months and intervals as of `without`.
std::vector<ShadedScore> parseShadedScores(const nlohmann::ordered_json& score, const Score& without);
Score parseScore(const nlohmann::ordered_json& score);  ///< without grid, cells and warnings

/// Reads the values of these rows, which are of a table of R, into `read`. Throws likewise.
template <class R>
void readRows(std::span<const Figure> rows, const nlohmann::ordered_json& json, R& read) {
    for (const Figure& figure : rows) figure.set(&read, figures::readFigure(figure, json));
}

/// Sun by place as toJson() writes it, with what results keep beside it; a place with its outline as they do.
/// Throw likewise. In saved_places.cpp.
SavedSunByPlace parseSunByPlace(const SavedResult& result, const nlohmann::ordered_json& json);
Place parseSavedPlace(const nlohmann::ordered_json& json, const nlohmann::ordered_json& outline);

/// The errors of the quantities that a result shows; none where its version did not state them.
std::vector<ShownError> savedErrors(const nlohmann::ordered_json& result);

/// The study's error against the ray reference in one line, or the reason why it was not measured; empty
/// where the JSON holds neither.
std::string parseErrorText(const nlohmann::ordered_json& study);

}  // namespace noonmark
