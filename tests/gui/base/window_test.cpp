#include <gtest/gtest.h>

#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <random>

#include "app/gui/base/layers/hover_text.h"
#include "app/gui/docks/results/results_dock.h"
#include "app/gui/frame/main_window.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/report/maps/style.h"
#include "core/samples/sample_city.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

/// The whole window with the sample, as a user starts it.
struct WindowTest : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    MainWindow window{settings};

    void SetUp() override {
        window.resize(1000, 760);  // the legend has its own row at this width
        window.show();
        window.open({QStringLiteral("sample:central-park-south")});
        ASSERT_TRUE(waitFor([this] { return window.workbench().city() != nullptr; }));
    }

    // Wide lawns in the sun, and streets in deep shadow.
    [[nodiscard]] Region parkAndStreets() {
        const Region park = centralParkRegion(window.workbench().city()->city());
        const auto south = std::ranges::min(park.polygons.front().outer, {}, [](glm::vec2 p) { return p.y; });
        return makeRegionFromLocalBox({south - glm::vec2(250), south + glm::vec2(250)});
    }

    void runStudy() {
        StudySettings question = window.workbench().document().settings();
        question.region = parkAndStreets();
        question.receivers.cellM = 2;
        question.period.stepMinutes = 10;
        question.period.zone = "America/New_York";
        window.workbench().document().change(question, QStringLiteral("test"));
        window.workbench().run();
        ASSERT_TRUE(waitFor([this] { return window.workbench().study() != nullptr; }));
    }

    QImage captured() {
        QImage image;
        window.panel().view().capture([&image](const QImage& made) { image = made; });
        EXPECT_TRUE(waitFor([&image] { return !image.isNull(); }));
        return image;
    }

    QPointF pixelAt(glm::dvec3 point) {
        CityView& view = window.panel().view();
        const auto pixel = pixelOf(view.pose(), view.lens(), point);
        return pixel ? QPointF(pixel->x, pixel->y) : QPointF(-1, -1);
    }

    QColor colourAt(const QImage& image, QPointF pixel) {
        const double ratio = window.panel().view().devicePixelRatio();
        const QPoint at = (pixel * ratio).toPoint();
        return image.rect().contains(at) ? image.pixelColor(at) : QColor();
    }
};

int difference(const QColor& a, const QColor& b) {
    return std::max(
        {std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
}

// Cells whose neighbours have nearly the same value, so that an adjacent pixel is as good as the exact one.
std::vector<std::size_t> calmCells(const Grid& grid, const std::vector<float>& values, float tolerance) {
    std::vector<std::size_t> calm;
    for (int row = 1; row + 1 < grid.rows; ++row)
        for (int column = 1; column + 1 < grid.columns; ++column) {
            const float value = values[grid.index(column, row)];
            bool same = !std::isnan(value);
            for (int y = row - 1; y <= row + 1; ++y)
                for (int x = column - 1; x <= column + 1; ++x)
                    same = same && std::abs(values[grid.index(x, y)] - value) <= tolerance;
            if (same) calm.push_back(grid.index(column, row));
        }
    return calm;
}

glm::dvec3 centreOf(const Grid& grid, std::size_t cell) {
    return {grid.centre(int(cell % std::size_t(grid.columns)), int(cell / std::size_t(grid.columns))), 0};
}

// The number of visible cells, and of those whose pixel has the palette colour of their value.
struct Agreement {
    int seen = 0;
    int right = 0;
    float lowest = 1e9F;
    float highest = -1;
};

Agreement agreementOf(WindowTest& test, const QImage& image, ShadowMeasure measure) {
    const auto study = test.window.workbench().study();
    const std::vector<float>& values = getValues(study->field, measure);
    const double top = makeLegend(study->field, measure).scale.top;
    std::vector<std::size_t> cells = calmCells(study->field.grid, values, float(top * 0.02));
    std::mt19937 random(7);
    std::ranges::shuffle(cells, random);
    cells.resize(std::min<std::size_t>(cells.size(), 400));
    Agreement agreement;
    for (const std::size_t cell : cells) {
        if (values[cell] == 0) continue;  // the ground keeps its own colour
        const QPointF pixel = test.pixelAt(centreOf(study->field.grid, cell));
        const auto pick = test.window.panel().navigator().pickAt(pixel);
        const QColor colour = test.colourAt(image, pixel);
        if (!pick || pick->building || !colour.isValid()) continue;
        ++agreement.seen;
        agreement.lowest = std::min(agreement.lowest, values[cell]);
        agreement.highest = std::max(agreement.highest, values[cell]);
        if (difference(colour, shadowColour(double(values[cell]) / top)) <= 12) ++agreement.right;
    }
    return agreement;
}

// The texture arrives a frame or two after the study, so this waits for the colours.
void expectGroundShows(WindowTest& test, ShadowMeasure measure, double share, float spreadMin) {
    Agreement agreement;
    const bool shown = waitFor([&] {
        agreement = agreementOf(test, test.captured(), measure);
        return agreement.seen > 50 && agreement.right >= share * agreement.seen;
    });
    EXPECT_TRUE(shown) << agreement.right << " of " << agreement.seen << " cells have their colour";
    EXPECT_GT(agreement.highest - agreement.lowest, spreadMin) << "both sunlit and shaded cells were checked";
}

TEST_F(WindowTest, GroundHasThePalettesColoursOfTheField) {
    window.resize(1240, 900);  // so that cells have pixels of their own
    runStudy();
    const Box2 region = bounds(window.workbench().study()->settings.region);
    window.panel().navigator().show(region);
    expectGroundShows(*this, ShadowMeasure::gross, 0.97, 100);
    window.panel().legend().setMeasure(ShadowMeasure::continuous);
    expectGroundShows(*this, ShadowMeasure::continuous, 0.97, 100);
}

TEST_F(WindowTest, SlantingViewShowsTheSameColours) {
    window.resize(1240, 900);  // so that most cells have a pixel of their own
    runStudy();
    window.panel().navigator().showSlanting(bounds(window.workbench().study()->settings.region));
    // Distant cells share a pixel, and building edges cover some.
    expectGroundShows(*this, ShadowMeasure::gross, 0.88, 40);
}

TEST_F(WindowTest, OffTheFieldTheGroundIsNeutral) {
    runStudy();
    const ViewBounds bounds = window.panel().view().viewBounds();
    window.panel().navigator().showWholeCity();
    const QPointF pixel = pixelAt({bounds.centre().x, double(bounds.box.low.y) - 0.05 * bounds.radiusM(), 0});
    const QColor colour = colourAt(captured(), pixel);
    ASSERT_TRUE(colour.isValid());
    EXPECT_LT(colour.hsvSaturation(), 25);
    EXPECT_GT(colour.lightness(), 180);
}

TEST_F(WindowTest, LegendIsDrawnWithBothEndsOfThePalette) {
    runStudy();
    const QImage legend = window.panel().legend().grab().toImage();
    int sunny = 0;
    int shaded = 0;
    for (int y = 0; y < legend.height(); ++y)
        for (int x = 0; x < legend.width(); ++x) {
            if (difference(legend.pixelColor(x, y), shadowColour(0.01)) < 4) ++sunny;
            if (difference(legend.pixelColor(x, y), shadowColour(0.99)) < 4) ++shaded;
        }
    EXPECT_GE(sunny, 8);
    EXPECT_GE(shaded, 8);
}

TEST_F(WindowTest, SavedPictureHoldsViewAndLegend) {
    runStudy();
    const QString file = folder.filePath(QStringLiteral("view.png"));
    window.results().savePicture(file);
    ASSERT_TRUE(waitFor([&] { return !window.panel().messages().text().isEmpty(); }));
    const QImage picture(file);
    ASSERT_FALSE(picture.isNull());
    EXPECT_GT(picture.height(), window.panel().view().height());
}

TEST_F(WindowTest, DrawingARegionChangesTheStudyAndCanBeUndone) {
    const Region before = window.workbench().document().settings().region;
    PolygonTool& tool = window.panel().regionTool();
    tool.begin();
    for (const glm::dvec3 corner : {glm::dvec3{0, 0, 0}, {100, 0, 0}, {100, 80, 0}}) tool.addPoint(corner);
    tool.finish();
    EXPECT_EQ(bounds(window.workbench().document().settings().region), (Box2{{0, 0}, {100, 80}}));
    window.workbench().document().undoStack().undo();
    EXPECT_EQ(window.workbench().document().settings().region, before);
}

TEST_F(WindowTest, ALongStudyIsCancelledAndLeavesNoError) {
    StudySettings question = window.workbench().document().settings();
    question.period.days = 365;
    question.receivers.cellM = 0.5;
    window.workbench().document().change(question, QStringLiteral("test"));
    window.workbench().run();
    QSignalSpy failures(&window.workbench(), &Workbench::failed);
    EXPECT_TRUE(window.workbench().running().busy());
    window.workbench().running().cancel();
    ASSERT_TRUE(waitFor([this] { return !window.workbench().running().busy(); }));
    EXPECT_EQ(failures.count(), 0);
    EXPECT_EQ(window.workbench().study(), nullptr);
}

TEST_F(WindowTest, AFileThatIsNotThereIsReportedAndTheCityStays) {
    const auto city = window.workbench().city();
    window.open({QStringLiteral("/no/such/city.gpkg")});
    ASSERT_TRUE(waitFor([this] { return !window.panel().messages().text().isEmpty(); }));
    EXPECT_TRUE(window.panel().messages().text().contains(QStringLiteral("city.gpkg")));
    EXPECT_EQ(window.workbench().city(), city);
}

TEST_F(WindowTest, ClosedWhileAStudyRuns) {
    StudySettings question = window.workbench().document().settings();
    question.period.days = 365;
    window.workbench().document().change(question, QStringLiteral("test"));
    window.saving().setUnsavedQuestion([] { return SavingActions::Unsaved::discard; });
    window.workbench().run();
    EXPECT_TRUE(window.close());
}

TEST_F(WindowTest, LayoutIsKept) {
    window.close();
    EXPECT_FALSE(settings.value(QStringLiteral("docks")).toByteArray().isEmpty());
    MainWindow next(settings);
    EXPECT_TRUE(
        next.restoreState(settings.value(QStringLiteral("docks")).toByteArray(), MainWindow::layoutVersion));
}

}  // namespace
}  // namespace noonmark
