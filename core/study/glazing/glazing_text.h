#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/io/elements/write_elements.h"
#include "core/measures/palette.h"
#include "core/study/glazing/glazing_study.h"
#include "core/study/provenance/repeat_command.h"

namespace noonmark {

/// A value of windows that elevations show, and its scale. The scale follows from the rule alone, so that all
/// sheets of a rule can be compared: it ends at twice the rule's limit.
struct GlazingMeasure {
    std::size_t criterion = 0;  ///< index in Rule::criteria
    std::string title;          ///< "Sun in the room"
    std::string unit;           ///< "hours", "% of the sky's light", "% of the year's probable sun"
    LegendScale scale;          ///< in that unit
    LegendScale changeScale;    ///< of differences: as far as the limit
};

/// The first deciding criterion about time, the first about the sky and the first about probable sun, as far
/// as the rule has them; of a rule without limits the first of each.
std::vector<GlazingMeasure> listGlazingMeasures(const Rule& rule);

/// The value of a window in the measure's unit, before or after. Of a criterion that asks whether a condition
/// is met it is the sun of the day that decides. None: the window has no such value.
std::optional<double> shownValue(const Rule& rule, const GlazingMeasure& measure, const GlazingReview& review,
                                 bool former);

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
