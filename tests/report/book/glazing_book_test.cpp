#include "app/report/book/review/glazing_book.h"

#include <gmock/gmock.h>

#include "app/report/book/flow.h"
#include "app/report/book/print_book.h"
#include "app/report/maps/style.h"
#include "core/review/library/rule_library.h"
#include "core/study/glazing/glazing_text.h"
#include "tests/report/book/book_texts.h"
#include "tests/report/book/recorded_page.h"
#include "tests/report/book/review_scene.h"

namespace noonmark {
namespace {

using namespace tests;

/// The western house of ReviewedPark, 20 m high, with a tower to its south in the scenario.
class GlazingBook : public testing::Test {
protected:
    GlazingStudy review(const std::string& key, const std::string& building) {
        park_.after.buildings.push_back(tower_);
        GlazingReviewSettings settings;
        settings.elements.buildings = {building};
        settings.region = makeRegionFromLocalBox({{-200, -200}, {200, 200}});
        settings.zone = "America/New_York";
        NoProgress quiet;
        return runGlazingReview(RuleLibrary::load({}).value().find(key, {}).value(), park_.before,
                                park_.after, settings, quiet, {})
            .value();
    }
    Book book(const GlazingStudy& study, const BookSettings& settings = {}) {
        labels_.from = "Existing", labels_.to = "Tower";
        NoProgress quiet;
        return makeGlazingBook({study, labels_, park_.before, park_.after}, settings, quiet, {}).value();
    }
    static std::vector<const ElevationDrawing*> drawingsOf(const Book& book) {
        std::vector<const ElevationDrawing*> drawings;
        for (const BookPage& page : book.pages)
            for (const PageItem& item : page.items)
                if (const auto* drawing = std::get_if<ElevationDrawing>(&item.content))
                    drawings.push_back(drawing);
        return drawings;
    }

    ReviewedPark park_;
    ReviewLabels labels_;
    std::shared_ptr<const Building> tower_ = [] {
        Part part;
        part.footprint = boxFootprint(-90, -40, -50, -10);
        part.topM = 80;
        return std::make_shared<const Building>(Building{"slab", "Slab", {}, {part}});
    }();
};

TEST_F(GlazingBook, HasTheColoursThatWereChosen) {
    const GlazingStudy study = review("korea", "west house");
    const Book made = book(study, {.legend = {.ramp = Ramp::viridis, .changeRamp = Ramp::orangePurple}});
    const ElevationDrawing& north = *drawingsOf(made).at(0);
    EXPECT_EQ(north.panels[1].cells.at(0).colour, toColour(rampRgb(Ramp::viridis, 1))) << "no sun";
    EXPECT_EQ(north.panels[2].cells.at(0).colour, toColour(rampRgb(Ramp::orangePurple, 0.5))) << "no change";
}

TEST_F(GlazingBook, IsInTheLanguageOfItsReaders) {
    const GlazingStudy study = review("korea", "west house");
    BookSettings settings;
    settings.language = Language::german;
    const Book made = book(study, settings);
    QStringList texts;
    for (const std::size_t page : {0U, 1U})  // summary and elevations; the method has commands
        for (const PaintedText& text : textsOfPage(made, page)) texts << text.text;
    const QString all = texts.join(u'\n');
    for (const char* english : {"3.5", "Existing", "trees", "terrain", "was assumed"})
        EXPECT_FALSE(all.contains(QLatin1String(english))) << english;
    for (const char* german : {"3,5", "Bestand", "Hänge"})
        EXPECT_TRUE(all.contains(QString::fromUtf8(german))) << german;
}

TEST_F(GlazingBook, DrawsEachSideOfAHouseBeforeAndAfterAtAScale) {
    const GlazingStudy study = review("korea", "west house");
    const Book made = book(study);
    const auto drawings = drawingsOf(made);
    ASSERT_EQ(drawings.size(), 4U);
    for (const ElevationDrawing* drawing : drawings) {
        ASSERT_EQ(drawing->panels.size(), 3U);
        // 20 m wide: 7 bays of some 3 m.
        EXPECT_EQ(drawing->elevation->windows.size() % 7, 0U);
        for (const ElevationPanel& panel : drawing->panels)
            EXPECT_EQ(panel.cells.size(), drawing->elevation->windows.size());
    }
    // The south facade loses its sun; that towards the north has none, and loses none.
    const ElevationDrawing &north = *drawings[0], &south = *drawings[2];
    EXPECT_TRUE(south.caption.first.startsWith(QStringLiteral("west house, facing south (180")));
    EXPECT_TRUE(std::ranges::any_of(south.panels[2].cells, [](const ElevationCell& cell) {
        return cell.mark == ElevationMark::worse && cell.colour == impactColour(1);
    }));
    for (const ElevationCell& cell : north.panels[2].cells) {
        EXPECT_EQ(cell.colour, impactColour(0));
        EXPECT_EQ(cell.mark, ElevationMark::none);
    }
    for (const ElevationCell& cell : north.panels[1].cells) {
        EXPECT_EQ(cell.colour, shadowColour(1));
        EXPECT_EQ(cell.mark, ElevationMark::fail);
    }
}

TEST_F(GlazingBook, ABuildingWithoutFormerValuesHasTheScenarioOnly) {
    const GlazingStudy study = review("korea", "Slab");
    const Book made = book(study);
    const auto drawings = drawingsOf(made);
    ASSERT_EQ(drawings.size(), 4U);
    EXPECT_TRUE(drawings[0]->panels[0].cells.empty());
    EXPECT_FALSE(drawings[0]->panels[0].note.isEmpty());
    EXPECT_FALSE(drawings[0]->panels[1].cells.empty());
}

TEST_F(GlazingBook, NothingIsCutOffOnAnyPaper) {
    const GlazingStudy study = review("korea", "west house");
    constexpr double unit = MeasuringCanvas::unitsPerPoint;
    for (const Paper paper : papers)
        for (const bool landscape : {false, true}) {
            const Book made = book(study, {{paper, landscape}, {}, {}});
            const QRectF frame(frameArea(made.setup).topLeft() * unit, frameArea(made.setup).size() * unit);
            for (std::size_t i = 0; i < made.pages.size(); ++i) {
                RecordedPage page((sizePt(made.setup) * unit).toSize());
                {
                    QPainter painter(&page);
                    paintPage(made, i, {painter, unit});
                }
                for (const PaintedText& text : page.texts()) {
                    if (text.box.width() <= 0) continue;
                    EXPECT_TRUE(frame.adjusted(-1, -1, 1, 1).contains(text.box)) << text.text.toStdString();
                }
            }
        }
}

TEST(GlazingValues, ScalesFollowFromTheRuleAlone) {
    const RuleLibrary library = RuleLibrary::load({}).value();
    const auto measuresOf = [&](const char* key) {
        return listGlazingMeasures(library.find(key, {}).value());
    };
    const auto bre = measuresOf("bre-209-windows");
    ASSERT_EQ(bre.size(), 2U);
    EXPECT_EQ(bre[0].scale.top, 40) << "percent of the sky";
    EXPECT_EQ(bre[1].scale.top, 50) << "twice 25 %";
    EXPECT_EQ(bre[1].changeScale.top, 25);
    const auto english = measuresOf("en-17037");
    ASSERT_EQ(english.size(), 1U);
    EXPECT_EQ(english[0].scale.top, 3) << "hours: twice 1.5";
    EXPECT_EQ(english[0].changeScale.top, 1.5);
    EXPECT_EQ(measuresOf("estonia")[0].scale.top, 6) << "twice 3 h";
}

TEST(FitElevation, TakesTheLargestRoundScale) {
    // 20 m at 1:200 are 283 points; three beside each other need about 900, stacked 283 wide and 850 high.
    EXPECT_EQ(fitElevation({20, 20}, 3, {1000, 400}, 1)->scale, 200);
    EXPECT_FALSE(fitElevation({20, 20}, 3, {1000, 400}, 1)->stacked);
    EXPECT_TRUE(fitElevation({100, 10}, 3, {500, 400}, 1)->stacked);
    EXPECT_FALSE(fitElevation({1e6, 10}, 3, {500, 400}, 1));
}

}  // namespace
}  // namespace noonmark
