#pragma once

class QApplication;

namespace noonmark {

/// Selects Qt3D's OpenGL renderer, which is the faster one on software OpenGL, and keeps other widgets from
/// covering its window. Call it before QApplication is created.
void chooseRenderer();

/// Sets application name, style, palette, language and units: the same look on every desktop, light or dark
/// as the desktop is while the window is open, or as the user chose.
void applyAppearance(QApplication& application);

}  // namespace noonmark
