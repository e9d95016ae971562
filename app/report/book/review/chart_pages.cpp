#include <QLocale>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "app/report/book/review/review_pages.h"
#include "app/report/sheets/study_words.h"

namespace noonmark {

namespace {

constexpr std::size_t mostFixedDays = 31;
constexpr double carpetStepMin = 10;
constexpr std::size_t mostDaysDrawn = 6;

/// Charts of one place.
class PlaceCharts {
public:
    PlaceCharts(const ReviewScene& scene, std::size_t place)
        : scene_(scene),
          review_(scene.source.study.places[place]),
          days_(scene.source.study.timelines[place]),
          scale_(textScale(scene.settings.setup)) {}

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
        carpets.items.push_back({areas[0], carpetOf(false)});
        carpets.items.push_back({areas[1], carpetOf(true)});
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
                QStringLiteral("%1 measured. Grey: shadow in the baseline. Orange: incremental. Yellow: sun "
                               "gained. Violet: shadow with the proposal. Clock: %2.")
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

    [[nodiscard]] double minuteOf(const DayTimeline& day, Instant at) const {
        return scene_.sun.clock.minutesOf(day.day, at);
    }

    /// From one step to the next; thinned timelines have longer ones than the study.
    [[nodiscard]] double stepOf(const DayTimeline& day) const {
        double least = std::numeric_limits<double>::max();
        for (std::size_t i = 1; i < day.steps.size(); ++i)
            least = std::min(least, double((day.steps[i].at - day.steps[i - 1].at).count()) / 60000);
        return day.steps.size() < 2 ? scene_.source.study.stepMinutes : least;
    }

    [[nodiscard]] PageTimeline timelineOf(const DayTimeline& day) const {
        PageTimeline chart{.caption = captionOf(day), .stepMinutes = stepOf(day), .areaM2 = day.areaM2};
        chart.textScale = scale_;
        for (const PlaceStep& step : day.steps)
            chart.points.push_back({minuteOf(day, step.at), step.baselineM2, step.scenarioM2,
                                    step.incrementalM2, step.gainedM2});
        if (!chart.points.empty()) {
            chart.fromMin = std::floor(chart.points.front().minute / 60) * 60;
            chart.toMin = std::ceil((chart.points.back().minute + chart.stepMinutes) / 60) * 60;
        }
        return chart;
    }

    [[nodiscard]] Caption captionOf(const DayTimeline& day) const {
        const ShadowOnPlace& shadow = day.incremental;
        if (!shadow.enters())
            return {dayText(day.day), QStringLiteral("No incremental shadow in the rule's hours")};
        const auto time = [&](Instant at) {
            return QString::fromStdString(scene_.sun.clock.timeText(day.day, at));
        };
        return {dayText(day.day),
                QStringLiteral("Incremental shadow from %1 to %2; at most %3 (%4 %) at %5")
                    .arg(time(*shadow.enters()), time(*shadow.exits()), areaText(shadow.largestM2),
                         describeAmount(100 * shadow.largestM2 / std::max(1e-9, day.areaM2)),
                         time(*shadow.largestAt))};
    }

    [[nodiscard]] PageCarpet carpetOf(bool isIncremental) const {
        const auto first = std::chrono::sys_days{days_.front().day};
        const auto last = std::chrono::sys_days{days_.back().day};
        double from = 1440, to = 0;
        for (const DayTimeline& day : days_)
            for (const PlaceStep& step : day.steps) {
                from = std::min(from, minuteOf(day, step.at));
                to = std::max(to, minuteOf(day, step.at) + stepOf(day));
            }
        PageCarpet chart{.caption = carpetCaption(isIncremental), .isIncremental = isIncremental};
        chart.fromMin = std::floor(std::min(from, to) / 60) * 60;
        chart.toMin = std::max(chart.fromMin + 60, std::ceil(to / 60) * 60);
        chart.textScale = scale_;
        const int columns = int((last - first).count()) + 1;
        chart.image =
            QImage(columns, int((chart.toMin - chart.fromMin) / carpetStepMin), QImage::Format_RGB32);
        chart.image.fill(carpetColour(std::numeric_limits<double>::quiet_NaN(), isIncremental));
        for (std::size_t i = 0; i < days_.size(); ++i) {
            const int column = int((std::chrono::sys_days{days_[i].day} - first).count());
            const int next = i + 1 < days_.size()
                                 ? int((std::chrono::sys_days{days_[i + 1].day} - first).count())
                                 : columns;
            paintDay(chart, days_[i], column, next);
        }
        addMonths(chart, first, last);
        return chart;
    }

    [[nodiscard]] Caption carpetCaption(bool isIncremental) const {
        return {
            isIncremental ? QStringLiteral("Incremental shadow: share of the place")
                          : QStringLiteral("Shadow with the proposal: share of the place"),
            QStringLiteral("Day of the year across, time of day upwards; white: not in the rule's hours")};
    }

    /// A sampled day fills the columns up to the next one.
    void paintDay(PageCarpet& chart, const DayTimeline& day, int column, int next) const {
        if (day.areaM2 <= 0) return;
        const double step = stepOf(day);
        const int height = chart.image.height();
        for (const PlaceStep& at : day.steps) {
            const double share = (chart.isIncremental ? at.incrementalM2 : at.scenarioM2) / day.areaM2;
            const double minute = minuteOf(day, at.at) - chart.fromMin;
            const int low = std::clamp(int(minute / carpetStepMin), 0, height - 1);
            const int high = std::clamp(int((minute + step) / carpetStepMin - 1e-6), low, height - 1);
            for (int row = low; row <= high; ++row)
                for (int x = column; x < next; ++x)
                    chart.image.setPixelColor(x, height - 1 - row, carpetColour(share, chart.isIncremental));
        }
    }

    static QString monthName(CivilDate day) {
        return QLocale(QLocale::English).monthName(int(unsigned(day.month())), QLocale::ShortFormat);
    }

    static void addMonths(PageCarpet& chart, std::chrono::sys_days first, std::chrono::sys_days last) {
        for (auto day = first; day <= last; day += std::chrono::days{1})
            if (const CivilDate date{day}; unsigned(date.day()) == 1)
                chart.months.push_back({double((day - first).count()), monthName(date)});
    }

    [[nodiscard]] PageBars monthsChart() const {
        std::map<unsigned, PageBars::Group> months;
        for (std::size_t i = 0; i < days_.size(); ++i) {
            const double weight = i < scene_.sun.weights.size() ? scene_.sun.weights[i] : 1;
            auto& group = months[unsigned(days_[i].day.month())];
            group.name = monthName(days_[i].day);
            group.values.resize(3);
            group.values[0] += weight * days_[i].baseline.areaHoursM2;
            group.values[1] += weight * days_[i].scenario.areaHoursM2;
            group.values[2] += weight * days_[i].incremental.areaHoursM2;
        }
        const bool mirrored = scene_.source.study.rule.days.mirrored;
        PageBars chart{
            {QStringLiteral("Area × hours in shadow by month, m² h"),
             mirrored ? QStringLiteral("The measured half of the year stands for both halves: each "
                                       "month counts twice")
                      : QStringLiteral("Grey: baseline. Violet: with the proposal. Orange: "
                                       "incremental")},
            QStringLiteral("m² h"),
            {shade::baseline, shade::proposal, shade::incremental},
            {},
            scale_};
        for (auto& [month, group] : months) chart.groups.push_back(std::move(group));
        return chart;
    }

    const ReviewScene& scene_;
    const PlaceReview& review_;
    const std::vector<DayTimeline>& days_;
    double scale_;
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
