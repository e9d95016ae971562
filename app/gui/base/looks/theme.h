#pragma once

// How the window looks. This file has the light and the dark palette, the colours of notes and errors in
// either, and the icons of resources/icons in the colours of the palette. application_theme.h keeps the
// application in one of the palettes, as the user or the desktop (theme_source.h) chooses, and draws the
// widgets.

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <functional>

#include "app/report/maps/style.h"

class QLabel;
class QSettings;
class QWidget;

namespace noonmark {

enum class Theme { light, dark };

/// Which theme the user wants.
enum class ThemeChoice { system, light, dark };

/// The theme of a palette: dark where its text is lighter than its windows.
Theme themeOf(const QPalette& palette);
/// The theme that the application shows now.
Theme themeInUse();

QPalette makePalette(Theme theme);

/// The choice saved in the settings; the system's at first.
ThemeChoice readThemeChoice(const QSettings& settings);
void saveThemeChoice(ThemeChoice choice, QSettings& settings);
/// Applies a choice to the whole application, once. `system`: the palette of the desktop. See
/// application_theme.h for a theme that follows the desktop.
void applyTheme(ThemeChoice choice, const QPalette& system);

/// Colours of a bar or label.
struct NoteColours {
    QColor background, border, text;
};
NoteColours noteColours(Theme theme);     ///< of notices
NoteColours errorColours(Theme theme);    ///< of errors
NoteColours warningColours(Theme theme);  ///< of results that are out of date

/// Calls `look` now and whenever the theme changes, as long as the widget lives.
void followTheme(QWidget& widget, std::function<void()> look);

/// The colours of legends and charts.
Inks inksOf(Theme theme);

QColor errorTextColour(Theme theme);  ///< of errors without a background of their own
/// Shows a label's text in that colour.
void showAsError(QLabel& label);

/// The icon of that name in resources/icons, in the colours of the application's palette, at any size and in
/// either theme; greyed where disabled. An unknown name gives an icon without a picture.
QIcon makeIcon(const QString& name);

}  // namespace noonmark
