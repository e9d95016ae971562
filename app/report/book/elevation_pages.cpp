#include "app/report/book/elevation_pages.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/report/book/elevation.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/study_text.h"
#include "core/study/elements/element_map.h"

namespace noonmark {

namespace {

constexpr double minPointsPerM = 4;  // of a comfortable scale, 1:700
constexpr std::array stripParts{3, 2, 1};

/// "south-east"
QString windName(double azimuthDeg) {
    static constexpr std::array<std::string_view, 8> names{
        NM_TEXT("north"), NM_TEXT("north-east"), NM_TEXT("east"), NM_TEXT("south-east"),
        NM_TEXT("south"), NM_TEXT("south-west"), NM_TEXT("west"), NM_TEXT("north-west")};
    return sheetText(names[std::size_t(std::lround(azimuthDeg / 45)) % names.size()]);
}

/// The layout of the smallest strip with a comfortable scale, else of the whole page.
std::pair<double, ElevationLayout> chooseStrip(const QSizeF& page, const FacadeElevation& elevation,
                                               std::size_t panels, double textScale) {
    const glm::dvec2 size = elevation.high - elevation.low;
    const double gap = 8 * textScale;
    for (const int parts : stripParts) {
        const double height = (page.height() - (parts - 1) * gap) / parts;
        const auto layout = fitElevation(size, panels, {page.width(), height}, textScale);
        if (!layout) continue;
        if (parts == 1 || pointsPerMetre(layout->scale) >= minPointsPerM)
            return {elevationHeightPt(size, panels, *layout, textScale), *layout};
    }
    return {page.height(), {false, 50000}};
}

/// At that scale, if it fits on the page.
std::optional<std::pair<double, ElevationLayout>> chooseAtScale(const QSizeF& page,
                                                                const FacadeElevation& elevation,
                                                                std::size_t panels, double textScale,
                                                                double scale) {
    const glm::dvec2 size = elevation.high - elevation.low;
    const auto layout = fitElevationAt(size, panels, page, textScale, scale);
    if (!layout) return std::nullopt;
    return std::pair{elevationHeightPt(size, panels, *layout, textScale), *layout};
}

/// Fills pages with strips from top to bottom.
class ElevationFlow {
public:
    ElevationFlow(const PageSetup& setup, const ElevationSheets& sheets)
        : setup_(setup), sheets_(sheets), scale_(textScale(setup)) {
        const QRectF all = contentArea(setup);
        foot_ =
            QRectF(all.left(), all.bottom() - elevationFootPt(scale_), all.width(), elevationFootPt(scale_));
        room_ = all.adjusted(0, 0, 0, -foot_.height() - 4 * scale_);
    }

    /// False if it would exceed the pages.
    bool add(const ElevationBuilding& building) {
        for (FacadeElevation& elevation : drawElevations(building.building, building.panes)) {
            const auto [height, layout] = chooseLayout(elevation);
            if (pages_.empty() || top_ + height > room_.bottom() + 0.5) {
                if (pages_.size() == sheets_.maxPages) return false;
                beginPage();
            }
            nameBuilding(building);
            const QRectF area(room_.left(), top_, room_.width(), height);
            top_ += height + 8 * scale_;
            pages_.back().items.push_back({area, makeDrawing(building, std::move(elevation), layout)});
        }
        return true;
    }

    std::pair<double, ElevationLayout> chooseLayout(const FacadeElevation& elevation) {
        const std::size_t panels = sheets_.panels.size();
        if (sheets_.scale)
            if (const auto asked = chooseAtScale(room_.size(), elevation, panels, scale_, *sheets_.scale))
                return *asked;
        smaller_ += sheets_.scale ? 1 : 0;
        return chooseStrip(room_.size(), elevation, panels, scale_);
    }

    std::vector<BookPage> finish(std::size_t leftOut) {
        if (pages_.empty()) return {};
        BookPage& first = pages_.front();
        first.level = 0;
        first.bookmark = sheets_.bookmark + QStringLiteral(": ") + first.bookmark;
        if (leftOut > 0)
            first.subtitle += sheetText(" %1 more buildings are not drawn.").arg(describeCount(leftOut));
        if (smaller_ > 0)
            first.subtitle += sheetText(" %1 sides do not fit on %2 at 1:%3 and are smaller.")
                                  .arg(describeCount(smaller_), plainText(nameOf(setup_.paper)),
                                       describeAmount(*sheets_.scale));
        return std::move(pages_);
    }

private:
    void beginPage() {
        pages_.push_back({sheets_.title, sheets_.subtitle, {}, 1, {}});
        ElevationFoot foot = sheets_.foot;
        foot.textScale = scale_;
        pages_.back().items.push_back({foot_, std::move(foot)});
        top_ = room_.top();
        named_.clear();
    }

    void nameBuilding(const ElevationBuilding& building) {
        if (named_ == building.name) return;
        named_ = building.name;
        QString& bookmark = pages_.back().bookmark;
        bookmark += (bookmark.isEmpty() ? QString() : QStringLiteral("; ")) + named_;
    }

    [[nodiscard]] Caption captionOf(const ElevationBuilding& building, const FacadeElevation& elevation,
                                    const ElevationLayout& layout) const {
        const std::size_t any = elevation.windows.front().pane;
        const LonLat place = sheets_.frame.lonLatFromLocal(glm::dvec2(building.panes[any].middle));
        const double azimuth =
            facingAzimuthDeg(sheets_.frame, place, glm::vec3(glm::vec2(elevation.normal), 0));
        QString first = sheetText("%1, facing %2 (%3°)")
                            .arg(building.name, windName(azimuth), describeAmount(azimuth, 0));
        if (elevation.layers > 1)
            first += sheetText(", layer %1 of %2").arg(elevation.layer).arg(elevation.layers);
        return {first, sheetText("1:%1 on %2. %3 windows")
                           .arg(describeCount(std::size_t(std::llround(layout.scale))),
                                plainText(nameOf(setup_.paper)), describeCount(elevation.windows.size()))};
    }

    [[nodiscard]] ElevationDrawing makeDrawing(const ElevationBuilding& building, FacadeElevation elevation,
                                               const ElevationLayout& layout) const {
        ElevationDrawing drawing{
            nullptr, {}, layout, building.storeyM, captionOf(building, elevation, layout), scale_};
        for (std::size_t i = 0; i < sheets_.panels.size(); ++i) {
            ElevationPanel& panel = drawing.panels.emplace_back();
            panel.title = sheets_.panels[i];
            if (i < building.notes.size()) panel.note = building.notes[i];
            if (i >= building.cells.size() || building.cells[i].empty()) continue;
            for (const ElevationGlazing& window : elevation.windows)
                panel.cells.push_back(building.cells[i][window.pane]);
        }
        drawing.elevation = std::make_shared<const FacadeElevation>(std::move(elevation));
        return drawing;
    }

    const PageSetup& setup_;
    const ElevationSheets& sheets_;
    double scale_, top_ = 0;
    std::size_t smaller_ = 0;  // sides that do not fit at sheets_.scale
    QRectF foot_, room_;
    QString named_;
    std::vector<BookPage> pages_;
};

}  // namespace

QString describeFloors(const ElementSettings& elements) {
    const QString floors = sheetText("Floors of %1 m").arg(shortNumber(elements.facades.storeyM, 4));
    return elements.parts.storeys.empty() ? floors : floors + sheetText(", of designed towers as designed");
}

std::vector<BookPage> makeElevationPages(const PageSetup& setup, ElevationSheets sheets,
                                         const std::vector<ElevationBuilding>& buildings) {
    ElevationFlow flow(setup, sheets);
    std::size_t drawn = 0;
    while (drawn < buildings.size() && flow.add(buildings[drawn])) ++drawn;
    return flow.finish(buildings.size() - drawn);
}

}  // namespace noonmark
