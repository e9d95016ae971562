#include <QComboBox>
#include <cmath>

#include "app/gui/docks/review/glazing/glazing_panel.h"
#include "app/gui/docks/review/glazing/verdict_links.h"
#include "app/gui/view/panel/view_panel.h"
#include "tests/gui/glazing_review_window.h"

namespace noonmark {
namespace {

using test::waitFor;

/// Verdicts on windows in the view.
struct VerdictView : test::GlazingReviewWindow {
    void review() {
        build();
        run();
        ASSERT_TRUE(windows().answer()) << message().toStdString();
    }
    const GlazingStudy& study() { return windows().answer()->study; }
    ElementTiles& tiles() { return window->panel().view().tiles(); }
    void show(ShownVerdicts shown) {
        auto* choice = dock().findChild<QComboBox*>(QStringLiteral("verdictsInView"));
        choice->setCurrentIndex(choice->findData(int(shown)));
        Q_EMIT choice->activated(choice->currentIndex());
    }
    void expectColours(const std::function<QColor(const GlazingReview&)>& colourOf) {
        ASSERT_EQ(tiles().tiles().size(), study().panes.size());
        for (std::size_t i = 0; i < study().panes.size(); ++i) {
            const QColor colour = colourOf(study().windows[study().panes[i].window]);
            EXPECT_NEAR(tiles().tiles()[i].colour.r, colour.redF(), 1e-3);
            EXPECT_NEAR(tiles().tiles()[i].colour.b, colour.blueF(), 1e-3);
        }
    }
    QStringList classes() {
        QStringList labels;
        if (const auto& legend = window->panel().legend().legend())
            for (const LegendPatch& patch : legend->classes) labels << patch.label;
        return labels;
    }
};

TEST_F(VerdictView, TilesHaveTheColoursOfTheVerdictsThatAreChosen) {
    review();
    ASSERT_GT(study().panes.size(), 20U);
    expectColours([](const GlazingReview& one) { return tileColour(one.verdict); });
    EXPECT_EQ(classes(), (QStringList{"pass", "borderline", "fail", "not applicable"}));
    show(ShownVerdicts::before);
    expectColours([](const GlazingReview& one) { return tileColour(one.formerVerdict); });
    show(ShownVerdicts::change);
    expectColours([](const GlazingReview& one) { return tileColour(findChange(one)); });
    EXPECT_EQ(classes().size(), 4);
    EXPECT_TRUE(classes().contains(QStringLiteral("worse")));
    show(ShownVerdicts::none);
    EXPECT_TRUE(tiles().tiles().empty());
    EXPECT_TRUE(classes().isEmpty());
}

TEST_F(VerdictView, TilesLieOnTheWallsWithTheSizeOfTheWindow) {
    review();
    const ReviewedPane& pane = study().panes.front();
    const auto& corners = tiles().tiles().front().corners;
    EXPECT_NEAR(glm::distance(corners[0], corners[1]), pane.pane.size.widthM(), 1e-3);
    const glm::dvec3 middle = (glm::dvec3(corners[0]) + glm::dvec3(corners[2])) / 2.0;
    EXPECT_LT(glm::distance(middle, pane.pane.middle), 2.0);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(corners[1] - corners[0]), glm::dvec3(corners[3] - corners[0]));
    EXPECT_GT(glm::dot(normal, pane.pane.normal), 0) << "seen from outside";
}

TEST_F(VerdictView, ARowFramesItsWindowAndATileFindsItsRow) {
    review();
    GlazingTable& table = dock().glazingTable();
    ASSERT_EQ(tiles().highlighted().size(), 1U) << "the first row is chosen";
    QTreeWidgetItem* last = table.topLevelItem(table.topLevelItemCount() - 1);
    table.setCurrentItem(last);
    Q_EMIT table.itemClicked(last, 0);
    const auto chosen = table.chosen();
    ASSERT_TRUE(chosen);
    ASSERT_EQ(tiles().highlighted().size(), 1U);
    EXPECT_EQ(study().panes[tiles().highlighted()[0]].window, *chosen);
    const CityView& view = window->panel().view();
    const glm::dvec3 place = study().panes[tiles().highlighted()[0]].pane.middle;
    EXPECT_LT(glm::distance(view.pose().target, place), 0.01);
    EXPECT_LE(view.pose().distanceM, 80);
    const double facing = *study().windows[*chosen].window.azimuthDeg;
    EXPECT_NEAR(std::remainder(view.pose().headingDeg - facing - 180, 360), 0, 1e-6) << "from in front";
    table.setCurrentItem(table.topLevelItem(0));
    const auto pixel = pixelOf(view.pose(), view.lens(), place);
    ASSERT_TRUE(pixel);
    const QPointF at(pixel->x, pixel->y);
    Q_EMIT window->panel().navigator().clicked(at);
    EXPECT_EQ(table.chosen(), chosen);
    const auto pick = window->panel().navigator().pickAt(at);
    ASSERT_TRUE(pick);
    const QString hover = window->panel().results().minutesAt(*pick);
    EXPECT_TRUE(hover.contains(QString::fromStdString(study().windows[*chosen].window.id)))
        << hover.toStdString();
    EXPECT_TRUE(hover.contains(QStringLiteral("before"))) << hover.toStdString();
}

TEST_F(VerdictView, AnotherResultOrAnotherRuleTakesThePlaceOfTheVerdicts) {
    review();
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return workbench().study() || workbench().answerAs<ImpactAnswer>(); }));
    EXPECT_TRUE(tiles().tiles().empty());
    EXPECT_EQ(dock().glazingPanel().shown(), ShownVerdicts::none);
    run();
    EXPECT_EQ(dock().glazingPanel().shown(), ShownVerdicts::after) << "the newest result is in front";
    EXPECT_EQ(tiles().tiles().size(), study().panes.size());
    choose("four-days");
    EXPECT_TRUE(tiles().tiles().empty());
    choose("en-17037");
    EXPECT_FALSE(tiles().tiles().empty());
    show(ShownVerdicts::none);
    run();
    EXPECT_EQ(dock().glazingPanel().shown(), ShownVerdicts::none) << "as the user wants";
}

TEST_F(VerdictView, TheNoteTellsWhatIsComparedAndWhetherItIsUpToDate) {
    review();
    EXPECT_TRUE(window->panel().legend().note().contains(QString::fromLatin1(existingCity)));
    choose("tno-light");
    EXPECT_TRUE(window->panel().legend().note().contains(QStringLiteral("Not up to date")))
        << window->panel().legend().note().toStdString();
}

/// What an eye without one kind of cones sees: Vienot, Brettel and Mollon 1999, for linear RGB.
std::array<double, 3> seenWithout(char cones, const QColor& colour) {
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const double r = linear(colour.redF()), g = linear(colour.greenF()), b = linear(colour.blueF());
    if (cones == 'L')
        return {0.11238 * r + 0.88762 * g, 0.11238 * r + 0.88762 * g, 0.00401 * r - 0.00401 * g + b};
    if (cones == 'M')
        return {0.29275 * r + 0.70725 * g, 0.29275 * r + 0.70725 * g, -0.02234 * r + 0.02234 * g + b};
    return {r, g, b};
}

/// CIE 1976 L*, a*, b* of linear sRGB.
std::array<double, 3> labOf(const std::array<double, 3>& rgb) {
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = f((0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.9505);
    const double y = f(0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]);
    const double z = f((0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double differenceOf(const QColor& a, const QColor& b, char cones) {
    const auto one = labOf(seenWithout(cones, a)), two = labOf(seenWithout(cones, b));
    return std::hypot(one[0] - two[0], one[1] - two[1], one[2] - two[2]);
}

void expectApart(const std::vector<QColor>& colours) {
    constexpr double plainDifference = 30;  // of CIE 1976; 2.3 is just noticeable
    for (std::size_t i = 0; i < colours.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            for (const char cones : {' ', 'L', 'M'})
                EXPECT_GT(differenceOf(colours[i], colours[j], cones), plainDifference)
                    << colours[i].name().toStdString() << ' ' << colours[j].name().toStdString() << cones;
}

TEST(VerdictColours, AreToldApartByColourBlindEyes) {
    EXPECT_LT(differenceOf(QColor(0, 150, 80), QColor(190, 105, 60), 'M'), 25) << "the test sees as they do";
    expectApart({tileColour(Verdict::pass), tileColour(Verdict::borderline), tileColour(Verdict::fail),
                 tileColour(Verdict::notApplicable)});
    expectApart({tileColour(VerdictChange::same), tileColour(VerdictChange::worse),
                 tileColour(VerdictChange::better), tileColour(VerdictChange::notCompared)});
}

TEST(VerdictChanges, KnowWorseBetterAndWhatCannotBeCompared) {
    const auto of = [](Verdict former, Verdict verdict) {
        GlazingReview review;
        review.formerVerdict = former;
        review.verdict = verdict;
        return findChange(review);
    };
    EXPECT_EQ(of(Verdict::pass, Verdict::borderline), VerdictChange::worse);
    EXPECT_EQ(of(Verdict::fail, Verdict::pass), VerdictChange::better);
    EXPECT_EQ(of(Verdict::fail, Verdict::fail), VerdictChange::same);
    EXPECT_EQ(of(Verdict::notApplicable, Verdict::fail), VerdictChange::notCompared);
    EXPECT_EQ(of(Verdict::pass, Verdict::notApplicable), VerdictChange::notCompared);
}

}  // namespace
}  // namespace noonmark
