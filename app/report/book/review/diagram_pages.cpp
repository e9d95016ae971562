#include <algorithm>
#include <cmath>

#include "app/report/book/flow.h"
#include "app/report/book/review/review_pages.h"
#include "app/report/book/sun_view.h"
#include "app/report/maps/answer_legends.h"
#include "app/report/maps/city_painter.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/study_text.h"
#include "core/describe/text.h"
#include "core/measures/shadow_outlines.h"
#include "core/review/places/verdict_text.h"
#include "core/review/rule/rule_days.h"

namespace noonmark {

namespace {

constexpr double pictureDpi = 200;
constexpr double maxPicturePixels = 2200;  // a picture for large paper need not be finer
constexpr std::size_t maxSunViewsADay = 3;

QString sunText(const SunStep& sun) {
    return sheetText("Sun: azimuth %1°, altitude %2°")
        .arg(fixedNumber(double(sun.azimuthDeg), 1))
        .arg(fixedNumber(double(sun.altitudeDeg), 1));
}

Caption captionOf(const DiagramMoment& moment) {
    return {dayText(moment.day) + QStringLiteral(", ") + moment.time, sunText(moment.sun)};
}

OutlineSettings outlineSettingsOf(const ReviewScene& scene, const Box2& ground) {
    return {ground, scene.source.study.settings.cellM, planeOf(scene.source.study.rule)};
}

/// "Shadows are on a plane 4 m above the mean ground. "; empty of rules about the ground.
QString planeText(const ReviewScene& scene) {
    const auto planeM = planeOf(scene.source.study.rule);
    if (!planeM) return {};
    return sheetText("Shadows are on a horizontal plane %1 m above the mean ground. ")
        .arg(describeAmount(*planeM, 2));
}

/// Of the verdicts whose colours are on the map, as tables name them.
std::vector<LegendPatch> verdictPatches(const ReviewScene& scene) {
    std::vector<LegendPatch> patches;
    for (const Verdict verdict :
         {Verdict::fail, Verdict::borderline, Verdict::pass, Verdict::notApplicable}) {
        if (std::ranges::find(scene.diagrams->placeColours, verdictMark(verdict)) ==
            scene.diagrams->placeColours.end())
            continue;
        QStringList names;
        for (const PlaceReview& place : scene.source.study.places)
            if (place.verdict == verdict) names << sheetText(nameVerdict(place));
        names.removeDuplicates();
        patches.push_back({verdictMark(verdict), sheetText("place: ") + names.join(sheetText(" or "))});
    }
    return patches;
}

PageItem footOf(const ReviewScene& scene, double scale, double cellM, DiagramFoot::Subject subject) {
    const PageSetup& setup = scene.settings.setup;
    const double height = diagramFootPt(textScale(setup));
    const QRectF all = contentArea(setup);
    QString note = sheetText("Times: %1.").arg(clockText(scene));
    if (cellM > 0)
        note += sheetText(" Edges of shadows follow cells of %1 m, because the ground is not level.")
                    .arg(describeAmount(cellM, 2));
    DiagramFoot foot = makeFoot(scene, scale, subject);
    foot.note = note;
    foot.hasNumbers = scene.keyPt > 0;
    return {{all.left(), all.bottom() - height, all.width(), height}, foot};
}

QString fromTo(const ReviewScene& scene) {
    return sheetText("%1 compared with %2. %3North is up.")
        .arg(scenarioText(scene.source.labels.to), scenarioText(scene.source.labels.from), planeText(scene));
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
    if (all.size() <= maxSunViewsADay) return all;
    const auto noon = std::ranges::min_element(
        all, {}, [](const DiagramMoment& moment) { return std::abs(moment.minute - 720); });
    std::vector<DiagramMoment> few;
    few.reserve(maxSunViewsADay);
    for (auto moment = all.begin(); moment != all.end(); ++moment)
        if (moment == all.begin() || moment == noon || moment == all.end() - 1) few.push_back(*moment);
    return few;
}

/// Columns and rows: pictures of the sun's view are small where they are many.
std::pair<int, int> sunViewGrid(const PageSetup& setup, std::size_t count) {
    if (count <= 3) return setup.landscape ? std::pair{2, 2} : std::pair{1, 3};
    return setup.landscape ? std::pair{3, 2} : std::pair{2, 3};
}

/// Puts items into the cells of pages, one after the other. A page is named by the days that begin on it.
class MomentPages {
public:
    MomentPages(QString title, QString subtitle, std::vector<QRectF> areas)
        : title_(std::move(title)), subtitle_(std::move(subtitle)), areas_(std::move(areas)) {}

    /// Of so many items as many pages as they need hold equally many, but for one: none is left alone.
    void spread(std::size_t count) { count_ = count; }

    /// The next cell; true where it is the first of its page.
    std::pair<QRectF, bool> next(CivilDate day) {
        const bool isFirst = pages_.empty() || used_ == sizeOf(pages_.size() - 1);
        if (isFirst) {
            pages_.push_back({title_, subtitle_, {}, 1, {}});
            used_ = 0;
        }
        if (!day_ || *day_ != day) {
            QString& bookmark = pages_.back().bookmark;
            bookmark += (bookmark.isEmpty() ? QString() : QStringLiteral("; ")) + dayText(day);
        }
        day_ = day;
        return {areas_[used_++], isFirst};
    }

    BookPage& page() { return pages_.back(); }

    /// The first page is the chapter's; the days on it come with its name.
    std::vector<BookPage> finish() {
        if (pages_.empty()) return {};
        pages_.front().level = 0;
        pages_.front().bookmark = title_ + QStringLiteral(": ") + pages_.front().bookmark;
        return std::move(pages_);
    }

private:
    [[nodiscard]] std::size_t sizeOf(std::size_t page) const {
        if (count_ == 0) return areas_.size();
        const std::size_t pages = (count_ + areas_.size() - 1) / areas_.size();
        return count_ / pages + (page < count_ % pages ? 1 : 0);
    }

    QString title_, subtitle_;
    std::vector<QRectF> areas_;
    std::vector<BookPage> pages_;
    std::size_t count_ = 0;  // of all items; 0: not known, and pages are filled
    std::size_t used_ = 0;   // of the last page
    std::optional<CivilDate> day_;
};

/// The scale at which an area holds the fan of each day: the foot of a page states one.
double fanScale(const ReviewScene& scene, const std::vector<DayMoments>& days, const QRectF& area) {
    double scale = 0;
    for (const DayMoments& day : days)
        scale = std::max(scale,
                         fitInto(area, textScale(scene.settings.setup), frameOf(scene, day.moments)).scale);
    return scale;
}

/// One fan alone has the page; four have one where they can be read.
std::vector<QRectF> fanAreas(const ReviewScene& scene, const std::vector<DayMoments>& days) {
    constexpr double maxScaleOfFour = 6000;
    if (days.size() > 2)
        if (auto four = diagramAreas(scene, 2, 2); fanScale(scene, days, four.front()) <= maxScaleOfFour)
            return four;
    const int beside = days.size() > 1 ? 2 : 1;
    return scene.settings.setup.landscape ? diagramAreas(scene, beside, 1) : diagramAreas(scene, 1, beside);
}

DiagramFoot::Subject subjectOf(const Diagram& diagram) {
    if (!diagram.fan.empty()) return DiagramFoot::Subject::fan;
    return diagram.valueLines.empty() ? DiagramFoot::Subject::shadows : DiagramFoot::Subject::valueLines;
}

struct DayDiagram {
    CivilDate day;
    Diagram diagram;
};

/// The key of the numbers that any of the diagrams shows, above the foot of a page.
PageItem keyOf(const ReviewScene& scene, const std::vector<DayDiagram>& diagrams, const QRectF& area) {
    const PageSetup& setup = scene.settings.setup;
    const double scale = textScale(setup);
    std::vector<Box2> seen;
    for (const auto& [day, diagram] : diagrams)
        seen.push_back(groundOf(diagram.centre, diagram.scale, mapAreaOf(area, scale)));
    const QRectF all = contentArea(setup);
    const double top = all.bottom() - diagramFootPt(scale) - scene.keyPt;
    return {{all.left(), top, all.width(), scene.keyPt},
            PageText{{body(describeKey(scene, seen))}, keyTextPt * scale}};
}

/// Puts diagrams on pages, each with foot and key.
std::vector<BookPage> placeDiagrams(const ReviewScene& scene, MomentPages pages, const QRectF& area,
                                    std::vector<DayDiagram> diagrams) {
    pages.spread(diagrams.size());
    const bool hasKey = scene.keyPt > 0 && !diagrams.empty();
    const std::optional<PageItem> key = hasKey ? std::optional(keyOf(scene, diagrams, area)) : std::nullopt;
    for (auto& [day, diagram] : diagrams) {
        const auto [where, isFirst] = pages.next(day);
        auto& items = pages.page().items;
        if (isFirst && key) items.push_back(*key);
        if (isFirst) items.push_back(footOf(scene, diagram.scale, diagram.shadows.cellM, subjectOf(diagram)));
        items.push_back({where, std::move(diagram)});
    }
    return pages.finish();
}

}  // namespace

DiagramFoot makeFoot(const ReviewScene& scene, double scale, DiagramFoot::Subject subject) {
    const PageSetup& setup = scene.settings.setup;
    return {.scale = scale,
            .paper = plainText(nameOf(setup.paper)),
            .note = {},
            .textScale = textScale(setup),
            .subject = subject,
            .units = scene.settings.units,
            .places = verdictPatches(scene),
            .hasRemoved = !scene.diagrams->removed.buildings.empty(),
            .hasOverhangs =
                showsOverhangs({reachOf(scene, scene.moments), contentArea(setup)}, scene.diagrams->city),
            .hasStreets = !scene.diagrams->streets.empty(),
            .hasContext = scene.diagrams->city.context != nullptr};
}

Result<Diagram> makeDiagram(const ReviewScene& scene, const DiagramMoment& moment,
                            const DiagramLayout& layout, const QRectF& area, Progress& progress,
                            const std::stop_token& stop) {
    const double scale = textScale(scene.settings.setup);
    const Box2 ground = groundOf(layout.centre, layout.scale, mapAreaOf(area, scale));
    auto shadows = outlineShadows(scene.before, &scene.after, moment.sun, outlineSettingsOf(scene, ground),
                                  progress, stop);
    if (!shadows) return tl::make_unexpected(shadows.error());
    return Diagram{scene.diagrams, *std::move(shadows), {},   {}, layout.centre,
                   layout.scale,   captionOf(moment),   scale};
}

Result<std::vector<BookPage>> makeDiagramPages(const ReviewScene& scene, Progress& progress,
                                               const std::stop_token& stop) {
    const DiagramLayout layout = layoutOf(scene);
    const auto areas = diagramAreas(scene, layout.columns, layout.rows);
    std::vector<DayDiagram> diagrams;
    for (const DiagramMoment& moment : scene.moments) {
        progress.report(double(&moment - scene.moments.data()) / double(scene.moments.size()),
                        NM_TEXT("drawing diagrams"));
        NoProgress quiet;
        auto diagram = makeDiagram(scene, moment, layout, areas.front(), quiet, stop);
        if (!diagram) return tl::make_unexpected(diagram.error());
        diagrams.push_back({moment.day, *std::move(diagram)});
    }
    return placeDiagrams(scene, {sheetText("Shadow diagrams"), fromTo(scene), areas}, areas.front(),
                         std::move(diagrams));
}

Result<std::vector<BookPage>> makeFanPages(const ReviewScene& scene, Progress& progress,
                                           const std::stop_token& stop) {
    if (scene.diagrams->proposal.buildings.empty()) return std::vector<BookPage>{};
    const PageSetup& setup = scene.settings.setup;
    const double scale = textScale(setup);
    const auto days = byDay(scene.moments);
    const auto areas = fanAreas(scene, days);
    std::vector<DayDiagram> diagrams;
    const MomentPages pages(
        sheetText("Shadow fans"),
        sheetText("All shadows of a day that the proposal would cast if it stood alone, %1. "
                  "%2North is up.")
            .arg(scenarioText(scene.source.labels.to), planeText(scene)),
        areas);
    const City proposal = keepOwnBuildings(scene.after, scene.before);
    const double commonScale = fanScale(scene, days, areas.front());
    for (const auto& [day, moments] : days) {
        progress.report(0, NM_TEXT("drawing shadow fans"));
        DiagramLayout layout = fitInto(areas.front(), scale, frameOf(scene, moments));
        layout.scale = commonScale;
        const Box2 ground = groundOf(layout.centre, layout.scale, mapAreaOf(areas.front(), scale));
        std::vector<SunStep> steps;
        for (const DiagramMoment& moment : moments) steps.push_back(moment.sun);
        NoProgress quiet;
        auto fan = outlineShadowFan(proposal, steps, outlineSettingsOf(scene, ground), quiet, stop);
        if (!fan) return tl::make_unexpected(fan.error());
        Diagram diagram{scene.diagrams, {}, {}, {}, layout.centre, layout.scale, {}, scale};
        diagram.shadows.cellM = fan->cellM;
        for (std::size_t i = 0; i < moments.size(); ++i)
            diagram.fan.push_back({moments[i].time, std::move(fan->ofStep[i])});
        diagram.caption = {
            dayText(day) + sheetText(", %1 to %2").arg(moments.front().time, moments.back().time),
            sheetText("1:%1. Existing buildings do not hide these shadows").arg(std::llround(layout.scale))};
        diagrams.push_back({day, std::move(diagram)});
    }
    return placeDiagrams(scene, pages, areas.front(), std::move(diagrams));
}

Result<std::vector<BookPage>> makeIsochronePages(const ReviewScene& scene, Progress& progress,
                                                 const std::stop_token& stop) {
    if (!hasIsochrones(scene.source.study.rule)) return std::vector<BookPage>{};
    const auto areas = diagramAreas(scene, 1, 1);
    std::vector<DayDiagram> diagrams;
    const QString title = sheetText("Lines of equal hours of shadow");
    const MomentPages pages(title,
                            sheetText("%1. Thick: limits of the rule. Dashed: distances from the parcel. "
                                      "North is up.")
                                .arg(scenarioText(scene.source.labels.to)),
                            areas);
    for (std::size_t i = 0; i < std::min(maxIsochroneDays, scene.sun.sun.days.size()); ++i) {
        progress.report(0, NM_TEXT("drawing lines of equal hours"));
        auto diagram = makeIsochrones(scene, i, areas.front(), stop);
        if (!diagram) return tl::make_unexpected(diagram.error());
        diagrams.push_back({scene.sun.sun.days[i].date, *std::move(diagram)});
    }
    return placeDiagrams(scene, pages, areas.front(), std::move(diagrams));
}

Result<std::vector<BookPage>> makeSunViewPages(const ReviewScene& scene, Progress& progress,
                                               const std::stop_token& stop) {
    const PageSetup& setup = scene.settings.setup;
    std::vector<DayMoments> days = byDay(scene.moments);
    std::size_t count = 0;
    for (DayMoments& day : days) count += (day.moments = fewOf(day.moments)).size();
    const auto [columns, rows] = sunViewGrid(setup, count);
    const auto areas = gridAreas(setup, columns, rows);
    const double scale = textScale(setup);
    const QSizeF picture = mapAreaOf(areas.front(), scale).size() * pictureDpi / 72;
    const QSize size = (picture * std::min(1.0, maxPicturePixels / picture.width())).toSize();
    const DiagramLayout layout = layoutOf(scene);
    const QRectF shown = mapAreaOf(diagramAreas(scene, layout.columns, layout.rows).front(), scale);
    const auto views =
        SunViewScene::make(*scene.diagrams, groundOf(layout.centre, layout.scale, shown), stop);
    if (!views) return tl::make_unexpected(views.error());
    MomentPages pages(sheetText("Views from the sun"),
                      sheetText("%1, without perspective, as the sun sees it: what is visible is sunlit, "
                                "what is hidden is in shadow. The proposal is violet, places are green.")
                          .arg(scenarioText(scene.source.labels.to)),
                      areas);
    pages.spread(count);
    for (const auto& [day, moments] : days)
        for (const DiagramMoment& moment : moments) {
            if (stop.stop_requested()) return cancelled();
            progress.report(0, NM_TEXT("drawing views from the sun"));
            const QRectF area = pages.next(day).first;
            pages.page().items.push_back(
                {area, PagePicture{views->paint(moment.sun, size), captionOf(moment)}});
        }
    return pages.finish();
}

}  // namespace noonmark
