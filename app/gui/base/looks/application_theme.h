#pragma once

#include <QPalette>

#include "app/gui/base/looks/theme_source.h"

class QApplication;

namespace noonmark {

/// Keeps the application in the theme that the user chose, or in that of the desktop while it changes: the
/// theme that the desktop states, else that of its palette.
class ApplicationTheme final : public QObject {
    Q_OBJECT
public:
    /// Applies the theme. `system`: the palette before any theme was applied. `desktop` may be null. Belongs
    /// to the application.
    ApplicationTheme(QApplication& application, ThemeChoice choice, const QPalette& system,
                     std::unique_ptr<ThemeSource> desktop);

    void choose(ThemeChoice choice);
    /// That of the application that runs; null if it has none.
    static ApplicationTheme* inUse();

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void apply();
    void readPalette();

    ThemeChoice choice_;
    QPalette system_;
    std::unique_ptr<ThemeSource> desktop_;
    bool paletteChanged_ = false;  // readPalette() is about to be called
};

}  // namespace noonmark
