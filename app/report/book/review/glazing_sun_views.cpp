#include "app/report/book/review/glazing_sun_views.h"

#include <algorithm>
#include <array>

#include "app/report/book/review/review_pages.h"
#include "app/report/book/sun_view.h"
#include "core/measures/place_run.h"
#include "core/review/rule/rule_moments.h"

namespace noonmark {

namespace {

constexpr double viewDpi = 160;
constexpr double maxViewPixels = 1400;
constexpr float nearM = 200, besideM = 25;  // windows and ground shown around what changes

/// The ground that the views show.
Box2 groundOf(const GlazingBookSource& source, const City& proposal, const City& removed) {
    Box2 box;
    for (const City* city : {&proposal, &removed})
        for (const auto& building : city->buildings) box.add(bounds(*building));
    const Box2 changed = box;
    for (const ReviewedPane& pane : source.study.panes) {
        const glm::vec2 at(glm::dvec2(pane.pane.middle));
        const bool isNear = changed.empty() || (glm::all(glm::greaterThan(at, changed.low - nearM)) &&
                                                glm::all(glm::lessThan(at, changed.high + nearM)));
        if (isNear) box.add(at);
    }
    return {box.low - besideM, box.high + besideM};
}

/// The views of one city.
struct CityViews {
    SunViewScene scene;
    QString name;
};

Result<std::array<CityViews, 2>> makeViews(const GlazingBookSource& source, const std::stop_token& stop) {
    DiagramScene before{source.baseline, {}, {}, {}}, after;
    after.proposal = keepOwnBuildings(source.scenario, source.baseline);
    after.city = keepOwnBuildings(source.scenario, after.proposal);
    const City removed = keepOwnBuildings(source.baseline, source.scenario);
    const Box2 ground = groundOf(source, after.proposal, removed);
    auto existing = SunViewScene::make(before, ground, stop, after.proposal);
    if (!existing) return tl::make_unexpected(existing.error());
    auto proposed = SunViewScene::make(after, ground, stop, after.proposal);
    if (!proposed) return tl::make_unexpected(proposed.error());
    return std::array{CityViews{*std::move(existing), plainText(source.labels.from)},
                      CityViews{*std::move(proposed), plainText(source.labels.to)}};
}

Caption captionOf(const RuleMoment& moment, const QString& city) {
    return {QStringLiteral("%1, %2: %3").arg(dayText(moment.day), QString::fromStdString(moment.clock), city),
            QStringLiteral("Sun: azimuth %1°, altitude %2°")
                .arg(double(moment.sun.azimuthDeg), 0, 'f', 1)
                .arg(double(moment.sun.altitudeDeg), 0, 'f', 1)};
}

}  // namespace

bool hasSunViews(const Rule& rule) {
    const auto& diagrams = rule.deliverables.diagrams;
    return diagrams && std::ranges::find(diagrams->views, "view from the sun") != diagrams->views.end();
}

Result<std::vector<BookPage>> makeGlazingSunViews(const GlazingBookSource& source,
                                                  const BookSettings& settings, Progress& progress,
                                                  const std::stop_token& stop) {
    std::vector<BookPage> pages;
    if (!hasSunViews(source.study.rule)) return pages;
    const GlazingStudy& study = source.study;
    const auto moments = computeRuleMoments(
        study.rule, {observerOfPlaces(source.scenario), study.settings.zone, study.year}, {}, stop);
    if (!moments) return tl::make_unexpected(moments.error());
    const auto views = makeViews(source, stop);
    if (!views) return tl::make_unexpected(views.error());
    const auto areas = gridAreas(settings.setup, 2, settings.setup.landscape ? 2 : 3);
    const QSizeF shown = mapAreaOf(areas.front(), textScale(settings.setup)).size() * viewDpi / 72;
    const QSize size = (shown * std::min(1.0, maxViewPixels / shown.width())).toSize();
    const QString title = QStringLiteral("Views from the sun");
    std::size_t used = 0;
    for (const RuleMoment& moment : *moments) {
        progress.report(double(used) / double(2 * moments->size()), "drawing views from the sun");
        for (const CityViews& view : *views) {
            if (stop.stop_requested()) return cancelled();
            if (used % areas.size() == 0)
                pages.push_back({title,
                                 QStringLiteral("Without perspective, as the sun sees it: what is visible is "
                                                "sunlit, what is hidden is in shadow. New and changed "
                                                "buildings are violet. Clock: %1.")
                                     .arg(plainText(study.clock.text())),
                                 pages.empty() ? title : QString(),
                                 0,
                                 {}});
            pages.back().items.push_back(
                {areas[used++ % areas.size()],
                 PagePicture{view.scene.paint(moment.sun, size), captionOf(moment, view.name)}});
        }
    }
    return pages;
}

}  // namespace noonmark
