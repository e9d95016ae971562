#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QComboBox>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMouseEvent>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>

#include "app/gui/docks/export/export_dialog.h"
#include "app/gui/docks/review/review_dock.h"
#include "app/gui/frame/main_window.h"
#include "app/gui/view/panel/view_panel.h"
#include "core/samples/sample_city.h"
#include "scenarios/impact/impact_figures.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;
using testing::HasSubstr;

/// A user's whole job, from an empty start to the files, with the mouse and the keys that they would use.
struct WholeJob : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    std::unique_ptr<MainWindow> window;
    QString out = folder.filePath(QStringLiteral("out"));
    QString file = folder.filePath(QStringLiteral("job.noonmark.gpkg"));

    void SetUp() override {
        settings.setValue(QStringLiteral("unsavedFolder"), folder.filePath(QStringLiteral("unsaved")));
        start();
        window->open({QStringLiteral("sample:central-park-south")});
        ASSERT_TRUE(waitFor([this] { return workbench().city() != nullptr; }));
        StudySettings quick = workbench().document().settings();
        quick.receivers.cellM = 5;
        quick.period.stepMinutes = 15;
        quick.period.zone = "America/New_York";
        quick.region = makeRegionFromLocalBox({edge() - glm::vec2(200, 100), edge() + glm::vec2(200, 300)});
        workbench().document().change(quick, QStringLiteral("a quick study"));
    }
    void start() {
        window.reset();
        window = std::make_unique<MainWindow>(settings);
        window->saving().setUnsavedQuestion([] { return SavingActions::Unsaved::discard; });
        window->resize(1100, 800);
        window->show();
    }

    Workbench& workbench() { return window->workbench(); }
    ProjectSession& session() { return workbench().session(); }
    CityView& view() { return window->panel().view(); }
    std::string message() { return window->panel().messages().text().toStdString(); }
    // The southern corner of the park: lawns north of it, streets south of it.
    glm::vec2 edge() {
        return std::ranges::min(centralParkRegion(workbench().city()->city()).polygons.front().outer, {},
                                [](glm::vec2 corner) { return corner.y; });
    }
    void lookDownAt(glm::vec2 middle) { view().setPose({{middle.x, middle.y, 0}, 600, 0, 90}); }

    void send(QEvent::Type type, QPointF pixel, Qt::MouseButtons held) {
        QMouseEvent event(type, pixel, view().mapToGlobal(pixel), Qt::LeftButton, held, Qt::NoModifier);
        QCoreApplication::sendEvent(&view(), &event);
    }
    void click(glm::vec2 ground) {
        const glm::dvec2 pixel = pixelOf(view().pose(), view().lens(), {ground.x, ground.y, 0}).value();
        send(QEvent::MouseMove, {pixel.x, pixel.y}, Qt::NoButton);
        send(QEvent::MouseButtonPress, {pixel.x, pixel.y}, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, {pixel.x, pixel.y}, Qt::NoButton);
    }
    void press(std::initializer_list<Qt::Key> keys) {
        for (const Qt::Key key : keys) {
            QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
            QCoreApplication::sendEvent(&view(), &event);
        }
    }
    void trigger(const char* keys) {
        for (const QMenu* menu : window->menuBar()->findChildren<QMenu*>())
            for (QAction* action : menu->actions())
                if (action->shortcut() == QKeySequence(QLatin1String(keys))) return action->trigger();
        ADD_FAILURE() << "no action for " << keys;
    }
    template <class Field>
    Field& field(const char* name) {
        auto* found = window->findChild<Field*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    void push(const char* name) { field<QPushButton>(name).click(); }
    QString textOf(const char* label) { return field<QLabel>(label).text(); }

    // Draws a square of 30 m with the mouse, by the action of these keys.
    void drawSquare(const char* action, glm::vec2 corner, float sideM) {
        lookDownAt(corner);
        trigger(action);
        for (const glm::vec2 step : {glm::vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}}) click(corner + sideM * step);
        press({Qt::Key_Return});
    }
    void buildTower(glm::vec2 corner) {
        drawSquare("Ctrl+L", corner, 30);
        ASSERT_TRUE(window->tools().tower().active()) << message();
        press({Qt::Key_1, Qt::Key_4, Qt::Key_0, Qt::Key_Return});
        const std::size_t before = workbench().city()->city().buildings.size();
        ASSERT_TRUE(waitFor([this] { return textOf("towerEffect").contains(QStringLiteral("New shadow")); }))
            << textOf("towerEffect").toStdString();
        press({Qt::Key_Return});
        ASSERT_TRUE(waitFor([&] { return workbench().city()->city().buildings.size() == before + 1; }));
    }
    void exportShown() {
        trigger("Ctrl+E");
        writeExport();
    }
    void writeExport() {
        auto* dialog = window->findChild<ExportDialog*>();
        ASSERT_NE(dialog, nullptr) << message();
        dialog->findChild<QLineEdit*>(QStringLiteral("exportFolder"))->setText(out);
        dialog->findChild<QPushButton*>(QStringLiteral("exportWrite"))->click();
        ASSERT_TRUE(waitFor([this] { return !workbench().writing().busy(); }, 240000));
    }
    void saveAndStartAgain() {
        window->saving().saveTo(file.toStdString());
        ASSERT_TRUE(waitFor([this] { return !window->saving().writing().busy(); })) << message();
        start();
        window->open({file});
        ASSERT_TRUE(waitFor([this] { return workbench().city() != nullptr; })) << message();
    }
    QByteArray contentOf(const char* name) const {
        QFile written(out + QLatin1Char('/') + QLatin1String(name));
        EXPECT_TRUE(written.open(QIODevice::ReadOnly)) << name;
        return written.readAll();
    }
    QJsonObject jsonOf(const char* name) const { return QJsonDocument::fromJson(contentOf(name)).object(); }
};

TEST_F(WholeJob, AnArchitectLeavesWithTheMassingAndWhatItChanges) {
    buildTower(edge() + glm::vec2(0, 40));
    EXPECT_NEAR(double(topM(*workbench().city()->city().buildings.back())), 140, 0.05);
    trigger("Ctrl+K");
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }, 240000))
        << message();
    const ChangeFigures gross = computeFigures(workbench().answerAs<ImpactAnswer>()->study.total).gross;
    EXPECT_GT(gross.moreShadowM2, 1000) << "a tower of 140 m on a lawn";
    exportShown();
    EXPECT_TRUE(contentOf("impact.pdf").startsWith("%PDF"));
    EXPECT_FALSE(contentOf("impact.tif").isEmpty());
    EXPECT_NEAR(jsonOf("impact.json")["impact"][0]["gross"]["gained_m2"].toDouble(), gross.moreShadowM2, 1);
    saveAndStartAgain();
    const Building& tower = *workbench().city()->city().buildings.back();
    EXPECT_NEAR(double(topM(tower)), 140, 0.05);
    EXPECT_TRUE(window->tools().tower().designOf(tower)) << "it can be designed further";
}

TEST_F(WholeJob, APlannerLeavesWithTheScoreOfAYear) {
    auto& preset = field<QComboBox>("periodPreset");
    const int year = preset.findText(QStringLiteral("Whole year"));
    ASSERT_GE(year, 0);
    preset.setCurrentIndex(year);
    Q_EMIT preset.activated(year);
    EXPECT_EQ(workbench().document().settings().period.days, 365);
    push("score");
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ScoreAnswer>() != nullptr; }, 240000))
        << message();
    exportShown();
    EXPECT_TRUE(contentOf("score.pdf").startsWith("%PDF"));
    EXPECT_FALSE(contentOf("score.tif").isEmpty());
    EXPECT_EQ(contentOf("score.csv").trimmed().count('\n'), 12) << "a heading and twelve months";
    workbench().saveAnswer(QStringLiteral("Year"));
    ASSERT_TRUE(waitFor([this] { return session().project().results.size() == 1; })) << message();
    saveAndStartAgain();
    EXPECT_EQ(session().project().results.front()->name, "Year");
}

TEST_F(WholeJob, ABoardLeavesWithVerdictsThatCanBeRepeated) {
    drawSquare("Ctrl+Shift+D", edge() + glm::vec2(-20, 120), 60);
    ASSERT_EQ(session().project().places.size(), 2U) << "beside the sample's park";
    buildTower(edge() + glm::vec2(0, 40));
    trigger("Ctrl+Shift+R");
    auto& rule = field<QComboBox>("reviewRule");
    const int ceqr = rule.findData(QStringLiteral("ceqr"));
    ASSERT_GE(ceqr, 0);
    rule.setCurrentIndex(ceqr);
    Q_EMIT rule.activated(ceqr);
    push("runReview");
    ASSERT_TRUE(waitFor([this] { return window->review().shown() != nullptr; }, 240000)) << message();
    const ReviewTotals first = window->review().shown()->study.places.back().totals;
    EXPECT_GT(first.incrementalM2h, 0) << "the shadow reaches the lawn";
    push("exportReview");
    writeExport();
    EXPECT_TRUE(contentOf("sheets.pdf").startsWith("%PDF"));
    saveAndStartAgain();
    window->review().run();
    ASSERT_TRUE(waitFor([this] { return window->review().shown() != nullptr; }, 240000)) << message();
    const ReviewTotals again = window->review().shown()->study.places.back().totals;
    EXPECT_EQ(again.incrementalM2h, first.incrementalM2h) << "the same bits from the saved project";
    EXPECT_EQ(again.scenarioM2h, first.scenarioM2h);
}

}  // namespace
}  // namespace noonmark
