#include <algorithm>

#include "app/report/book/flow.h"
#include "app/report/book/review/review_pages.h"
#include "app/report/book/sun_view.h"
#include "app/report/sheets/study_words.h"
#include "core/base/progress_share.h"

namespace noonmark {

namespace {

constexpr double pictureDpi = 200;
constexpr std::size_t mostSunViewsADay = 3;

QString sunText(const SunStep& sun) {
    return QStringLiteral("Sun: azimuth %1°, altitude %2°")
        .arg(double(sun.azimuthDeg), 0, 'f', 1)
        .arg(double(sun.altitudeDeg), 0, 'f', 1);
}

Caption captionOf(const DiagramMoment& moment) {
    return {dayText(moment.day) + QStringLiteral(", ") + moment.time, sunText(moment.sun)};
}

/// The ground that a diagram shows.
Box2 groundOf(glm::dvec2 centre, double scale, const QRectF& map) {
    const glm::dvec2 half = glm::dvec2(map.width(), map.height()) / pointsPerMetre(scale) / 2.0;
    return {glm::vec2(centre - half), glm::vec2(centre + half)};
}

PageItem footOf(const ReviewScene& scene, double scale, double cellM) {
    const PageSetup& setup = scene.settings.setup;
    const double height = diagramFootPt(textScale(setup));
    const QRectF all = contentArea(setup);
    QString note = QStringLiteral("Times: %1.").arg(plainText(scene.source.study.clock));
    if (cellM > 0)
        note += QStringLiteral(" Edges of shadows follow cells of %1 m, because the ground is not level.")
                    .arg(describeAmount(cellM, 2));
    return {{all.left(), all.bottom() - height, all.width(), height},
            DiagramFoot{scale, plainText(nameOf(setup.paper)), note, textScale(setup)}};
}

QString fromTo(const ReviewScene& scene) {
    return QStringLiteral("%1 compared with %2. North is up.")
        .arg(plainText(scene.source.labels.to), plainText(scene.source.labels.from));
}

/// The moments of one day.
struct DayMoments {
    CivilDate day;
    std::vector<DiagramMoment> moments;
};

std::vector<DayMoments> byDay(const std::vector<DiagramMoment>& moments) {
    std::vector<DayMoments> days;
    for (const DiagramMoment& moment : moments) {
        if (days.empty() || days.back().day != moment.day) days.push_back({moment.day, {}});
        days.back().moments.push_back(moment);
    }
    return days;
}

/// The first moment of a day, the one nearest to noon, and the last.
std::vector<DiagramMoment> fewOf(const std::vector<DiagramMoment>& all) {
    if (all.size() <= mostSunViewsADay) return all;
    const auto noon = std::ranges::min_element(
        all, {}, [](const DiagramMoment& moment) { return std::abs(moment.minute - 720); });
    std::vector<DiagramMoment> few{all.front()};
    if (noon != all.begin() && noon != all.end() - 1) few.push_back(*noon);
    few.push_back(all.back());
    return few;
}

BookPage pageOf(const QString& what, CivilDate day, const QString& subtitle, bool isFirst) {
    const QString title = what + QStringLiteral(", ") + dayText(day);
    return {title, subtitle, isFirst ? dayText(day) : QString(), 1, {}};
}

/// A page without items that only carries the bookmark of a chapter is not wanted: the chapter's bookmark is
/// that of its first page, and the days are below it.
void addChapter(std::vector<BookPage>& pages, const QString& chapter) {
    if (pages.empty()) return;
    pages.front().bookmark = chapter;
    pages.front().level = 0;
}

}  // namespace

Result<Diagram> makeDiagram(const ReviewScene& scene, const DiagramMoment& moment,
                            const DiagramLayout& layout, const QRectF& area, Progress& progress,
                            const std::stop_token& stop) {
    const double scale = textScale(scene.settings.setup);
    const Box2 ground = groundOf(layout.centre, layout.scale, mapAreaOf(area, scale));
    auto shadows = outlineShadows(scene.before, &scene.after, moment.sun,
                                  {ground, scene.source.study.settings.cellM}, progress, stop);
    if (!shadows) return tl::make_unexpected(shadows.error());
    return Diagram{scene.diagrams, *std::move(shadows), layout.centre,
                   layout.scale,   captionOf(moment),   scale};
}

Result<std::vector<BookPage>> makeDiagramPages(const ReviewScene& scene, Progress& progress,
                                               const std::stop_token& stop) {
    const DiagramLayout layout = layoutOf(scene);
    const auto areas = diagramAreas(scene.settings.setup, layout.columns, layout.rows);
    std::vector<BookPage> pages;
    std::size_t done = 0;
    for (const auto& [day, moments] : byDay(scene.moments))
        for (std::size_t i = 0; i < moments.size(); ++i) {
            if (i % areas.size() == 0)
                pages.push_back(pageOf(QStringLiteral("Shadow diagrams"), day, fromTo(scene), i == 0));
            progress.report(double(done++) / double(scene.moments.size()), "drawing diagrams");
            NoProgress quiet;
            const QRectF& area = areas[i % areas.size()];
            auto diagram = makeDiagram(scene, moments[i], layout, area, quiet, stop);
            if (!diagram) return tl::make_unexpected(diagram.error());
            const double cellM = diagram->shadows.cellM;
            pages.back().items.push_back({area, *std::move(diagram)});
            if (i % areas.size() == 0) pages.back().items.push_back(footOf(scene, layout.scale, cellM));
        }
    addChapter(pages, QStringLiteral("Shadow diagrams"));
    return pages;
}

Result<std::vector<BookPage>> makeSunViewPages(const ReviewScene& scene, Progress& progress,
                                               const std::stop_token& stop) {
    const PageSetup& setup = scene.settings.setup;
    const bool wide = setup.landscape;
    const auto areas = diagramAreas(setup, wide ? 2 : 1, wide ? 2 : 3);
    const DiagramLayout layout = layoutOf(scene);
    const QRectF picture = mapAreaOf(areas.front(), textScale(setup));
    const QSize size = (picture.size() * pictureDpi / 72).toSize();
    std::vector<BookPage> pages;
    const QRectF shown =
        mapAreaOf(diagramAreas(setup, layout.columns, layout.rows).front(), textScale(setup));
    const auto views =
        SunViewScene::make(*scene.diagrams, groundOf(layout.centre, layout.scale, shown), stop);
    if (!views) return tl::make_unexpected(views.error());
    for (const auto& [day, moments] : byDay(scene.moments)) {
        const auto few = fewOf(moments);
        for (std::size_t i = 0; i < few.size(); ++i) {
            if (stop.stop_requested()) return cancelled();
            progress.report(0, "drawing views from the sun");
            if (i % areas.size() == 0)
                pages.push_back(pageOf(QStringLiteral("View from the sun"), day,
                                       QStringLiteral("%1, without perspective, as the sun sees it: what is "
                                                      "visible is sunlit, what is hidden is in shadow. "
                                                      "The proposal is violet, places are green.")
                                           .arg(plainText(scene.source.labels.to)),
                                       i == 0));
            pages.back().items.push_back(
                {areas[i % areas.size()], PagePicture{views->paint(few[i].sun, size), captionOf(few[i])}});
        }
    }
    addChapter(pages, QStringLiteral("Views from the sun"));
    return pages;
}

}  // namespace noonmark
