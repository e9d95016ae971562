#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "core/describe/figure.h"
#include "core/measures/places/place_timeline.h"

namespace noonmark {

/// Shadow on a place over some days, in m2 x h.
struct AreaHours {
    int days = 0;
    double sunlitHours = 0;
    double theoreticalM2h = 0;  ///< area x sunlit hours: what the place would have without any shadow
    double baselineM2h = 0;
    double scenarioM2h = 0;
    double incrementalM2h = 0;
    double gainedM2h = 0;

    void add(const DayTimeline& day);
    /// Of the theoretical sum, 0 to 1; 0 without sun.
    [[nodiscard]] double shareOf(double m2h) const { return theoreticalM2h > 0 ? m2h / theoreticalM2h : 0; }
    bool operator==(const AreaHours&) const = default;
};

/// The day on which a place has most of one kind of shadow.
struct MostShadow {
    CivilDate day;
    double areaHoursM2 = 0;
};

/// Quarters of a year by the days on which planners measure: from 21 March, 21 June, 21 September and 21
/// December on.
enum class Quarter { fromMarch, fromJune, fromSeptember, fromDecember };
inline constexpr std::array quarterNames{"21 Mar to 20 Jun", "21 Jun to 20 Sep", "21 Sep to 20 Dec",
                                         "21 Dec to 20 Mar"};
Quarter quarterOf(CivilDate day);

/// Sums of a period, day by day.
class PlaceSums {
public:
    void add(const DayTimeline& day);

    [[nodiscard]] const AreaHours& all() const { return all_; }
    [[nodiscard]] const std::array<AreaHours, 4>& quarters() const { return quarters_; }
    /// "2026-01", "2026-02", ...
    [[nodiscard]] const std::map<std::string, AreaHours>& months() const { return months_; }
    /// The first day with most scenario shadow, and with most incremental shadow; none without any.
    [[nodiscard]] const std::optional<MostShadow>& mostScenario() const { return mostScenario_; }
    [[nodiscard]] const std::optional<MostShadow>& mostIncremental() const { return mostIncremental_; }
    /// The largest incremental area at one step of any day, and when.
    [[nodiscard]] double largestIncrementalM2() const { return largestM2_; }
    [[nodiscard]] const std::optional<Instant>& largestIncrementalAt() const { return largestAt_; }

private:
    AreaHours all_;
    std::array<AreaHours, 4> quarters_;
    std::map<std::string, AreaHours> months_;
    std::optional<MostShadow> mostScenario_, mostIncremental_;
    double largestM2_ = 0;
    std::optional<Instant> largestAt_;
};

/// The areas of a place at one step, without its time.
const Figures<PlaceStep>& placeStepFigures();

const Figures<AreaHours>& areaHoursFigures();

}  // namespace noonmark
