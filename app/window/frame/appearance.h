#pragma once

class QApplication;

namespace noonmark {

/// Selects Qt3D's OpenGL renderer, which is the faster one on software OpenGL. Call it before QApplication is
/// created.
void chooseRenderer();

/// Sets application name, style and palette: the same light look on every desktop.
void applyAppearance(QApplication& application);

}  // namespace noonmark
