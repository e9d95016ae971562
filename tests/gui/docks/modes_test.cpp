#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QToolBar>
#include <random>

#include "app/gui/docks/study_form/accuracy_section.h"
#include "app/gui/frame/main_window.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/time/time_strip.h"
#include "app/report/maps/style.h"
#include "core/lab/lab_engines.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

TEST(ModeSwitch, AStudyLeavesNowAndStaysInReview) {
    ModeSwitch mode;
    EXPECT_EQ(mode.mode(), ViewMode::exploration) << "what a new user sees first";
    mode.showStudies();
    EXPECT_EQ(mode.mode(), ViewMode::analysis);
    mode.setMode(ViewMode::review);
    mode.showStudies();
    EXPECT_EQ(mode.mode(), ViewMode::review);
    EXPECT_TRUE(mode.actions()[2]->isChecked());
    EXPECT_FALSE(mode.actions()[1]->isChecked()) << "one at a time";
}

TEST(ModeSwitch, ModesHaveShortcutsAndSayWhatTheyAre) {
    const ModeSwitch mode;
    ASSERT_EQ(mode.actions().size(), 3);
    EXPECT_EQ(mode.actions()[0]->text(), QStringLiteral("Now"));
    for (const QAction* action : mode.actions()) {
        EXPECT_FALSE(action->shortcut().isEmpty());
        EXPECT_TRUE(action->toolTip().contains(action->shortcut().toString()));
    }
}

TEST(ViewState, AModeOfRaysSavedBeforeIsThatOfStudies) {
    EXPECT_EQ(parseViewState({{"mode", "ray reference"}}).mode, ViewMode::analysis);
    EXPECT_EQ(parseViewState(textsOf({.mode = ViewMode::review})).mode, ViewMode::review);
}

TEST(AccuracyForm, HasAFieldForEveryOptionOfTheEngine) {
    AccuracyForm form;
    for (const auto& [engine, make] : coreAndLabEngines()) {
        StudySettings settings;
        settings.engine = engine.key;
        form.show(settings);
        EXPECT_EQ(form.findChildren<QAbstractSpinBox*>().size() + form.findChildren<QCheckBox*>().size(),
                  qsizetype(engine.options.size()));
        for (const Field& option : engine.options) {
            const auto name = QStringLiteral("option_") + QString::fromStdString(std::string(option.key));
            if (option.kind == ValueKind::yesNo) {
                const auto* check = form.findChild<QCheckBox*>(name);
                ASSERT_NE(check, nullptr) << option.key;
                EXPECT_EQ(Value(check->isChecked()), option.standard) << option.key;
                continue;
            }
            const auto* field = form.findChild<QAbstractSpinBox*>(name);
            ASSERT_NE(field, nullptr) << option.key;
            EXPECT_NEAR(field->property("minimum").toDouble(), option.range->min, 1e-9) << option.key;
            EXPECT_NEAR(field->property("maximum").toDouble(), option.range->max, 1e-9) << option.key;
            EXPECT_NEAR(field->property("value").toDouble(), *asNumber(option.standard), 1e-9) << option.key;
            EXPECT_FALSE(field->toolTip().isEmpty());
        }
        EXPECT_EQ(form.withFields(settings), settings) << engine.key << ": default values are not stored";
    }
}

TEST(AccuracyForm, ASwitchIsACheckBox) {
    AccuracyForm form;
    StudySettings settings;
    settings.engine = "horizon";
    form.show(settings);
    auto* runs = form.findChild<QCheckBox*>(QStringLiteral("option_runs"));
    ASSERT_NE(runs, nullptr);
    EXPECT_TRUE(runs->isChecked());
    EXPECT_TRUE(runs->toolTip().contains(QStringLiteral("gross shadow only"))) << qPrintable(runs->toolTip());
    QSignalSpy edits(&form, &AccuracyForm::edited);
    runs->click();
    EXPECT_EQ(edits.size(), 1);
    EXPECT_EQ(form.withFields(settings).engineSettings, (EngineSettings{{"runs", 0}}));
}

TEST(AccuracyForm, OptionsChangeTheStudyAndGoWithTheirEngine) {
    AccuracyForm form;
    StudySettings settings;
    settings.engine = "iam";
    settings.engineSettings["levels"] = 5;
    form.show(settings);
    auto* levels = form.findChild<QSpinBox*>(QStringLiteral("option_levels"));
    EXPECT_EQ(levels->value(), 5);
    QSignalSpy edits(&form, &AccuracyForm::edited);
    levels->setValue(2);
    ASSERT_EQ(edits.count(), 1);
    EXPECT_EQ(form.withFields(settings).engineSettings, (EngineSettings{{"levels", 2}}));
    settings.engine = "ray";
    settings.engineSettings.clear();
    form.show(settings);
    EXPECT_EQ(form.withFields(settings).engineSettings, EngineSettings{});
}

/// The whole window with the sample.
struct ModesTest : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    MainWindow window{settings};

    void SetUp() override {
        window.resize(900, 640);
        window.show();
        window.open({QStringLiteral("sample:central-park-south")});
        ASSERT_TRUE(waitFor([this] { return window.workbench().city() != nullptr; }));
        ShownTime period = window.panel().time().look();
        period.span = ShownSpan::period;
        window.panel().time().choose(period);
        change([](StudySettings& question) {
            question.period.stepMinutes = 10;
            question.period.zone = "America/New_York";
        });
    }

    template <class Edit>
    void change(Edit edit) {
        StudySettings question = window.workbench().document().settings();
        edit(question);
        window.workbench().document().change(question, QStringLiteral("test"));
    }

    // A ray study that takes many seconds.
    void beginLongStudy() {
        change([](StudySettings& question) {
            question.engine = "ray";
            question.receivers.cellM = 1;
            question.period.stepMinutes = 0.5;
        });
        window.workbench().run();
    }

    bool explored() {
        const auto answer = window.exploration().answer();
        return answer && isFinest(*answer) && !window.exploration().working();
    }

    QString note() { return window.panel().legend().note(); }
    /// The note of a study that is complete: its error, if that was measured, and nothing else.
    bool isNoteOfCompleteStudy() {
        return note().isEmpty() || note().contains(QStringLiteral("Measured error"));
    }

    QImage captured() {
        QImage image;
        window.panel().view().capture([&image](const QImage& made) { image = made; });
        EXPECT_TRUE(waitFor([&image] { return !image.isNull(); }));
        return image;
    }
};

int difference(const QColor& a, const QColor& b) {
    return std::max(
        {std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
}

struct Share {
    int seen = 0;
    int right = 0;
};

// For ground, roofs and facades: how many of the explored samples have the colour of their minutes on screen.
std::array<Share, 3> rightColours(const ExploredView& view, const QImage& image, double top) {
    std::array<Share, 3> shares;
    std::mt19937 random(5);
    for (int i = 0; i < 6000; ++i) {
        const std::size_t point = random() % view.surface->points.size();
        if (view.shadow.grossMin[point] == 0) continue;  // not painted
        const int column = int(view.surface->pixel[point] % std::uint32_t(view.camera.widthPx));
        const int row = int(view.surface->pixel[point] / std::uint32_t(view.camera.widthPx));
        const bool level = view.surface->points.normals[point].z > 0.5F;
        Share& share = shares[!level ? 2U : view.surface->points.positions[point].z > 1 ? 1U : 0U];
        ++share.seen;
        const QColor due = shadowColour(double(view.shadow.grossMin[point]) / top);
        if (difference(image.pixelColor(column, row), due) <= 12) ++share.right;
    }
    return shares;
}

TEST_F(ModesTest, ExplorationColoursGroundRoofsAndFacades) {
    ASSERT_EQ(window.mode().mode(), ViewMode::exploration) << "what a new user sees first";
    window.panel().navigator().showSlanting({{-40, -330}, {60, -250}});
    std::array<Share, 3> shares;
    const bool shown = waitFor([&] {
        if (!explored()) return false;
        const auto answer = window.exploration().answer();
        const double top = window.panel().legend().legend()->scale.top;
        shares = rightColours(answer->view, captured(), top);
        // Building edges, drawn over all faces, and the region's outline cover some samples.
        return std::ranges::all_of(shares,
                                   [](const Share& s) { return s.seen > 200 && s.right > 0.7 * s.seen; });
    });
    EXPECT_TRUE(shown) << shares[0].right << "/" << shares[0].seen << " " << shares[1].right << "/"
                       << shares[1].seen << " " << shares[2].right << "/" << shares[2].seen;
}

TEST_F(ModesTest, ExplorationFollowsTheCamera) {
    ASSERT_TRUE(waitFor([this] { return explored(); }));
    const auto first = window.exploration().answer();  // a finer one may follow it at any time
    const QImage before = captured();
    window.panel().navigator().showSlanting({{-100, -400}, {100, -200}});
    auto second = first;
    ASSERT_TRUE(waitFor([&] {
        second = explored() ? window.exploration().answer() : nullptr;
        return second && second->view.camera.eye != first->view.camera.eye;
    }));
    EXPECT_LT(second->view.sampleM(1), first->view.sampleM(1) * 1.001);
    const QImage after = captured();
    int changed = 0;
    for (int y = 0; y < after.height(); y += 4)
        for (int x = 0; x < after.width(); x += 4)
            if (difference(before.pixelColor(x, y), after.pixelColor(x, y)) > 30) ++changed;
    EXPECT_GT(changed, after.width() * after.height() / 16 / 4);
}

TEST_F(ModesTest, ExplorationSaysItsLevelOfDetail) {
    std::vector<QString> notes;
    QObject listener;
    QObject::connect(&window.exploration(), &Exploration::changed, &listener,
                     [&] { notes.push_back(note()); });
    ASSERT_TRUE(waitFor([this] { return explored(); }));
    const auto told = [&notes](const char* words) {
        return std::ranges::any_of(notes, [&](const QString& n) { return n.contains(QLatin1String(words)); });
    };
    EXPECT_TRUE(told("Refining: a sample every "));
    EXPECT_TRUE(note().startsWith(QStringLiteral("every pixel"))) << note().toStdString();
}

TEST_F(ModesTest, SwitchingShowsWhatBelongsToTheMode) {
    ASSERT_TRUE(waitFor([this] { return explored(); }));
    window.mode().setMode(ViewMode::analysis);
    EXPECT_FALSE(window.panel().legend().legend()) << "no study yet";
    EXPECT_FALSE(window.exploration().working());
    window.workbench().run();
    ASSERT_TRUE(waitFor([this] { return window.workbench().study() != nullptr; }));
    EXPECT_NE(window.workbench().study()->field.engine.find("Projected"), std::string::npos)
        << "exact, and the fastest on flat ground";
    ASSERT_TRUE(window.panel().legend().legend());
    EXPECT_TRUE(isNoteOfCompleteStudy()) << note().toStdString();
    window.mode().setMode(ViewMode::exploration);
    EXPECT_TRUE(note().startsWith(QStringLiteral("every pixel"))) << "the explored view is still available";
    EXPECT_NE(window.findChild<QToolBar*>(QStringLiteral("modeBar")), nullptr);
}

TEST_F(ModesTest, ARunLeavesExploration) {
    window.workbench().run();
    EXPECT_EQ(window.mode().mode(), ViewMode::analysis);
    ASSERT_TRUE(waitFor([this] { return window.workbench().study() != nullptr; }));
}

// A partial result shows its cells in the view, marked as partial.
TEST_F(ModesTest, ALongStudyShowsWhatItHasSoFar) {
    QSignalSpy partials(&window.workbench(), &Workbench::studyPartial);
    beginLongStudy();
    ASSERT_TRUE(waitFor([&] { return note().startsWith(QStringLiteral("So far: ")); }));
    EXPECT_TRUE(note().contains(QStringLiteral("tiles"))) << note().toStdString();
    EXPECT_TRUE(window.panel().legend().legend()) << "colours have their units from the beginning";
    EXPECT_EQ(window.workbench().study(), nullptr);
    ASSERT_TRUE(waitFor([&] { return partials.count() >= 3; }));
    window.workbench().running().cancel();
    ASSERT_TRUE(waitFor([this] { return !window.workbench().running().busy(); }));
    EXPECT_TRUE(note().isEmpty()) << "no partial result stays";
    EXPECT_FALSE(window.panel().legend().legend());
    EXPECT_TRUE(window.panel().messages().text().contains(QStringLiteral("Cancelled")));
}

TEST_F(ModesTest, CancellingBringsTheStudyBeforeBack) {
    window.workbench().run();
    ASSERT_TRUE(waitFor([this] { return window.workbench().study() != nullptr; }));
    const auto before = window.workbench().study();
    const QString legend = window.panel().legend().legend()->title;
    beginLongStudy();
    ASSERT_TRUE(waitFor([&] { return note().startsWith(QStringLiteral("So far: ")); }));
    window.workbench().running().cancel();
    ASSERT_TRUE(waitFor([this] { return !window.workbench().running().busy(); }));
    EXPECT_EQ(window.workbench().study(), before);
    EXPECT_TRUE(isNoteOfCompleteStudy()) << note().toStdString();
    ASSERT_TRUE(window.panel().legend().legend());
    EXPECT_EQ(window.panel().legend().legend()->title, legend);
}

TEST_F(ModesTest, ANewerRunOvertakesAnOlderOne) {
    beginLongStudy();
    ASSERT_TRUE(waitFor([&] { return note().startsWith(QStringLiteral("So far: ")); }));
    change([](StudySettings& question) {
        question.engine = "projected";
        question.receivers.cellM = 5;
        question.period.stepMinutes = 30;
    });
    QSignalSpy failures(&window.workbench(), &Workbench::failed);
    window.workbench().run();
    ASSERT_TRUE(waitFor([this] { return window.workbench().study() != nullptr; }));
    EXPECT_EQ(window.workbench().study()->settings.receivers.cellM, 5);
    EXPECT_TRUE(isNoteOfCompleteStudy()) << note().toStdString() << ": the older run delivers nothing";
    waitFor([] { return false; }, 300);
    EXPECT_TRUE(isNoteOfCompleteStudy()) << note().toStdString();
    EXPECT_EQ(window.workbench().study()->settings.receivers.cellM, 5);
    EXPECT_EQ(failures.count(), 0);
}

}  // namespace
}  // namespace noonmark
