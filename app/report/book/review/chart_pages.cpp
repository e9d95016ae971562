#include <algorithm>
#include <cmath>
#include <map>

#include "app/report/book/review/review_pages.h"
#include "app/report/maps/sheet_text.h"

namespace noonmark {

namespace {

constexpr std::size_t maxFixedDays = 31;
constexpr double carpetRowMin = 10;
constexpr std::size_t maxDaysDrawn = 6;

/// Charts of one place.
class PlaceCharts {
public:
    PlaceCharts(const ReviewScene& scene, std::size_t place)
        : scene_(scene),
          review_(scene.source.study.places[place]),
          days_(scene.source.study.timelines[place]) {}

    [[nodiscard]] bool isDoubtful() const {
        return review_.verdict == Verdict::fail || review_.verdict == Verdict::borderline;
    }
    [[nodiscard]] bool isTouched() const {
        return std::ranges::any_of(days_, [](const DayTimeline& day) {
            return day.incremental.areaHoursM2 > 0 || day.gained.areaHoursM2 > 0;
        });
    }
    [[nodiscard]] bool coversARange() const { return days_.size() > maxFixedDays; }

    [[nodiscard]] QString name() const { return plainText(review_.name); }

    [[nodiscard]] std::vector<PageChart> timelines() const {
        std::vector<PageChart> charts;
        for (const DayTimeline* day : drawnDays()) charts.push_back(timelineOf(*day));
        return charts;
    }

    [[nodiscard]] BookPage timelinePage(bool isFirst) const { return page(sheetText("Timelines"), isFirst); }

    [[nodiscard]] std::vector<BookPage> yearPages() const {
        if (!coversARange()) return {};
        BookPage carpets = page(sheetText("Hours of the year in shadow"), false);
        const auto areas = gridAreas(scene_.settings.setup, 1, 2);
        carpets.items.push_back({areas[0], carpetOf(CarpetQuantity::scenario)});
        carpets.items.push_back({areas[1], carpetOf(CarpetQuantity::incremental)});
        BookPage months = page(sheetText("Shadow by month"), false);
        months.items.push_back({areas[0], monthsChart()});
        return {carpets, months};
    }

private:
    [[nodiscard]] QString areaText(double m2) const {
        return QString::fromStdString(formatArea(m2, scene_.settings.units));
    }

    [[nodiscard]] BookPage page(const QString& what, bool isFirst) const {
        return {what + QStringLiteral(": ") + name(),
                sheetText("%1 measured. Clock: %2.").arg(areaText(review_.areaM2), clockText(scene_)),
                isFirst ? name() : QString(),
                1,
                {}};
    }

    /// All days, or of a long range those next to solstices and equinoxes, and the one of most shadow.
    [[nodiscard]] std::vector<const DayTimeline*> drawnDays() const {
        std::vector<const DayTimeline*> drawn;
        if (days_.size() <= maxDaysDrawn) {
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
            quantity == CarpetQuantity::incremental ? sheetText("Incremental shadow: share of the place")
                                                    : sheetText("Shadow in the scenario: share of the place"),
            sheetText("Day of the year across, time of day upwards; not counted: the sun is down, or "
                      "outside the rule's hours")};
        CarpetChart chart = makeCarpetChart(days_, quantity, carpetRowMin, scene_.sun.clock);
        chart.legend = scene_.settings.legend;
        return {std::move(chart), caption};
    }

    [[nodiscard]] PageChart monthsChart() const {
        return {makeMonthBars(review_, scene_.settings.units),
                {sheetText("Area × hours in shadow by month"),
                 scene_.source.study.rule.days.mirrored
                     ? sheetText("The measured half of the year stands for both halves: each month "
                                 "counts twice")
                     : QString()}};
    }

    const ReviewScene& scene_;
    const PlaceReview& review_;
    const std::vector<DayTimeline>& days_;
};

/// Places whose timelines fill no more than half a page share pages; the others have their own.
class ChartPages {
public:
    explicit ChartPages(const ReviewScene& scene)
        : scene_(scene),
          areas_(gridAreas(scene.settings.setup, scene.settings.setup.landscape ? 2 : 1,
                           scene.settings.setup.landscape ? 2 : 4)) {}

    void add(const PlaceCharts& charts) {
        const std::vector<PageChart> drawn = charts.timelines();
        if (drawn.size() * 2 <= areas_.size())
            share(charts.name(), drawn);
        else
            fill(charts, drawn);
        std::vector<BookPage> years = charts.yearPages();
        if (!years.empty()) isShared_ = false;
        appendPages(pages_, std::move(years));
    }

    std::vector<BookPage> finish() { return std::move(pages_); }

private:
    void share(const QString& name, std::vector<PageChart> drawn) {
        if (!isShared_ || pages_.back().items.size() + drawn.size() > areas_.size())
            pages_.push_back(
                {sheetText("Timelines"), sheetText("Clock: %1.").arg(clockText(scene_)), {}, 1, {}});
        isShared_ = true;
        BookPage& page = pages_.back();
        page.bookmark += (page.bookmark.isEmpty() ? QString() : QStringLiteral("; ")) + name;
        for (PageChart& chart : drawn) {
            chart.caption.first = name + QStringLiteral(", ") + chart.caption.first;
            page.items.push_back({areas_[page.items.size()], std::move(chart)});
        }
    }

    void fill(const PlaceCharts& charts, const std::vector<PageChart>& drawn) {
        isShared_ = false;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            if (i % areas_.size() == 0) pages_.push_back(charts.timelinePage(i == 0));
            pages_.back().items.push_back({areas_[i % areas_.size()], drawn[i]});
        }
    }

    const ReviewScene& scene_;
    std::vector<QRectF> areas_;
    std::vector<BookPage> pages_;
    bool isShared_ = false;  // the last page
};

}  // namespace

std::vector<BookPage> makeChartPages(const ReviewScene& scene) {
    ChartPages book(scene);
    for (const PlaceRow& row : scene.list.rows) {
        const std::size_t place = row.reviews.front();
        if (scene.source.study.timelines.empty() || row.reviews.size() > 1) continue;
        const PlaceCharts charts(scene, place);
        if (charts.isDoubtful() || (scene.settings.allPages && charts.isTouched())) book.add(charts);
    }
    std::vector<BookPage> pages = book.finish();
    if (!pages.empty()) {
        pages.front().bookmark = sheetText("Timelines of places");
        pages.front().level = 0;
    }
    return pages;
}

}  // namespace noonmark
