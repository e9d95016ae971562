#pragma once

#include <QMenu>
#include <QPalette>
#include <QProxyStyle>

#include "app/gui/base/looks/theme_source.h"

class QApplication;
class QSettings;

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

/// The menu of themes: as the system, light, dark. The choice is saved in the settings.
class ThemeMenu final : public QMenu {
    Q_OBJECT
public:
    explicit ThemeMenu(QSettings& settings, QWidget* parent = nullptr);  ///< `settings` must outlive it
};

/// Qt's style Fusion, with what it lacks on dark windows: outlines of check boxes and radio buttons. Buttons
/// of dialogs have no icons, which Fusion draws for light windows only. Names of tabs are never cut.
class WindowStyle final : public QProxyStyle {
    Q_OBJECT
public:
    WindowStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* answer) const override;
};

}  // namespace noonmark
