#include "tests/soak/window_user.h"

#include <QUndoStack>
#include <algorithm>
#include <array>

#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/time/time_strip.h"
#include "tests/gui/wait_for.h"

namespace noonmark::soak {

namespace {

using test::waitFor;

constexpr int frameMs = 16;             // between two movements of a dragging hand
constexpr int longestWaitMs = 900'000;  // for a hang: a loaded machine may take minutes for a study

/// A square of 36 m around `middle`.
Footprint lotAt(glm::dvec2 middle) {
    Footprint lot;
    for (const glm::dvec2 corner : {glm::dvec2{-18, -18}, {18, -18}, {18, 18}, {-18, 18}})
        lot.outer.emplace_back(middle + corner);
    return lot;
}

}  // namespace

WindowUser::WindowUser(const QString& city, unsigned seed)
    : settings_(folder_.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat),
      file_(city),
      random_(seed) {
    settings_.setValue(QStringLiteral("unsavedFolder"), folder_.path());
    window_ = std::make_unique<MainWindow>(settings_);
    window_->saving().setUnsavedQuestion([] { return SavingActions::Unsaved::discard; });
    window_->resize(1200, 800);
    window_->show();
    openAgain();
}

std::string WindowUser::act() {
    struct Choice {
        const char* name;
        Action action;
        int weight;  // relative to a total of 100
    };
    static constexpr std::array choices{
        Choice{"look around", &WindowUser::lookAround, 24},
        Choice{"change the period", &WindowUser::changePeriod, 10},
        Choice{"switch the mode", &WindowUser::switchMode, 8},
        Choice{"study", &WindowUser::study, 8},
        Choice{"cancel a study", &WindowUser::cancelStudy, 5},
        Choice{"look at a time", &WindowUser::lookAtTime, 10},
        Choice{"demolish", &WindowUser::demolish, 5},
        Choice{"design a tower", &WindowUser::designTower, 10},
        Choice{"compare", &WindowUser::compare, 4},
        Choice{"score", &WindowUser::score, 2},
        Choice{"undo and redo", &WindowUser::undoAndRedo, 8},
        Choice{"change the scenario", &WindowUser::changeScenario, 5},
        Choice{"open again", &WindowUser::openAgain, 1},
    };
    int left = chance(100);
    const auto choice =
        std::ranges::find_if(choices, [&](const Choice& c) { return (left -= c.weight) < 0; });
    (this->*choice->action)();
    waitUntilIdle();
    return choice->name;
}

void WindowUser::dragTower(int edits) {
    beginTower();
    for (int edit = 0; edit < edits; ++edit) {
        window_->tools().tower().setHeight(between(20, 300));
        ++liveEdits_;
        QCoreApplication::processEvents(QEventLoop::AllEvents, frameMs);
    }
    waitUntilIdle();
    endTower(chance(8) == 0);
    waitUntilIdle();
}

void WindowUser::lookAround() {
    CameraPose pose = window_->panel().view().pose();
    for (int frame = 0; frame < 10; ++frame) {
        pose.headingDeg += between(-20, 20);
        pose.pitchDeg = std::clamp(pose.pitchDeg + between(-10, 10), 15.0, 90.0);
        pose.distanceM = std::clamp(pose.distanceM * between(0.8, 1.25), 200.0, 4000.0);
        window_->panel().view().setPose(pose);
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    }
}

void WindowUser::changePeriod() {
    StudySettings settings = window_->workbench().document().settings();
    settings.period.start = std::chrono::year(2026) / (1 + chance(12)) / (1 + chance(28));
    settings.period.from = std::chrono::hours(8 + chance(6));
    window_->workbench().document().change(settings, QStringLiteral("period"));
}

void WindowUser::switchMode() {
    window_->mode().setMode(chance(2) == 0 ? ViewMode::exploration : ViewMode::analysis);
}

void WindowUser::startRun() {
    window_->mode().showStudies();
    window_->workbench().run();
}

void WindowUser::study() {
    window_->workbench().session().compareWith({});
    startRun();
}

void WindowUser::cancelStudy() {
    startRun();
    QCoreApplication::processEvents(QEventLoop::AllEvents, 1 + chance(50));
    window_->workbench().running().cancel();
}

void WindowUser::lookAtTime() {
    if (!window_->workbench().study()) study();
    waitUntilIdle();
    for (int step = 0; step < 10; ++step) {
        ShownTime look = window_->panel().time().look();
        look.span = chance(2) == 0 ? ShownSpan::day : ShownSpan::moment;
        look.at = std::chrono::minutes(8 * 60 + chance(9 * 60));
        window_->panel().time().setLook(look);
        Q_EMIT window_->panel().time().lookChanged(look);
        QCoreApplication::processEvents(QEventLoop::AllEvents, 30);
    }
}

void WindowUser::demolish() {
    const auto city = window_->workbench().city();
    window_->tools().building().select(std::uint32_t(chance(int(city->city().buildings.size()))));
    window_->tools().building().demolish();
}

void WindowUser::beginTower() {
    window_->tools().cancel();
    const Box2 region = bounds(window_->workbench().document().settings().region);
    const glm::dvec2 place{between(region.low.x, region.high.x), between(region.low.y, region.high.y)};
    window_->tools().tower().begin({"Soak", lotAt(place)}, {});
}

void WindowUser::endTower(bool build) {
    if (build)
        window_->tools().tower().build();
    else
        window_->tools().tower().cancel();
    window_->tools().cancel();
}

void WindowUser::designTower() {
    beginTower();
    for (int edit = 0; edit < 3; ++edit) {
        window_->tools().tower().setHeight(between(20, 300));
        ++liveEdits_;
        waitUntilIdle();
    }
    endTower(chance(2) == 0);
}

void WindowUser::compare() {
    if (window_->workbench().session().scenario() == existingCity) demolish();
    waitUntilIdle();
    window_->workbench().session().compareWith(existingCity);
    startRun();
}

void WindowUser::score() {
    const auto& tables = window_->workbench().session().project().weights;
    if (!tables.empty()) window_->workbench().runScore(tables.front().name);
}

void WindowUser::undoAndRedo() {
    QUndoStack& stack = window_->workbench().document().undoStack();
    for (int step = chance(6); step >= 0; --step) stack.undo();
    for (int step = chance(4); step >= 0; --step) stack.redo();
}

void WindowUser::changeScenario() {
    const auto& scenarios = window_->workbench().session().project().scenarios;
    const int which = chance(int(scenarios.size()) + 1);
    window_->workbench().session().goTo(which == 0 ? existingCity : scenarios[std::size_t(which) - 1].name);
}

void WindowUser::openAgain() {
    window_->open({file_});
    waitUntilIdle();
}

bool WindowUser::busy() {
    Workbench& bench = window_->workbench();
    return bench.opening().busy() || bench.following().busy() || bench.running().busy() ||
           bench.reading().busy() || window_->exploration().working() ||
           window_->tools().context().preview.working().busy() || !bench.city();
}

void WindowUser::waitUntilIdle() {
    if (!waitFor([this] { return !busy(); }, longestWaitMs)) qFatal("The window does not become idle.");
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
}

}  // namespace noonmark::soak
