#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>

#include "app/window/frame/appearance.h"

/// Widgets and the 3D view need a display; under ctest Xvfb gives one.
int main(int argc, char** argv) {
    noonmark::chooseRenderer();
    QApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);  // a test leaves nothing in the user's folders
    noonmark::applyAppearance(application);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
