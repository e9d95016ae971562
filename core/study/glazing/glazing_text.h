#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/io/elements/write_elements.h"
#include "core/study/glazing/glazing_study.h"
#include "core/study/provenance/repeat_review.h"

namespace noonmark {

/// A row for each window: the columns that docs/rules.md lists, lon_deg, lat_deg and elevation_m, and the
/// source columns.
ElementTable makeGlazingTable(const GlazingStudy& study, const ReviewLabels& labels);

/// "09:12-10:40 13:05-14:00" in the rule's clock; empty: no sun.
std::string bandsText(const GlazingStudy& study, CivilDate day, const std::vector<SunBand>& bands);

/// The value of a criterion as the table has it: minutes, percent, or 1 and 0.
std::string valueText(const Criterion& criterion, const std::optional<Measured>& value);

/// The review as JSON. Scripts rely on `rule`, `from`, `to`, `windows` (`id`, `building`, `floor`,
/// `azimuth_deg`, `verdict`, `verdict_before`, `bands`, `bands_before`, `criteria`), `buildings`, `counts`
/// and `not_checked`. `labels.sheets` holds all options of the command besides rule, scenarios, year and
/// zone.
nlohmann::ordered_json glazingReviewJson(const GlazingStudy& study, const ReviewLabels& labels);

/// The options of `review run` that name the same windows.
std::vector<CommandOption> makeRepeatOptions(const ElementSettings& windows);

/// The noonmark-cli command line that reproduces the review, as of a review of places.
Result<std::string> makeRepeatCommand(const GlazingStudy& study, const ReviewLabels& labels,
                                      std::size_t width = 120);

}  // namespace noonmark
