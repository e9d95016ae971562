#include <QApplication>
#include <QStandardPaths>
#include <cstdio>
#include <cstdlib>

#include "app/gui/frame/window_start.h"
#include "app/language/language.h"
#include "tests/golden/window_states.h"

/// Writes what the window says in one state after another into a folder, so that two builds can be compared:
/// a change that is to alter nothing leaves the folders equal.
int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("noonmark_gui_golden FOLDER\n", stderr);
        return 2;
    }
    noonmark::chooseRenderer();
    QApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);  // leaves nothing in the user's folders
    noonmark::applyAppearance(application);
    noonmark::applyLanguage(noonmark::Language::english, application);
    noonmark::golden::WindowStates(QString::fromLocal8Bit(argv[1])).writeAll();
    // Threads of Qt may still run, and crash where libraries are unloaded beneath them.
    std::fflush(nullptr);
    std::_Exit(0);
}
