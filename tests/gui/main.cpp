#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>

#include "app/window/frame/appearance.h"

/// Widgets and the 3D view need a display; ctest runs this under Xvfb.
int main(int argc, char** argv) {
    noonmark::chooseRenderer();
    QApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);  // tests leave no files in the user's folders
    noonmark::applyAppearance(application);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
