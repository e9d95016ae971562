#include <algorithm>
#include <cmath>
#include <map>

#include "app/report/book/review/review_pages.h"

namespace noonmark {

namespace {

constexpr std::size_t mostFixedDays = 31;
constexpr double carpetRowMin = 10;
constexpr std::size_t mostDaysDrawn = 6;

/// Charts of one place.
class PlaceCharts {
public:
    PlaceCharts(const ReviewScene& scene, std::size_t place)
        : scene_(scene),
          review_(scene.source.study.places[place]),
          days_(scene.source.study.timelines[place]) {}

    [[nodiscard]] bool isTouched() const {
        return std::ranges::any_of(days_, [](const DayTimeline& day) {
            return day.incremental.areaHoursM2 > 0 || day.gained.areaHoursM2 > 0;
        });
    }
    [[nodiscard]] bool coversARange() const { return days_.size() > mostFixedDays; }

    [[nodiscard]] std::vector<BookPage> timelinePages() const {
        const PageSetup& setup = scene_.settings.setup;
        const auto areas = gridAreas(setup, setup.landscape ? 2 : 1, setup.landscape ? 2 : 4);
        std::vector<BookPage> pages;
        const auto drawn = drawnDays();
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            if (i % areas.size() == 0) pages.push_back(page(QStringLiteral("Timelines"), i == 0));
            pages.back().items.push_back({areas[i % areas.size()], timelineOf(*drawn[i])});
        }
        return pages;
    }

    [[nodiscard]] std::vector<BookPage> yearPages() const {
        if (!coversARange()) return {};
        BookPage carpets = page(QStringLiteral("Hours of the year in shadow"), false);
        const auto areas = gridAreas(scene_.settings.setup, 1, 2);
        carpets.items.push_back({areas[0], carpetOf(CarpetQuantity::scenario)});
        carpets.items.push_back({areas[1], carpetOf(CarpetQuantity::incremental)});
        BookPage months = page(QStringLiteral("Shadow by month"), false);
        months.items.push_back({areas[0], monthsChart()});
        return {carpets, months};
    }

private:
    [[nodiscard]] QString areaText(double m2) const {
        return QString::fromStdString(formatArea(m2, scene_.settings.units));
    }

    [[nodiscard]] BookPage page(const QString& what, bool isFirst) const {
        const QString name = plainText(review_.name);
        return {what + QStringLiteral(": ") + name,
                QStringLiteral("%1 measured. Clock: %2.")
                    .arg(areaText(review_.areaM2), plainText(scene_.source.study.clock)),
                isFirst ? name : QString(),
                1,
                {}};
    }

    /// All days, or of a long range those next to solstices and equinoxes, and the one of most shadow.
    [[nodiscard]] std::vector<const DayTimeline*> drawnDays() const {
        std::vector<const DayTimeline*> drawn;
        if (days_.size() <= mostDaysDrawn) {
            for (const DayTimeline& day : days_) drawn.push_back(&day);
            return drawn;
        }
        std::map<CivilDate, const DayTimeline*> chosen;
        for (const DiagramMoment& moment : scene_.moments) {
            const auto nearest = std::ranges::min_element(days_, {}, [&](const DayTimeline& day) {
                return std::abs((std::chrono::sys_days{day.day} - std::chrono::sys_days{moment.day}).count());
            });
            chosen.emplace(nearest->day, &*nearest);
        }
        const auto worst = std::ranges::max_element(
            days_, {}, [](const DayTimeline& day) { return day.incremental.areaHoursM2; });
        chosen.emplace(worst->day, &*worst);
        for (const auto& [day, timeline] : chosen) drawn.push_back(timeline);
        return drawn;
    }

    [[nodiscard]] PageChart timelineOf(const DayTimeline& day) const {
        const DayClock& clock = scene_.sun.clock;
        return {makeTimelineChart(day, scene_.source.study.stepMinutes, clock, scene_.settings.units),
                {dayText(day.day), describeIncremental(day, clock, scene_.settings.units)}};
    }

    [[nodiscard]] PageChart carpetOf(CarpetQuantity quantity) const {
        const Caption caption{
            quantity == CarpetQuantity::incremental
                ? QStringLiteral("Incremental shadow: share of the place")
                : QStringLiteral("Shadow in the scenario: share of the place"),
            QStringLiteral("Day of the year across, time of day upwards; not counted: the sun is down, or "
                           "outside the rule's hours")};
        return {makeCarpetChart(days_, quantity, carpetRowMin, scene_.sun.clock), caption};
    }

    [[nodiscard]] PageChart monthsChart() const {
        return {makeMonthBars(review_, scene_.settings.units),
                {QStringLiteral("Area × hours in shadow by month"),
                 scene_.source.study.rule.days.mirrored
                     ? QStringLiteral("The measured half of the year stands for both halves: each month "
                                      "counts twice")
                     : QString()}};
    }

    const ReviewScene& scene_;
    const PlaceReview& review_;
    const std::vector<DayTimeline>& days_;
};

}  // namespace

std::vector<BookPage> makeChartPages(const ReviewScene& scene) {
    std::vector<BookPage> pages;
    for (std::size_t i = 0; i < scene.source.study.timelines.size(); ++i) {
        const PlaceCharts charts(scene, i);
        if (!charts.isTouched()) continue;
        appendPages(pages, charts.timelinePages());
        appendPages(pages, charts.yearPages());
    }
    if (!pages.empty()) {
        pages.front().bookmark = QStringLiteral("Timelines of places");
        pages.front().level = 0;
    }
    return pages;
}

}  // namespace noonmark
