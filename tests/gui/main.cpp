#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>
#include <cstdio>
#include <cstdlib>

#include "app/gui/frame/window_start.h"
#include "app/language/language.h"

/// Widgets and the 3D view need a display; ctest runs this under Xvfb.
int main(int argc, char** argv) {
    noonmark::chooseRenderer();
    QApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);  // tests leave no files in the user's folders
    noonmark::applyAppearance(application);
    // Tests expect English, whatever the system speaks.
    noonmark::applyLanguage(noonmark::Language::english, application);
    ::testing::InitGoogleTest(&argc, argv);
    const int result = RUN_ALL_TESTS();
    // Threads of Qt may still run, and crash where libraries are unloaded beneath them.
    std::fflush(nullptr);
    std::_Exit(result);
}
