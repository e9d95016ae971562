#pragma once

#include <QSettings>
#include <QTemporaryDir>
#include <memory>
#include <random>
#include <string>

#include "app/gui/frame/main_window.h"

namespace noonmark::soak {

/// A random user of the window: looks around, changes the period, runs and cancels studies, designs towers,
/// compares, undoes, opens the city again. The sequence follows from a fixed seed.
class WindowUser {
public:
    WindowUser(const QString& city, unsigned seed);

    /// Performs one action and waits until the window is idle. Returns the action's name.
    std::string act();
    /// Begins a tower and drags its height as a hand does, `edits` times without waiting for the shadow of
    /// each, then waits for the last one.
    void dragTower(int edits);
    [[nodiscard]] int liveEdits() const { return liveEdits_; }
    void openAgain();  ///< opens the city as after the start: no scenario, no result, nothing to undo

private:
    using Action = void (WindowUser::*)();
    void lookAround();
    void changePeriod();
    void switchMode();
    void study();
    void cancelStudy();
    void lookAtTime();
    void demolish();
    void designTower();
    void compare();
    void score();
    void undoAndRedo();
    void changeScenario();

    void beginTower();
    void endTower(bool build);
    void startRun();
    void waitUntilIdle();
    [[nodiscard]] bool busy();
    [[nodiscard]] int chance(int below) { return int(random_() % unsigned(below)); }
    [[nodiscard]] double between(double low, double high) {
        return low + (high - low) * double(random_()) / double(std::mt19937::max());
    }

    QTemporaryDir folder_;
    QSettings settings_;
    QString file_;
    std::mt19937 random_;
    std::unique_ptr<MainWindow> window_;
    int liveEdits_ = 0;
};

}  // namespace noonmark::soak
