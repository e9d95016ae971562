#include "app/report/book/height_map.h"

#include "app/report/maps/answer_legends.h"
#include "app/report/maps/map_painter.h"
#include "app/report/sheets/study_text.h"

namespace noonmark {

namespace {

/// What the map refers to, for as long as the page is there.
struct MapOfHeights {
    City city;
    Region region;
    std::optional<SheetMap> map{};
};

/// "assumed: 12"
std::vector<LegendPatch> countedPatches(const SourceCounts& counts) {
    std::vector<LegendPatch> patches;
    for (const HeightSourceColour& one : heightSourceColours())
        if (const std::size_t count = counts[std::size_t(one.source)]; count > 0)
            patches.push_back({one.colour, plainText(std::string(one.label)) + QStringLiteral(": ") +
                                               describeCount(count)});
    return patches;
}

}  // namespace

BookPage makeHeightMapPage(const City& city, const Box2& shown, const PageSetup& setup) {
    auto owned = std::make_shared<MapOfHeights>(MapOfHeights{city, {}});
    Legend legend{QStringLiteral("Source of height"),
                  QStringLiteral("of the highest part of each building; counts are of the whole city")};
    legend.classes = countedPatches(countSources(owned->city));
    MapScene scene{owned->city, owned->region, {}, {}};
    scene.shown = shown.empty() ? bounds(city) : shown;
    scene.fillOf = [](const Building& building) { return colourOf(sourceOfHeight(building)).colour; };
    owned->map.emplace(SheetMap{std::move(scene), std::move(legend)});
    const QString title = QStringLiteral("Where the heights come from");
    BookPage page{title, {}, title, 0, {}};
    page.items.push_back({contentArea(setup), PageMap{{owned, &*owned->map}}});
    return page;
}

}  // namespace noonmark
